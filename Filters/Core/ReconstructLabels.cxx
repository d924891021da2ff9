// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ReconstructLabels.h"

#include "Core/Base/EditContours.h"
#include "Core/Frames/SplitByLabel.h"
#include "Core/Labels/ShareBorders.h"
#include "Core/Patches/SharedPatches.h"
#include "Core/ReadSlices.h"
#include "Core/SparseSurface.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <memory>
#include <utility>

namespace orthoslices
{
namespace
{
/// Gaps and overlaps of contours are slivers if they are thinner, in spacings of the planes.
constexpr double ThinGap = 0.01;

/// Labels overlap if that much of the smaller one is common to both; one that is within the other one to
/// that much is meant to be.
constexpr double LeastOverlap = 0.001;
constexpr double MostOverlap = 0.98;

/// How many times slices and labels are made to agree: what one of them changes, the other one has to
/// follow.
constexpr int RoundsOfAgreement = 2;

/// How much of the progress reading takes, and, where slices are sparse, reading and first surfaces.
constexpr double ProgressOfReading = 0.2;
constexpr double ProgressOfDrawing = 0.5;

/// The stages of one label, and what has to outlive them.
struct LabelPass
{
  LabelPass(const Options& options, const Execution& whole)
    : Execute(whole)
    , Stages(options, this->Execute, this->Observe)
  {
    this->Execute.Continue = [this, &whole](double progress)
    { return whole.Continue(this->From + (this->To - this->From) * progress); };
  }
  LabelPass(const LabelPass&) = delete;
  void operator=(const LabelPass&) = delete;

  /// From here on its progress is that part of what is between two values, of the whole.
  void SetProgress(double from, double to, std::size_t part, std::size_t parts)
  {
    const double share = (to - from) / static_cast<double>(parts);
    this->From = from + share * static_cast<double>(part);
    this->To = this->From + share;
  }

  Execution Execute;
  StageObserver Observe;
  Pass Stages;
  bool IsRead = false; ///< and not refused
  std::unique_ptr<SparseStructure> Sparse;

private:
  double From = 0.0, To = 1.0;
};

/// Points as they are in contours that were rounded to multiples of a quantum, if it is not 0.
std::set<Point3> RoundAll(const std::set<Point3>& points, double quantum)
{
  SpatialGrid grid;
  grid.Quantum = quantum;
  std::set<Point3> rounded;
  for (const Point3& point : points)
  {
    rounded.insert({ grid.Round(point[0]), grid.Round(point[1]), grid.Round(point[2]) });
  }
  return rounded;
}

/// Components and handles, once patches of several cycles have given way to others.
void CountComponents(Reconstruction& result)
{
  SurfaceComponents components = MeasureTopology(GeometryOf(result), result.Surface.Meshes);
  result.Topology = components.Topology;
  result.Graph.Component = std::move(components.OfPart);
  result.Graph.Components = components.Topology.Components;
}

/// Runs the stages of all labels; see ReconstructLabels.
class LabelRunner
{
public:
  LabelRunner(
    std::vector<SortedSlices>& labels, const Options& options, const Execution& execution);

  /// False: stopped.
  bool Run();
  std::vector<Reconstruction> TakeResults();
  std::vector<LabelOverlap> FindOverlaps() const;
  CommonCellCounts Counts;

private:
  bool Read();
  bool DoAnyMeet() const;
  void ShareContours();
  void FindPlanes();
  void AddPlanes(const VirtualPlanes& planes);
  SliceDensity Density() const;
  bool MakeEach();
  bool MakeSparse(const SliceDensity& density);
  bool FinishSparse(const std::vector<LabelPass*>& passes);
  LabelPass& AddUnion();
  VirtualPlanes PlanesFor(const SpatialGrid& grid, const VirtualPlanes& common) const;
  void ShareVirtual(const std::vector<LabelPass*>& passes, bool withUnion);
  void SettleCells();
  double Thickness() const;

