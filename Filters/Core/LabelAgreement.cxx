// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LabelRunner.h"

#include "Core/Base/EditContours.h"
#include "Core/Labels/CommonLines.h"
#include "Core/Labels/MissingLabels.h"
#include "Core/Labels/NestedRegions.h"
#include "Core/MakeSurface.h"
#include "Core/RealSlices.h"
#include "Core/Slices/EmptyPlanes.h"

#include <algorithm>
#include <iterator>

/// The part of LabelRunner for slices that contradict each other.
namespace orthoslices
{
namespace
{
/// Flags the contours on some planes as virtual.
void FlagVirtual(const VirtualPlanes& planes, Contours& contours)
{
  contours.Virtual.assign(contours.Axis.size(), 0);
  for (Index i = 0; i < contours.Count(); ++i)
  {
    const std::vector<double>& those = planes[contours.Axis[i]];
    contours.Virtual[i] =
      std::binary_search(those.begin(), those.end(), contours.Coordinate[i]) ? 1 : 0;
  }
}

/// Adds the planes to a grid that it has not, as virtual ones where they are so.
void AddAllPlanes(const VirtualPlanes& planes, const VirtualPlanes& ofVirtual, Contours& contours,
  SpatialGrid& grid)
{
  std::array<std::vector<std::uint8_t>, 3> flags;
  bool anyVirtual = grid.HasVirtual();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double plane : planes[axis])
    {
      const Index own = grid.FindPlane(axis, plane);
      flags[axis].push_back(own >= 0
          ? grid.IsVirtual(axis, own)
          : std::binary_search(ofVirtual[axis].begin(), ofVirtual[axis].end(), plane));
      anyVirtual |= flags[axis].back() != 0;
    }
  }
  grid.Planes = planes;
  grid.Virtual = {};
  if (anyVirtual)
  {
    grid.Virtual = std::move(flags);
  }
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    contours.Plane[contour] =
      static_cast<Index>(grid.Slab(contours.Axis[contour], contours.Coordinate[contour]) - 1);
  }
}
}

/// All labels get the greatest tolerance of any, so that common contours move alike with the node
/// points beside them, or stay alike.
void LabelRunner::ShareTolerance()
{
  double tolerance = 0.0;
  for (const LabelPass& pass : this->Passes)
  {
    tolerance = std::max(tolerance, pass.IsRead ? pass.Stages.Tables.Tolerance : 0.0);
  }
  for (LabelPass& pass : this->Passes)
  {
    pass.Stages.Tables.Tolerance = tolerance;
  }
}

/// The planes through which a label passes without being drawn there, but for axes on which it
/// seldom is. False if it is drawn on no plane of an axis.
bool LabelRunner::FindLacking(const LabelPass& label, VirtualPlanes& lacking) const
{
  Contours contours = label.Stages.Tables.Contours;
  SpatialGrid grid = label.Stages.Result.Grid;
  const Box3 box = BoxOf(contours);
  AddEmptyPlanes(this->Planes, EmptyPlanes::NotPassed, contours, grid);
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& planes = this->Planes[axis];
    const auto first = std::lower_bound(planes.begin(), planes.end(), box.Low[axis]);
    const auto last = std::upper_bound(first, planes.end(), box.High[axis]);
    std::vector<double> found;
    std::set_difference(
      first, last, grid.Planes[axis].begin(), grid.Planes[axis].end(), std::back_inserter(found));
    if (first != last && label.Stages.Result.Grid.Planes[axis].empty())
    {
      return false;
    }
    if (static_cast<double>(found.size()) > MostLacking * static_cast<double>(last - first))
    {
      continue;
    }
    std::vector<double> all;
    std::set_union(lacking[axis].begin(), lacking[axis].end(), found.begin(), found.end(),
      std::back_inserter(all));
    lacking[axis] = std::move(all);
  }
  return true;
}

/// Whether slices contradict each other on labels, so that these would part if each was made to
/// agree by itself; on which planes some are not drawn.
bool LabelRunner::DoSlicesContradict(VirtualPlanes& lacking)
{
  for (const LabelPass& label : this->Passes)
  {
    if (label.IsRead && !this->FindLacking(label, lacking))
    {
      return false; // not all labels are drawn on all families
    }
  }
  if (std::any_of(lacking.begin(), lacking.end(), [](const auto& of) { return !of.empty(); }))
  {
    return true;
  }
  std::vector<StructureCrossings> crossings;
  bool isChanged = false;
  for (LabelPass& label : this->Passes)
  {
    if (label.IsRead)
    {
      Pass trial(label.Stages, Contours(label.Stages.Tables.Contours));
      trial.SetShare(0.0, 0.0);
      label.Stages.Result.Stopped = !MakeSlicesAgree(trial);
      Reconstruction& made = trial.Result;
      isChanged |= made.Reconciled.Vertices + made.Reconciled.Edges > 0;
      crossings.push_back(
        { std::move(made.Grid), std::move(made.Crossings), std::move(made.Nodes) });
      if (label.Stages.Result.Stopped)
      {
        return false;
      }
    }
  }
  return isChanged && !DoStructuresAgree(crossings, this->Borders.Sets);
}

/// Keeps what is to be said of the slices of each label as they were drawn. False: stopped.
bool LabelRunner::KeepReports()
{
  for (LabelPass& label : this->Passes)
  {
    if (label.IsRead)
    {
      Pass drawn(label.Stages, Contours(label.Stages.Tables.Contours));
      drawn.SetShare(0.0, 0.0);
      if (!DrawGraph(drawn))
      {
        return false;
      }
      label.AsDrawn = std::make_unique<Reconstruction>(ReportOf(drawn.Result));
    }
  }
  return true;
}

