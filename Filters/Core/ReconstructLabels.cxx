// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ReconstructLabels.h"

#include "Core/Frames/SplitByLabel.h"
#include "Core/Labels/ShareBorders.h"
#include "Core/Patches/SharedPatches.h"
#include "Core/ReadSlices.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

namespace orthoslices
{
namespace
{
/// The same with progress within a part of the whole.
Execution ShareOf(const Execution& whole, double from, double to)
{
  Execution part = whole;
  part.Continue = [&whole, from, to](double progress)
  { return whole.Continue(from + (to - from) * progress); };
  return part;
}

/// What the surface of a label can be compared with others by. Refused ones have none.
bool HasSurface(const Reconstruction& result)
{
  return !result.Refused && result.Surface.Offsets.size() > 1;
}

CommonCellCounts SettleCells(std::vector<Reconstruction>& results, const PatchOptions& options,
  const Execution& execution)
{
  std::vector<StructureSurface> structures;
  for (Reconstruction& result : results)
  {
    if (HasSurface(result))
    {
      structures.push_back({ GeometryOf(result), result.Normals, result.Surface });
    }
  }
  return SettleCommonCells(structures, options, execution);
}
}

namespace
{
/// Gaps and overlaps of contours are slivers if they are thinner, in spacings of the planes.
constexpr double ThinGap = 0.01;

/// What the stages need that outlives them.
struct LabelPass
{
  LabelPass(const Options& options, const Execution& whole, double from, double to)
    : Execute(ShareOf(whole, from, to))
    , Stages(options, this->Execute, this->Observe)
  {
  }
  Execution Execute;
  StageObserver Observe;
  Pass Stages;
  bool IsRead = false;
};

/// Reads the slices of all labels. False: stopped.
bool ReadLabels(std::vector<SortedSlices>& labels, std::deque<LabelPass>& passes)
{
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    passes[i].IsRead = ReadSlices(std::move(labels[i].Slices), passes[i].Stages);
    if (passes[i].Stages.Result.Stopped)
    {
      return false;
    }
  }
  return true;
}

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

/// Contours of labels get the same vertices where they run along each other.
SharedBorders ShareContours(const Execution& execution, std::deque<LabelPass>& passes)
{
  std::vector<Contours*> contours;
  double spacing = HUGE_VAL;
  for (LabelPass& pass : passes)
  {
    if (pass.IsRead)
    {
      contours.push_back(&pass.Stages.Tables.Contours);
      spacing = std::min(spacing, MinMeanSpacing(pass.Stages.Result.Grid));
    }
  }
  const SharedBorders shared = ShareBorders(ThinGap * spacing, {}, execution, contours);
  for (LabelPass& pass : passes)
  {
    if (pass.IsRead)
    {
      pass.Stages.BuildGrid();
    }
  }
  return shared;
}
}

LabelSurfaces ReconstructLabels(
  std::vector<SortedSlices>&& labels, const Options& options, const Execution& execution)
{
  SharedPatches shared;
  Options settings = options;
  settings.Patching.Shared = &shared;
  double all = 1.0, before = 0.0;
  for (const SortedSlices& label : labels)
  {
    all += static_cast<double>(CountVertices(label));
    settings.Quantum =
      std::max(settings.Quantum, ChooseQuantum(label, options.SinglePrecision));
  }
  std::deque<LabelPass> passes;
  for (const SortedSlices& label : labels)
  {
    const double share = static_cast<double>(CountVertices(label)) / all;
    passes.emplace_back(settings, execution, before, before + share);
    before += share;
  }
  LabelSurfaces surfaces;
  surfaces.Stopped = !ReadLabels(labels, passes);
  if (surfaces.Stopped)
  {
    return surfaces;
  }
  const SharedBorders borders = ShareContours(execution, passes);
  const std::set<Point3> junctions = RoundAll(borders.Junctions, settings.Quantum);
  for (LabelPass& pass : passes)
  {
    pass.Stages.Settings.Junctions = &junctions;
  }
  for (LabelPass& pass : passes)
  {
    if (pass.IsRead)
    {
      ReconstructContours(pass.Stages);
    }
    surfaces.OfLabel.push_back(std::move(pass.Stages.Result));
    surfaces.Stopped |= surfaces.OfLabel.back().Stopped;
    if (surfaces.Stopped)
    {
      return surfaces;
    }
  }
  surfaces.Cells = SettleCells(surfaces.OfLabel, options.Patching, execution);
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    ReturnToWorld(std::move(labels[i]), surfaces.OfLabel[i]);
  }
  return surfaces;
}
}