  std::vector<SortedSlices>& Labels;
  Options Settings;
  const Execution& Execute;
  SharedPatches Shared;
  std::deque<LabelPass> Passes; ///< of the labels, and of their union
  SharedBorders Borders;
  std::set<Point3> Junctions;
  std::array<std::vector<double>, 3> Planes; ///< of all labels
};

LabelRunner::LabelRunner(
  std::vector<SortedSlices>& labels, const Options& options, const Execution& execution)
  : Labels(labels)
  , Settings(options)
  , Execute(execution)
{
  this->Settings.Patching.Shared = &this->Shared;
  this->Settings.Junctions = &this->Junctions;
  for (const SortedSlices& label : labels)
  {
    this->Settings.Quantum =
      std::max(this->Settings.Quantum, ChooseQuantum(label, options.SinglePrecision));
  }
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    this->Passes.emplace_back(this->Settings, execution);
  }
}

bool LabelRunner::Read()
{
  for (std::size_t i = 0; i < this->Labels.size(); ++i)
  {
    LabelPass& pass = this->Passes[i];
    pass.SetProgress(0.0, ProgressOfReading, i, this->Labels.size());
    pass.IsRead = ReadSlices(std::move(this->Labels[i].Slices), pass.Stages);
    if (pass.Stages.Result.Stopped)
    {
      return false;
    }
  }
  return true;
}

/// Whether surfaces of labels may come near to each other: the boxes of their contours do.
bool LabelRunner::DoAnyMeet() const
{
  std::vector<Box3> boxes;
  for (const LabelPass& pass : this->Passes)
  {
    if (pass.IsRead)
    {
      const SpatialGrid& grid = pass.Stages.Result.Grid;
      boxes.push_back({ grid.Lowest, grid.Highest });
      for (std::size_t i = 0; i + 1 < boxes.size(); ++i)
      {
        if (boxes[i].Meets(boxes.back()))
        {
          return true;
        }
      }
    }
  }
  return false;
}

double LabelRunner::Thickness() const
{
  double spacing = HUGE_VAL;
  for (const LabelPass& pass : this->Passes)
  {
    spacing = pass.IsRead ? std::min(spacing, MinMeanSpacing(pass.Stages.Result.Grid)) : spacing;
  }
  return ThinGap * spacing;
}

/// Contours of labels get the same vertices where they run along each other.
void LabelRunner::ShareContours()
{
  std::vector<Contours*> contours;
  for (LabelPass& pass : this->Passes)
  {
    if (pass.IsRead)
    {
      contours.push_back(&pass.Stages.Tables.Contours);
    }
  }
  this->Borders = ShareBorders(this->Thickness(), {}, this->Execute, contours);
  this->Junctions = RoundAll(this->Borders.Junctions, this->Settings.Quantum);
  for (LabelPass& pass : this->Passes)
  {
    if (pass.IsRead)
    {
      pass.Stages.BuildGrid();
    }
  }
  this->FindPlanes();
}

void LabelRunner::FindPlanes()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double>& planes = this->Planes[axis];
    planes.clear();
    for (const LabelPass& pass : this->Passes)
    {
      const std::vector<double>& own = pass.Stages.Result.Grid.Planes[axis];
      planes.insert(planes.end(), own.begin(), own.end());
    }
    std::sort(planes.begin(), planes.end());
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  }
}

void LabelRunner::AddPlanes(const VirtualPlanes& planes)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double>& all = this->Planes[axis];
    all.insert(all.end(), planes[axis].begin(), planes[axis].end());
    std::sort(all.begin(), all.end());
  }
}

/// How dense the slices of all labels are together.
SliceDensity LabelRunner::Density() const
{
  if (this->Settings.Virtual == VirtualSlices::Off)
  {
    return {};
  }
  Contours all;
  for (const LabelPass& pass : this->Passes)
  {
    AppendContours(pass.Stages.Tables.Contours, all);
  }
  const SpatialGrid grid = BuildSpatialGrid(
    all, this->Passes.front().Stages.Tables.Tolerance, this->Settings.SinglePrecision);
  return { grid, BoxOf(all),
    this->Settings.Virtual == VirtualSlices::BySpacing ? this->Settings.VirtualSpacing : 0.0 };
}

/// Each label by itself.
bool LabelRunner::MakeEach()
{
  for (std::size_t i = 0; i < this->Passes.size(); ++i)
  {
    LabelPass& pass = this->Passes[i];
    pass.SetProgress(ProgressOfReading, 1.0, i, this->Passes.size());
    if (pass.IsRead && !ReconstructContours(pass.Stages))
    {
      return false;
    }
  }
  return true;
}

/// What all labels cover together, as one structure more.
LabelPass& LabelRunner::AddUnion()
{
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

/// Virtual slices of all labels divide what all cover together as the real ones do. The union of all
/// is the first one, if it is there.
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
  const SharedBorders shared = ShareBorders(this->Thickness(), allowed, this->Execute, contours);
  const std::set<Point3> junctions = RoundAll(shared.Junctions, this->Settings.Quantum);
  this->Junctions.insert(junctions.begin(), junctions.end());
}

