// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LabelRunner.h"

#include "Core/Base/EditContours.h"
#include "Core/Labels/SliceMembers.h"
#include "Core/MakeSurface.h"
#include "Core/PredictSlices.h"
#include "Core/SecondPass.h"
#include "Core/Sparse/InterpolatePolygon.h"

#include <algorithm>
#include <iterator>

/// The part of LabelRunner for slices that are sparse.
namespace orthoslices
{
namespace
{
/// How far a virtual plane is moved at most to get off the vertices of contours, in its distance to
/// the next one.
constexpr double LargestShift = 0.02;

/// A vertex so near to a plane is on it, in the same measure: turned contours are rounded.
constexpr double OnPlane = 1e-6;

/// Appends the coordinates along an axis of all vertices of contours that lie across others.
void AddCoordinates(const Contours& contours, int axis, std::vector<double>& coordinates)
{
  for (Index i = 0; i < contours.Count(); ++i)
  {
    if (contours.Axis[i] != axis)
    {
      const std::vector<double>& of = FirstAxis(contours.Axis[i]) == axis ? contours.U : contours.V;
      coordinates.insert(
        coordinates.end(), of.begin() + contours.Offsets[i], of.begin() + contours.Offsets[i + 1]);
    }
  }
}
}

/**
 * Moves virtual planes off the vertices of real contours. Where sides of contours lie on a plane,
 * as those of stairs do, each label would leave it by the side that suits it, and borders would be
 * common no more.
 */
void LabelRunner::MoveOffVertices(const SpatialGrid& grid, VirtualPlanes& planes) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> vertices;
    for (const LabelPass& pass : this->Passes)
    {
      AddCoordinates(pass.Stages.Tables.Contours, axis, vertices);
    }
    std::sort(vertices.begin(), vertices.end());
    std::vector<double> all(this->Planes[axis]);
    all.insert(all.end(), planes[axis].begin(), planes[axis].end());
    std::sort(all.begin(), all.end());
    for (double& plane : planes[axis])
    {
      const auto next = std::upper_bound(all.begin(), all.end(), plane);
      if (next == all.end())
      {
        continue;
      }
      const double on = OnPlane * (*next - plane);
      const auto at = std::lower_bound(vertices.begin(), vertices.end(), plane - on);
      const auto beyond = std::upper_bound(at, vertices.end(), plane + on);
      if (at != beyond && beyond != vertices.end())
      {
        plane =
          grid.Round(plane + std::min(0.5 * (*beyond - plane), LargestShift * (*next - plane)));
      }
    }
  }
}

/**
 * Takes out holes that are thinner than slivers: where labels were made to agree, or were rounded,
 * each by itself, some are left between them. Whatever is made of all contours, such as a field,
 * would take them for places where there is nothing.
 */
void LabelRunner::RemoveThinHoles(double thickness, Contours& contours)
{
  std::vector<std::uint8_t> isThin;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    const double twiceArea = TwiceSignedArea(contours, i);
    isThin.push_back(
      twiceArea <= 0.0 && -twiceArea < thickness * LengthOf(PolygonOf(contours, i)) ? 1 : 0);
  }
  RemoveMarked(isThin, contours);
}

/// What all labels cover together, as one structure more.
LabelPass& LabelRunner::AddUnion()
{
  RemoveThinHoles(this->Thickness(), this->Borders.Union);
  this->Passes.emplace_back(this->Settings, this->Execute);
  LabelPass& all = this->Passes.back();
  all.IsRead = true;
  all.Stages.Tables.Tolerance = this->Passes.front().Stages.Tables.Tolerance;
  all.Stages.Tables.Contours = this->Borders.Union;
  all.Stages.BuildGrid();
  return all;
}

/// The planes on which a label is cut: those of all that it has not itself.
VirtualPlanes LabelRunner::PlanesFor(const SpatialGrid& grid, const VirtualPlanes& common) const
{
  VirtualPlanes planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> others;
    std::set_difference(this->Planes[axis].begin(), this->Planes[axis].end(),
      grid.Planes[axis].begin(), grid.Planes[axis].end(), std::back_inserter(others));
    std::merge(others.begin(), others.end(), common[axis].begin(), common[axis].end(),
      std::back_inserter(planes[axis]));
  }
  return planes;
}

/// Virtual slices of all labels divide what all cover together as the real ones do. The union of
/// all is the first one, if it is there.
void LabelRunner::ShareVirtual(const std::vector<LabelPass*>& passes, bool withUnion)
{
  std::vector<Contours*> contours;
  for (LabelPass* pass : passes)
  {
    Contours& drawn = pass->Sparse->Virtual;
    drawn.Plane.assign(drawn.Count(), 0); // to be found with those of the real slices
    contours.push_back(&drawn);
  }
  StructureSets allowed{ {} };
  for (const std::vector<Index>& set : this->Borders.Sets)
  {
    std::vector<Index> members;
    for (const Index label : set)
    {
      members.push_back(withUnion ? label + 1 : label);
    }
    if (withUnion && !set.empty())
    {
      members.insert(members.begin(), 0);
    }
    allowed.insert(members);
  }
  // Once slices agree, nothing is moved any more where borders are close: that would move vertices
  // off the places where real slices have them, and slices would be made to agree by other ways for
  // each label.
  const double thickness = withUnion ? this->Thickness() : 0.0;
  const SharedBorders shared = ShareBorders(thickness, allowed, this->Execute, contours);
  this->AddJunctions(shared.Junctions);
}

