// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LabelRunner.h"

#include "Core/Base/EditContours.h"
#include "Core/MakeSurface.h"
#include "Core/ReadSlices.h"
#include "Core/Reconstruct.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthoslices
{
namespace
{
/// Gaps and overlaps of contours are slivers if they are thinner, in spacings of the planes.
constexpr double ThinGap = 0.01;

/// Labels overlap if that much of the smaller one is common to both.
constexpr double LeastOverlap = 0.001;

/// Components and handles, once patches of several cycles have given way to others.
void CountComponents(Reconstruction& result)
{
  SurfaceComponents components = MeasureTopology(GeometryOf(result), result.Surface.Meshes);
  result.Topology = components.Topology;
  result.Graph.Component = std::move(components.OfPart);
  result.Graph.Components = components.Topology.Components;
}
}

/// Adds to those that are known.
void LabelRunner::AddJunctions(const std::set<Point3>& junctions)
{
  this->Junctions.merge(RoundAll(junctions, this->Settings.Quantum));
}

std::set<Point3> LabelRunner::RoundAll(const std::set<Point3>& points, double quantum)
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
    this->Settings.Metric = MetricOf(label.Frame); // of all labels
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
    if (pass.IsRead && pass.Stages.Tables.Contours.Count() == 0)
    {
      pass.IsRead = false; // nothing to compare with others
      ReconstructContours(pass.Stages);
    }
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

/// Whether contours of any label bound the outside as they are drawn.
bool LabelRunner::IsAnyInsideOut() const
{
  return std::any_of(this->Passes.begin(), this->Passes.end(),
    [](const LabelPass& pass) { return pass.Stages.Result.InsideOut; });
}

/// The contours of the structures that are compared.
std::vector<Contours*> LabelRunner::ListContours()
{
  std::vector<Contours*> contours;
  for (LabelPass& pass : this->Passes)
  {
    if (pass.IsRead)
    {
      contours.push_back(&pass.Stages.Tables.Contours);
    }
  }
  return contours;
}

/// Contours of labels get the same vertices where they run along each other. False: stopped.
bool LabelRunner::ShareContours()
{
  this->ShareTolerance();
  this->RemoveInserted();
  this->BuildGrids();
  this->AddMissing();
  this->Borders = ShareBorders(this->Thickness(), {}, this->Execute, this->ListContours());
  this->Junctions = RoundAll(this->Borders.Junctions, this->Settings.Quantum);
  this->BuildGrids();
  this->SettleEnds();
  return this->FillLacking();
}

void LabelRunner::BuildGrids()
{
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
  if (this->Settings.Virtual == VirtualSlices::Off || this->IsAnyInsideOut())
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
  const double spacing =
    this->Settings.Virtual == VirtualSlices::BySpacing ? this->Settings.VirtualSpacing : 0.0;
  const SliceDensity bending{ grid, BoxOf(all), spacing };
  return bending.IsSparse() ? bending
                            : SliceDensity{ grid, BoxOf(all), spacing, SparseRule::Field };
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

/// All labels together, whose slices are dense.
bool LabelRunner::MakeDense()
{
  std::vector<Pass*> toFill;
  for (LabelPass& pass : this->Passes)
  {
    pass.SetProgress(ProgressOfReading, ProgressOfReading, 0, 1);
    if (pass.IsRead)
    {
      pass.Stages.SetOtherPlanes(this->Planes, this->WhichPlanes);
      pass.Stages.BuildGrid();
      pass.Stages.Settings.Virtual = VirtualSlices::Off;
      if (!AddOuterSlices(pass.Stages))
      {
        return false;
      }
      toFill.push_back(&pass.Stages);
    }
  }
  if (!this->DrawGraphs(toFill))
  {
    return false;
  }
  for (std::size_t i = 0; i < this->Passes.size(); ++i)
  {
    LabelPass& pass = this->Passes[i];
    pass.SetProgress(ProgressOfReading, this->EndOfFilling(), i, this->Passes.size());
    if (pass.IsRead && !ConnectGraph(pass.Stages))
    {
      return false;
    }
  }
  return FillTogether(this->Settings.Patching, toFill, this->Accuracy);
}

/// The surfaces of the structures that are compared.
std::vector<StructureSurface> LabelRunner::ListSurfaces()
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
  return structures;
}

void LabelRunner::SettleCells()
{
  this->Counts = SettleCommonCells(this->ListSurfaces(), this->Settings.Patching, this->Execute);
  for (LabelPass& pass : this->Passes)
  {
    if (pass.IsRead)
    {
      const Index before = pass.Stages.Result.Topology.Components;
      CountComponents(pass.Stages.Result);
      pass.Separated = std::max<Index>(0, pass.Stages.Result.Topology.Components - before);
    }
  }
}

/// The progress when surfaces are made, but for the shape of their triangles.
double LabelRunner::EndOfFilling() const
{
  return this->Settings.Patching.IsLight() ? ProgressOfFilling : 1.0;
}

/// Triangles of good shape, if they are to be few. How far that is nobody knows, but it can be
/// stopped.
void LabelRunner::ImproveTriangles()
{
  const Execution watched = Watch(this->Execute,
    [this](std::size_t, std::size_t)
    {
      if (!this->Execute.Continue(this->EndOfFilling()))
      {
        throw Stopped();
      }
    });
  ImproveTogether(this->Accuracy, this->Settings.Patching, this->ListSurfaces(), watched);
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
  if (!this->ShareContours() || !this->AgreeOnSlices())
  {
    return false;
  }
  const SliceDensity density = this->Density();
  if (!(density.IsSparse() ? this->MakeSparse(density) : this->MakeDense()))
  {
    return false;
  }
  this->SettleCells();
  this->ImproveTriangles();
  this->TakeReports();
  return true;
}

/// The labels of the structures that were compared.
std::vector<Index> LabelRunner::ListRead() const
{
  std::vector<Index> labels;
  for (std::size_t i = 0; i < this->Passes.size(); ++i)
  {
    if (this->Passes[i].IsRead)
    {
      labels.push_back(static_cast<Index>(i));
    }
  }
  return labels;
}

std::vector<LabelLoss> LabelRunner::FindLosses() const
{
  const std::vector<Index> labels = this->ListRead();
  std::vector<LabelLoss> losses;
  for (std::size_t i = 0; i < this->Borders.Vanished.size(); ++i)
  {
    const LabelLoss loss{ labels[i], this->Borders.Vanished[i], this->Passes[labels[i]].Separated };
    if (loss.Contours > 0 || loss.Parts > 0)
    {
      losses.push_back(loss);
    }
  }
  return losses;
}

std::vector<LabelOverlap> LabelRunner::FindOverlaps() const
{
  const std::vector<Index> labels = this->ListRead();
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