/// There is nothing to be said of slices as they were drawn, as they stay so.
void LabelRunner::ForgetReports()
{
  for (LabelPass& label : this->Passes)
  {
    label.AsDrawn.reset();
  }
}

/**
 * Makes slices of all labels, of which some may be virtual, agree on all labels together. `labels`
 * become what they are then on each slice. False: they stay as they are, either because the caller
 * does not want to go on, see IsStopped, or because the contours of a slice could not be split
 * where they meet.
 */
bool LabelRunner::VoteTogether(const VirtualPlanes& ofVirtual, const std::vector<Contours*>& labels)
{
  const OrderedSets sets(this->Borders.Sets.begin(), this->Borders.Sets.end());
  // None if a slice could not be split, but also if all places of all slices are outside.
  std::vector<Contours> regions =
    NestRegions(sets, this->Execute, { labels.begin(), labels.end() });
  for (Contours& region : regions)
  {
    if (region.Count() == 0)
    {
      continue;
    }
    FlagVirtual(ofVirtual, region);
    Pass pass(this->Settings, this->Passes.front().Execute, this->Passes.front().Observe);
    pass.Tables.Tolerance = this->Passes.front().Stages.Tables.Tolerance;
    pass.Tables.Contours = std::move(region);
    pass.SetShare(0.0, 0.0);
    pass.BuildGrid();
    AddAllPlanes(this->Planes, ofVirtual, pass.Tables.Contours, pass.Result.Grid);
    if (!DrawGraph(pass))
    {
      this->Passes.front().Stages.Result.Stopped = true;
      return false;
    }
    region = ReadAll(pass.Result);
  }
  return !regions.empty() &&
    PartRegions({ sets, this->Planes, this->Thickness() }, this->Execute, regions, labels);
}

/// Draws the slices of each label as they are after all have been made to agree, so that that
/// changes them no more. False: stopped.
bool LabelRunner::RedrawEach()
{
  for (LabelPass& label : this->Passes)
  {
    label.Stages.Inserted.clear(); // the report of the slices as drawn lists them
    Contours& contours = label.Stages.Tables.Contours;
    contours.Virtual.clear();
    if (!label.IsRead || contours.Count() == 0)
    {
      continue;
    }
    Pass pass(label.Stages, Contours(contours));
    pass.SetShare(0.0, 0.0);
    pass.SetOtherPlanes(this->Planes, EmptyPlanes::All);
    pass.BuildGrid();
    if (!DrawGraph(pass))
    {
      label.Stages.Result.Stopped = true;
      return false;
    }
    Contours drawn = ReadAll(pass.Result);
    TakeCells(contours, drawn);
    drawn.Virtual.clear();
    contours = std::move(drawn);
  }
  return true;
}

/**
 * Where slices contradict each other, all labels vote together: each place of a slice gets one of
 * the sets of labels that slices show. What contours of lesser labels run along stays common. A
 * slice on which a label is lacking gives way to those across. Where slices agree, nothing is
 * changed; nor is anything if they cannot be split where contours meet. False: stopped.
 */
bool LabelRunner::AgreeOnSlices()
{
  VirtualPlanes lacking;
  for (int axis = 0; axis < 3; ++axis)
  {
    lacking[axis].assign(this->Filled[axis].begin(), this->Filled[axis].end());
  }
  for (LabelPass& pass : this->Passes)
  {
    pass.SetProgress(ProgressOfReading, ProgressOfReading, 0, 1);
  }
  if (this->IsAnyInsideOut() || !this->DoSlicesContradict(lacking))
  {
    return !this->IsStopped();
  }
  const std::vector<Contours*> labels = this->ListContours();
  std::vector<Contours> before;
  for (const Contours* contours : labels)
  {
    before.push_back(*contours);
  }
  if (!this->KeepReports())
  {
    return false;
  }
  if (!this->VoteTogether(lacking, labels))
  {
    this->ForgetReports();
    return !this->IsStopped();
  }
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    if (labels[i]->Count() == 0)
    {
      *labels[i] = std::move(before[i]); // overruled everywhere: the report of its own says so
    }
  }
  if (!this->RedrawEach())
  {
    return false;
  }
  const SharedBorders shared = ShareBorders(0.0, this->Borders.Sets, this->Execute, labels);
  this->Borders.Union = shared.Union;
  this->Junctions = RoundAll(shared.Junctions, this->Settings.Quantum);
  this->BuildGrids();
  this->WhichPlanes = EmptyPlanes::All;
  return true;
}

bool LabelRunner::IsStopped() const
{
  return std::any_of(this->Passes.begin(), this->Passes.end(),
    [](const LabelPass& pass) { return pass.Stages.Result.Stopped; });
}

/// Says of the slices what there is to be said of them as they were drawn, and besides what was
/// done to them once they agreed.
void LabelRunner::TakeReports()
{
  for (LabelPass& pass : this->Passes)
  {
    if (pass.AsDrawn != nullptr)
    {
      Reconstruction& result = pass.Stages.Result;
      pass.AsDrawn->SmallComponents = result.SmallComponents;
      const std::vector<Repair> own = std::move(result.Repairs); // on planes of the result's grid
      TakeReport(*pass.AsDrawn, {}, result);
      result.Repairs.insert(result.Repairs.end(), own.begin(), own.end());
    }
  }
}
}
