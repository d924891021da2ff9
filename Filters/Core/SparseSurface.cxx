// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/SparseSurface.h"

#include "Core/Base/EditContours.h"
#include "Core/FieldTopology.h"
#include "Core/MakeSurface.h"
#include "Core/PredictSlices.h"
#include "Core/RealSlices.h"
#include "Core/SecondPass.h"
#include "Core/Slices/EndSlices.h"
#include "Core/Sparse/FieldSlices.h"
#include "Core/Sparse/SelectContours.h"
#include "Core/Sparse/VirtualSlices.h"
#include "Core/Surface/TotalCurvature.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <optional>

namespace orthoslices
{
namespace
{
/// What the second pass adds to the slices, and what has to come of it.
struct SecondSurface
{
  Contours Added; ///< virtual ones
  PriorKnowledge Known;
  std::function<bool(const SurfaceTopology&)> IsRight;
  Box3 Bounds;                       ///< of the surface, besides those of the grid
  std::vector<std::uint8_t> Guiding; ///< see Reconstruction
  int Attempts = 1;
  /// If surfaces that are not right may be of use, too: of the same components, and about as many
  /// handles.
  std::optional<SurfaceTopology> Like{};
};

/// The surface of a stack with slices across, if it is not at once the right one.
struct StackSurface
{
  Reconstruction Result;
  Index Handles; ///< more or less than those of the stack alone
};

/// A surface with other handles than it should have is better only if it has less than that share of
/// another one's TotalCurvature: notches and folds show in that.
constexpr double ShareOfFairer = 0.9;

/// How many components have contours across an axis: those with node points, and with isolated
/// contours of the other families.
Index CountAcross(int axis, const NodeGraph& graph)
{
  std::vector<std::uint8_t> isAcross(graph.Components, 0);
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    isAcross[graph.Component[node]] = 1;
  }
  for (std::size_t loop = 0; loop < graph.Loops.size(); ++loop)
  {
    isAcross[graph.Component[graph.Nodes + loop]] |= graph.Loops[loop].Axis != axis ? 1 : 0;
  }
  return static_cast<Index>(std::count(isAcross.begin(), isAcross.end(), 1));
}

double CurvatureOf(const Reconstruction& result, const Execution& execution)
{
  return TotalCurvature(ListTriangles(GeometryOf(result), result.Surface, execution));
}

/// Runs the passes; see MakeSparseSurface.
class SparseRunner
{
public:
  SparseRunner(const SparseSlices& sparse, Pass& first)
    : Sparse(sparse)
    , First(first)
    , Drawn(first.Tables.Contours)
  {
  }

  bool Run();

private:
  bool FillFirst();
  bool BendStack();
  bool BendAll();
  bool Bend(const Reconstruction& base, GuideCurves&& guides);
  bool SketchWithoutField(Pass& pass) const;
  bool FollowField();
  Index MostComponents();
  bool SketchAndBend();
  void KeepNearest(Reconstruction&& result, Index handles);
  void TakeFairer();
  bool RunAgain(SecondSurface&& second);
  bool Stop();

