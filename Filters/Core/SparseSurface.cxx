// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/SparseSurface.h"

#include "Core/MakeSurface.h"
#include "Core/RealSlices.h"
#include "Core/Slices/EndSlices.h"
#include "Core/Sparse/SelectContours.h"
#include "Core/Sparse/VirtualSlices.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Runs the passes; see MakeSparseSurface.
class SparseRunner
{
public:
  SparseRunner(const SliceDensity& density, Pass& first)
    : Density(density)
    , First(first)
    , Drawn(first.Tables.Contours)
  {
  }

  bool Run();

private:
  bool Sketch(Pass& pass) const;
  bool FillFirst();
  bool BendStack();
  bool BendAll();
  bool Bend(const Reconstruction& base, GuideCurves&& guides);
  bool Stop();

  const SliceDensity& Density;
  Pass& First;
  Contours Drawn;              ///< as they are before the first pass
  std::vector<double> Centers; ///< the central points of the first surface before its sketch
};

bool SparseRunner::Stop()
{
  this->First.Result.Stopped = true;
  return false;
}

/// A surface that shows the topology and is going to be bent: with no more triangles than that needs.
bool SparseRunner::Sketch(Pass& pass) const
{
  PatchOptions patching = pass.Settings.Patching;
  patching.EdgeLength =
    std::max(patching.EdgeLength, this->Density.EdgeLength() / MinMeanSpacing(pass.Result.Grid));
  patching.Shared = nullptr;
  return FillCycles(patching, pass);
}

/// Makes the sketch of the first surface the surface that is wanted.
bool SparseRunner::FillFirst()
{
  this->First.Result.Surface.CentralPoints.swap(this->Centers);
  this->First.SetShare(0.0, 1.0);
  return FillCycles(this->First.Settings.Patching, this->First);
}

/// False if there is no stack with slices across, or no surface from it.
bool SparseRunner::BendStack()
{
  const int axis = this->Density.StackAxis();
  if (axis < 0)
  {
    return false;
  }
  Pass stack(this->First, SelectAxis(this->Drawn, axis, true));
  stack.SetShare(0.485, 0.5);
  if (!ConnectContours(stack) || !this->Sketch(stack))
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

/// The surface of all slices bends, through the contours on planes of no family if it comes out with its
/// topology so. Such planes are nearly parallel to a single family, and say nothing beside it.
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

/// What a second surface has to come out as. Components that were too small are drawn nevertheless,
/// and must not be joined to others instead.
PriorKnowledge TopologyOf(const Reconstruction& base)
{
  const Index small = base.SmallComponents;
  return { base.Topology.Components + small, small > 0 ? -1 : base.Topology.Genus };
}

/// Where a stack ends flat with all that lies on its first or on its last slice: bounds close to it, so that
/// smooth patches between virtual slices do not bulge there.
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

/// Makes the surface anew, with virtual slices of `base` that bends through the guides. False if
/// there are none, or if the topology comes out another than that of `base`.
bool SparseRunner::Bend(const Reconstruction& base, GuideCurves&& guides)
{
  Reconstruction& first = this->First.Result;
  Execution execution = this->First.Execute;
  execution.Continue = [this](double progress) { return this->First.GoOn(progress); };
  const Contours added = MakeVirtualSlices(
    { GeometryOf(base), base.Surface, first.Grid, guides }, this->Density, execution);
  if (first.Stopped || added.Count() == 0)
  {
    return false;
  }
  const std::vector<IsolatedLoop>& parts = this->First.Tables.IsolatedParts;
  const std::vector<Index> leftOut = FindLeftOut(first.Isolated, parts);
  Contours contours = this->Drawn;
  RemoveContours(leftOut, parts, contours);
  AddVirtual(added, contours);
  Pass again(this->First, std::move(contours));
  if (guides.Slices.empty())
  {
    LimitBoundsTo(FlatEndsOf(base), again.Result.Grid);
  }
  again.Settings.Known = TopologyOf(base);
  again.SetShare(0.48, 0.88); // 0.5 to 0.8 of it is 0.68 to 0.8 of the whole
  if (!ConnectContours(again) || !FillCycles(again.Settings.Patching, again))
  {
    return this->Stop();
  }
  if (!(again.Result.Topology == base.Topology))
  {
    return false;
  }
  TakeReport(first, leftOut, again.Result);
  again.Result.Guiding = ListGuiding(this->First.Settings, guides);
  first = std::move(again.Result);
  return true;
}

bool SparseRunner::Run()
{
  // Two surfaces are made: 0.35 to 0.8 of the first one is 0.35 to 0.485 of the whole.
  this->First.SetShare(0.245, 0.545);
  if (!ConnectContours(this->First))
  {
    return false;
  }
  this->Centers = this->First.Result.Surface.CentralPoints;
  if (!this->Sketch(this->First))
  {
    return false;
  }
  this->First.SetShare(0.5, 0.66);
  const Reconstruction& result = this->First.Result;
  const bool isDone = this->BendStack() || (!result.Stopped && this->BendAll());
  return !result.Stopped && (isDone || this->FillFirst());
}
}

bool MakeSparseSurface(const SliceDensity& density, Pass& pass)
{
  return SparseRunner(density, pass).Run();
}
}