/// Whether a field through a few slices of all labels together foretells slices that are left out
/// about as well as patches do; see MakeSparseSurface.
bool LabelRunner::FollowsField(const SliceDensity& density, LabelPass& all)
{
  constexpr double enough = 0.75;
  if (!density.IsOfField() || !this->Settings.FollowField)
  {
    return false;
  }
  const Contours& drawn = all.Stages.Tables.Contours;
  const double step = SampleStep(ListLoops(drawn, all.Stages), density.EdgeLength());
  all.Stages.SetShare(0.0, 0.0);
  const auto sketch = [&density](Pass& pass)
  { return ConnectContours(pass) && Sketch(density.EdgeLength(), pass); };
  return ComparePredictions(drawn, all.Stages, step, sketch) >= enough;
}

/// All labels with virtual slices on the same planes.
bool LabelRunner::MakeSparse(const SliceDensity& density)
{
  LabelPass& all = this->AddUnion();
  const SpatialGrid& grid = all.Stages.Result.Grid;
  VirtualPlanes common = ChooseVirtualPlanes(grid, { grid.Lowest, grid.Highest }, density);
  this->MoveOffVertices(grid, common);
  std::deque<VirtualPlanes> planes;
  std::vector<LabelPass*> passes{ &all };
  for (LabelPass& pass : this->Passes)
  {
    if (pass.IsRead && &pass != &all)
    {
      passes.push_back(&pass);
    }
  }
  if (this->Settings.Ends == EndCaps::HalfSlice)
  {
    for (LabelPass* pass : passes)
    {
      pass->Stages.AddEndSlices();
    }
    this->FindPlanes();
  }
  all.SetProgress(ProgressOfReading, ProgressOfReading, 0, 1);
  const bool followsField = this->FollowsField(density, all);
  for (std::size_t i = 0; i < passes.size(); ++i)
  {
    LabelPass* pass = passes[i];
    pass->SetProgress(ProgressOfReading, ProgressOfDrawing, i, passes.size());
    planes.push_back(this->PlanesFor(pass->Stages.Result.Grid, common));
    pass->Sparse = std::make_unique<SparseStructure>(density, planes.back(), pass->Stages);
    pass->Sparse->FollowsField = followsField;
    if (all.Stages.Result.Stopped || !pass->Sparse->Draw())
    {
      return false;
    }
  }
  this->ShareVirtual(passes, true);
  this->AddPlanes(common);
  passes.erase(passes.begin());
  return this->FinishSparse(passes);
}

/// The planes on which no label is drawn.
VirtualPlanes LabelRunner::ListVirtualPlanes(const std::vector<LabelPass*>& passes) const
{
  VirtualPlanes found = this->Planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const LabelPass* pass : passes)
    {
      const SpatialGrid& grid = pass->Stages.Result.Grid;
      const auto isDrawn = [&](double plane)
      {
        const Index own = grid.FindPlane(axis, plane);
        return own >= 0 && !grid.IsVirtual(axis, own);
      };
      found[axis].erase(
        std::remove_if(found[axis].begin(), found[axis].end(), isDrawn), found[axis].end());
    }
  }
  return found;
}

/// The second surfaces of all labels, from virtual slices on which all slices and labels agree.
bool LabelRunner::FinishSparse(const std::vector<LabelPass*>& passes)
{
  std::deque<Contours> slices;
  std::vector<Contours*> labels;
  for (LabelPass* pass : passes)
  {
    pass->SetProgress(ProgressOfDrawing, ProgressOfDrawing, 0, 1);
    pass->Stages.SetOtherPlanes(this->Planes, EmptyPlanes::All);
    slices.push_back(pass->Sparse->ListSlices());
    labels.push_back(&slices.back());
  }
  if (!this->VoteTogether(this->ListVirtualPlanes(passes), labels) && this->IsStopped())
  {
    return false;
  }
  for (std::size_t i = 0; i < passes.size(); ++i)
  {
    passes[i]->Sparse->TakeVirtual(std::move(slices[i]));
  }
  this->ShareVirtual(passes, false);
  // What the last rounding changes, each label follows by itself.
  for (LabelPass* pass : passes)
  {
    if (!pass->Sparse->Redraw())
    {
      return false;
    }
  }
  this->ShareVirtual(passes, false);
  std::vector<Pass*> toDraw;
  for (LabelPass* pass : passes)
  {
    toDraw.push_back(&pass->Sparse->StartAgain());
  }
  if (!this->DrawGraphs(toDraw))
  {
    return false;
  }
  std::vector<Pass*> toFill;
  for (std::size_t i = 0; i < passes.size(); ++i)
  {
    passes[i]->SetProgress(ProgressOfDrawing, this->EndOfFilling(), i, passes.size());
    if (!passes[i]->Sparse->Connect())
    {
      return false;
    }
    toFill.push_back(&passes[i]->Sparse->ToFill());
  }
  if (!FillTogether(this->Settings.Patching, toFill, this->Accuracy))
  {
    return false;
  }
  for (LabelPass* pass : passes)
  {
    pass->Sparse->Finish();
    pass->Sparse.reset();
  }
  this->Passes.pop_back();
  return true;
}
}