  const SparseSlices& Sparse;
  Pass& First;
  Contours Drawn;              ///< as they are before the first pass
  std::vector<double> Centers; ///< of the first surface, as they are before its sketch, if any
  std::optional<StackSurface> OfStack;
};

bool SparseRunner::Stop()
{
  this->First.Result.Stopped = true;
  return false;
}

/// Makes the first surface the one that is wanted.
bool SparseRunner::FillFirst()
{
  if (!this->Centers.empty())
  {
    this->First.Result.Surface.CentralPoints.swap(this->Centers);
  }
  this->First.SetShare(ProgressOfBending, 1.0);
  return FillCycles(this->First.Settings.Patching, this->First);
}

/// False if there is no stack with slices across, or no surface from it.
bool SparseRunner::BendStack()
{
  const int axis = this->Sparse.Bending.StackAxis();
  if (axis < 0)
  {
    return false;
  }
  Pass stack(this->First, SelectAxis(this->Drawn, axis, true));
  stack.SetShare(ProgressOfSketch, ProgressOfStack);
  if (!ConnectContours(stack) || !Sketch(this->Sparse.EdgeLength(), stack))
  {
    return this->Stop();
  }
  GuideCurves guides = CutGuides(this->Drawn, this->First.Result.Grid, axis);
  if (this->First.Settings.Guides != nullptr)
  {
    AddGuides(*this->First.Settings.Guides, guides);
  }
  return this->Bend(stack.Result, std::move(guides));
}

/// The surface of all slices bends, through the contours on planes of no family if it comes out
/// with its topology so. Such planes are nearly parallel to a single family, and say nothing beside
/// it.
bool SparseRunner::BendAll()
{
  const std::vector<GuideContours>* others = this->First.Settings.Guides;
  const auto& planes = this->First.Result.Grid.Planes;
  if (others != nullptr && !others->empty() && FindOnlyFamily(this->First.Result.Grid) < 0)
  {
    GuideCurves guides;
    guides.Planes = planes;
    AddGuides(*others, guides);
    if (this->Bend(this->First.Result, std::move(guides)))
    {
      return true;
    }
  }
  GuideCurves ends;
  ends.HalfSliceEnds = this->First.Settings.Ends == EndCaps::HalfSlice;
  return !this->First.Result.Stopped && this->Bend(this->First.Result, std::move(ends));
}

/// Which of the planes of no family guide, which are the last of all guides.
std::vector<std::uint8_t> ListGuiding(const Options& settings, const GuideCurves& guides)
{
  std::vector<std::uint8_t> guiding;
  if (settings.Guides != nullptr && guides.Slices.size() >= settings.Guides->size())
  {
    for (std::size_t i = guides.Slices.size() - settings.Guides->size(); i < guides.Slices.size();
         ++i)
    {
      guiding.push_back(guides.Slices[i].Guiding > 0 ? 1 : 0);
    }
  }
  return guiding;
}

/// A field goes through all of them that have contours.
std::vector<std::uint8_t> ListGuiding(const Options& settings)
{
  std::vector<std::uint8_t> guiding;
  for (std::size_t i = 0; settings.Guides != nullptr && i < settings.Guides->size(); ++i)
  {
    guiding.push_back((*settings.Guides)[i].Loops.empty() ? 0 : 1);
  }
  return guiding;
}

/// Where a stack ends flat with all that lies on its first or on its last slice: bounds close to
/// it, so that smooth patches between virtual slices do not bulge there.
Box3 FlatEndsOf(const Reconstruction& base)
{
  Box3 bounds = Everywhere();
  const int axis = FindOnlyFamily(base.Grid);
  if (axis < 0 || base.Grid.Count(axis) < 2)
  {
    return bounds;
  }
  const double first = base.Grid.Planes[axis].front(), last = base.Grid.Planes[axis].back();
  double below = 0.0, above = 0.0;
  const auto add = [&](double coordinate)
  {
    below = std::max(below, first - coordinate);
    above = std::max(above, coordinate - last);
  };
  for (const std::vector<double>* points :
    { &base.Surface.CentralPoints, &base.Surface.Inner.Points })
  {
    for (std::size_t i = axis; i < points->size(); i += 3)
    {
      add((*points)[i]);
    }
  }
  for (const PatchMesh& mesh : base.Surface.Meshes)
  {
    for (const Point3& point : mesh.Points)
    {
      add(point[axis]);
    }
  }
  const double flat = FlatShare * base.Grid.MeanSpacing(axis);
  bounds.Low[axis] = below < flat ? first - 2.0 * below : bounds.Low[axis];
  bounds.High[axis] = above < flat ? last + 2.0 * above : bounds.High[axis];
  return bounds;
}

/// Makes the surface of real and virtual slices, of all or of those that agree with the real ones,
/// and takes it if its topology is right.
bool SparseRunner::RunAgain(SecondSurface&& second)
{
  Reconstruction& first = this->First.Result;
  for (int attempt = 0; attempt < second.Attempts; ++attempt)
  {
    if (first.Stopped || second.Added.Count() == 0)
    {
      return false;
    }
    std::vector<Index> leftOut;
    Pass again = SecondPass(this->First, this->Drawn, second.Added, second.Known, leftOut);
    LimitBoundsTo(second.Bounds, again.Result.Grid);
    if (attempt > 0)
    {
      again.SetShare(1.0, 1.0); // further attempts are not foreseen in the progress
    }
    if (!ConnectContours(again) || !FillCycles(again.Settings.Patching, again))
    {
      return this->Stop();
    }
    const SurfaceTopology found = again.Result.Topology;
    const bool isRight = second.IsRight(found), isTaken = isRight && !(second.Like && attempt > 0);
    const bool goesOn = !isRight && RemoveMended(again.OfVirtual, again.Result.Grid, second.Added);
    const bool isLike = second.Like && found.Components == second.Like->Components;
    if (isTaken || isLike)
    {
      TakeReport(first, leftOut, again.Result);
      again.Result.Guiding = second.Guiding;
    }
    if (isTaken)
    {
      first = std::move(again.Result);
      return true;
    }
    if (isLike)
    {
      this->KeepNearest(std::move(again.Result), std::abs(found.Genus - second.Like->Genus));
    }
    if (!goesOn)
    {
      return false;
    }
  }
  return false;
}

/// Keeps the surface that has the least handles more or less than the stack.
void SparseRunner::KeepNearest(Reconstruction&& result, Index handles)
{
  if (!this->OfStack || handles < this->OfStack->Handles)
  {
    this->OfStack = { std::move(result), handles };
  }
}

/// Makes the surface anew, with virtual slices of `base` that bends through the guides: with all of
/// them, or those that agree with the real slices. False if there are none, or if the topology
/// comes out another than that of `base`.
bool SparseRunner::Bend(const Reconstruction& base, GuideCurves&& guides)
{
  Execution execution = this->First.Execute;
  execution.Continue = [this](double progress) { return this->First.GoOn(progress); };
  const Contours added =
    MakeVirtualSlices({ GeometryOf(base), base.Surface, this->First.Result.Grid, guides,
                        this->First.Settings.Patching.CornerAngle },
      this->Sparse.Bending, execution);
  const SurfaceTopology wanted = base.Topology;
  std::optional<SurfaceTopology> like;
  const PriorKnowledge& expected = this->First.Settings.Known;
  const bool isOfStack = &base != &this->First.Result;
  if (isOfStack && expected.Components <= 0 && expected.Genus < 0 &&
    wanted.Components == this->First.Result.Topology.Components)
  {
    like = wanted;
  }
  // Without planes on which arcs were drawn anew, and then without those on which any were mended.
  // But that a stack hangs together otherwise than all slices together do shall not be made to
  // work.
  const int attempts = guides.Slices.empty() || like ? 3 : 1;
  return this->RunAgain(
    { added, TopologyOf(base), [&](const SurfaceTopology& found) { return found == wanted; },
      guides.Slices.empty() ? FlatEndsOf(base) : Everywhere(),
      ListGuiding(this->First.Settings, guides), attempts, like });
}

/// The surface of some of the contours that there would be if there were no field.
bool SparseRunner::SketchWithoutField(Pass& pass) const
{
  SparseSlices sparse(pass);
  sparse.Field = {};
  sparse.Bending.Coarsen();
  if (!sparse.Any())
  {
    return ConnectContours(pass) && Sketch(this->Sparse.EdgeLength(), pass);
  }
  double& edge = pass.Settings.Patching.EdgeLength;
  edge = std::max(edge, sparse.EdgeLength() / MinMeanSpacing(pass.Result.Grid));
  return SparseRunner(sparse, pass).Run();
}

/// Makes the surface anew, with virtual slices of a field through all contours. That decides what
/// the contours leave open, but not against them: what the first surface joins stays joined, and
/// tunnels come in only where slices agree, if the field foretells them as well, and if one of
/// those that were left out lay between others. False if what there is without a field foretells
/// slices better, or leaves components out.
bool SparseRunner::FollowField()
{
  constexpr double asGood = 0.9;
  // A surface that was bent is as smooth as a field; patches within cells are not.
  const double enough = this->Sparse.Bending.IsSparse() ? 1.05 : 0.75;
  const Pass& first = this->First;
  if (first.Result.SmallComponents > 0)
  {
    return false; // a field goes through the contours of those that are left out, too
  }
  const std::vector<WorldLoop> loops = ListLoops(this->Drawn, first);
  const double step = SampleStep(loops, this->Sparse.EdgeLength());
  this->First.SetShare(ProgressOfCells, ProgressOfPredictions);
  const double patchesByField = ComparePredictions(
    this->Drawn, this->First, step, [this](Pass& pass) { return this->SketchWithoutField(pass); });
  this->First.SetShare(ProgressOfPredictions, ProgressOfBending);
  if (patchesByField < enough || !this->First.GoOn(0.0))
  {
    return false;
  }
  const SliceField field(SampleLoops(loops, step), first.Execute);
  if (!field.IsSolved() || !this->First.GoOn(0.8))
  {
    return false;
  }
  const Contours added = CutField(field, first.Result.Grid, this->Sparse.Field, first.Execute);
  const bool mayAdd =
    patchesByField >= asGood && DoSlicesAgree(first.Result) && MostPlanes(first.Result.Grid) > 2;
  const FieldTopology right(first, mayAdd);
  const Index most = this->MostComponents();
  PriorKnowledge known = right.Known();
  known.Components = std::min(known.Components, most); // joined where it is undecided
  return this->First.GoOn(1.0) &&
    this->RunAgain({ added, known,
      [&](const SurfaceTopology& found) { return right(found) && found.Components <= most; },
      Everywhere(), ListGuiding(first.Settings) });
}

/// A stack with slices across hangs together as the stack alone does, as far as the slices across do
/// not show parts: cells that are far longer than wide may fall to pieces.
Index SparseRunner::MostComponents()
{
  const int axis = this->Sparse.Bending.StackAxis();
  if (axis < 0 || this->First.Settings.Known.Components > 0)
  {
    return std::numeric_limits<Index>::max();
  }
  Pass stack(this->First, SelectAxis(this->Drawn, axis, true));
  stack.SetShare(ProgressOfPredictions, ProgressOfPredictions);
  if (!ConnectContours(stack))
  {
    this->Stop();
  }
  return std::max(stack.Result.Topology.Components, CountAcross(axis, this->First.Result.Graph));
}

/// Bends what is made of a stack or of all slices. False if nothing comes of that.
bool SparseRunner::SketchAndBend()
{
  this->Centers = this->First.Result.Surface.CentralPoints;
  this->First.SetShare(ProgressOfPredictions, ProgressOfSketch);
  if (!Sketch(this->Sparse.EdgeLength(), this->First))
  {
    return false;
  }
  this->First.SetShare(ProgressOfSketch, ProgressOfBending);
  if (this->BendStack())
  {
    return true;
  }
  Reconstruction& result = this->First.Result;
  bool isDone = !result.Stopped && this->BendAll();
  if (this->OfStack && !result.Stopped)
  {
    isDone = isDone || this->FillFirst();
    this->TakeFairer();
  }
  return isDone;
}

/// Takes the surface of the stack in place of one that is rougher: there slices had nothing in common
/// to bend between.
void SparseRunner::TakeFairer()
{
  Reconstruction& result = this->First.Result;
  const double share = this->OfStack->Handles == 0 ? 1.0 : ShareOfFairer;
  if (!result.Stopped &&
    CurvatureOf(this->OfStack->Result, this->First.Execute) <
      share * CurvatureOf(result, this->First.Execute))
  {
    result = std::move(this->OfStack->Result);
  }
}

bool SparseRunner::Run()
{
  this->First.SetShare(ProgressOfSlices, ProgressOfCells);
  if (!ConnectContours(this->First))
  {
    return false;
  }
  const Reconstruction& result = this->First.Result;
  const bool isDone = (this->Sparse.Field.IsSparse() && this->FollowField()) ||
    (!result.Stopped && this->Sparse.Bending.IsSparse() && this->SketchAndBend());
  return !result.Stopped && (isDone || this->FillFirst());
}
}

SparseSlices::SparseSlices(const Pass& pass)
{
  const Options& options = pass.Settings;
  if (options.Virtual == VirtualSlices::Off || pass.Result.InsideOut)
  {
    return;
  }
  const double spacing = options.Virtual == VirtualSlices::BySpacing ? options.VirtualSpacing : 0.0;
  const Box3 box = BoxOf(pass.Tables.Contours);
  this->Bending = { pass.Result.Grid, box, spacing };
  if (options.FollowField)
  {
    this->Field = { pass.Result.Grid, box, spacing, SparseRule::Field };
  }
}

bool MakeSparseSurface(const SparseSlices& sparse, Pass& pass)
{
  return SparseRunner(sparse, pass).Run();
}
}