/// All labels with virtual slices on the same planes.
bool LabelRunner::MakeSparse(const SliceDensity& density)
{
  LabelPass& all = this->AddUnion();
  const SpatialGrid& grid = all.Stages.Result.Grid;
  const VirtualPlanes common = ChooseVirtualPlanes(grid, { grid.Lowest, grid.Highest }, density);
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
  for (std::size_t i = 0; i < passes.size(); ++i)
  {
    LabelPass* pass = passes[i];
    pass->SetProgress(ProgressOfReading, ProgressOfDrawing, i, passes.size());
    planes.push_back(this->PlanesFor(pass->Stages.Result.Grid, common));
    pass->Sparse = std::make_unique<SparseStructure>(density, planes.back(), pass->Stages);
    if (!pass->Sparse->Draw())
    {
      return false;
    }
  }
  this->ShareVirtual(passes, true);
  this->AddPlanes(common);
  passes.erase(passes.begin());
  return this->FinishSparse(passes);
}

/// The second surfaces of all labels, from virtual slices on which all slices and labels agree.
bool LabelRunner::FinishSparse(const std::vector<LabelPass*>& passes)
{
  for (int round = 0; round < RoundsOfAgreement; ++round)
  {
    for (LabelPass* pass : passes)
    {
      pass->Stages.SetOtherPlanes(this->Planes);
      if (!pass->Sparse->Redraw())
      {
        return false;
      }
    }
    this->ShareVirtual(passes, false);
  }
  for (std::size_t i = 0; i < passes.size(); ++i)
  {
    passes[i]->SetProgress(ProgressOfDrawing, 1.0, i, passes.size());
    if (!passes[i]->Sparse->Finish())
    {
      return false;
    }
    passes[i]->Sparse.reset();
  }
  this->Passes.pop_back();
  return true;
}

void LabelRunner::SettleCells()
{
  std::vector<StructureSurface> structures;
  for (LabelPass& pass : this->Passes)
  {
    Reconstruction& result = pass.Stages.Result;
    if (pass.IsRead)
    {
      structures.push_back({ GeometryOf(result), result.Normals, result.Surface });
    }
  }
  this->Counts = SettleCommonCells(structures, this->Settings.Patching, this->Execute);
  for (LabelPass& pass : this->Passes)
  {
    if (pass.IsRead)
    {
      CountComponents(pass.Stages.Result);
    }
  }
}

bool LabelRunner::Run()
{
  if (!this->Read())
  {
    return false;
  }
  if (!this->DoAnyMeet())
  {
    return this->MakeEach();
  }
  this->ShareContours();
  const SliceDensity density = this->Density();
  if (density.IsSparse() && !this->MakeSparse(density))
  {
    return false;
  }
  if (!density.IsSparse())
  {
    for (LabelPass& pass : this->Passes)
    {
      if (pass.IsRead)
      {
        pass.Stages.SetOtherPlanes(this->Planes);
        pass.Stages.BuildGrid();
        pass.Stages.Settings.Virtual = VirtualSlices::Off;
      }
    }
    if (!this->MakeEach())
    {
      return false;
    }
  }
  this->SettleCells();
  return true;
}

std::vector<LabelOverlap> LabelRunner::FindOverlaps() const
{
  std::vector<Index> labels; // of the structures that were compared
  for (std::size_t i = 0; i < this->Passes.size(); ++i)
  {
    if (this->Passes[i].IsRead)
    {
      labels.push_back(static_cast<Index>(i));
    }
  }
  std::vector<LabelOverlap> overlaps;
  for (const auto& [pair, area] : this->Borders.Areas.OfPair)
  {
    const std::vector<double>& areas = this->Borders.Areas.OfStructure;
    const double share = area / std::min(areas[pair.first], areas[pair.second]);
    if (share > LeastOverlap && share < MostOverlap)
    {
      overlaps.push_back({ labels[pair.first], labels[pair.second], share });
    }
  }
  std::stable_sort(overlaps.begin(), overlaps.end(),
    [](const LabelOverlap& a, const LabelOverlap& b) { return a.Share > b.Share; });
  return overlaps;
}

std::vector<Reconstruction> LabelRunner::TakeResults()
{
  std::vector<Reconstruction> results;
  for (LabelPass& pass : this->Passes)
  {
    results.push_back(std::move(pass.Stages.Result));
  }
  return results;
}
}

LabelSurfaces ReconstructLabels(
  std::vector<SortedSlices>&& labels, const Options& options, const Execution& execution)
{
  LabelSurfaces surfaces;
  LabelRunner runner(labels, options, execution);
  surfaces.Stopped = !runner.Run();
  if (surfaces.Stopped)
  {
    return surfaces;
  }
  surfaces.OfLabel = runner.TakeResults();
  surfaces.Cells = runner.Counts;
  surfaces.Overlaps = runner.FindOverlaps();
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    ReturnToWorld(std::move(labels[i]), surfaces.OfLabel[i]);
  }
  return surfaces;
}
}
