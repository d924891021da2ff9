// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/StitchSlabs.h"

#include "Core/Slabs/RealizeSheets.h"
#include "Core/Slabs/SlabPatch.h"

#include <algorithm>
#include <iterator>

namespace orthoslices
{
namespace
{
std::vector<PatchMesh> BuildPatches(const SlabSource& source, const Execution& execution)
{
  std::vector<std::vector<PatchMesh>> ofGroup(source.Groups.size());
  execution.For(ofGroup.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const SlabOverlay& overlay = source.Groups[i].Overlay;
        for (Index piece = 0; overlay.Valid && piece < CountPieces(overlay); ++piece)
        {
          ofGroup[i].push_back(BuildSlabPatch(source, i, piece));
        }
      }
    });
  std::vector<PatchMesh> patches;
  for (std::vector<PatchMesh>& part : ofGroup)
  {
    std::move(part.begin(), part.end(), std::back_inserter(patches));
  }
  std::sort(patches.begin(), patches.end(),
    [](const PatchMesh& a, const PatchMesh& b) { return a.Cycles.front() < b.Cycles.front(); });
  return patches;
}

/// The groups with their overlays. By evidence, some of their loops become groups of their own.
std::vector<SlabGroup> OverlayGroups(const SpatialGrid& grid, int axis,
  CorrespondenceCriterion criterion, std::vector<SlabGroup>&& groups, const Execution& execution)
{
  const bool byEvidence = criterion == CorrespondenceCriterion::ByEvidence;
  const bool mayShear = !byEvidence && criterion != CorrespondenceCriterion::Overlap;
  std::vector<std::vector<SlabGroup>> ofGroup(groups.size());
  execution.For(groups.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        OverlayGroup(mayShear, groups[i]);
        const bool plan = byEvidence && groups[i].Overlay.Valid;
        const double width = grid.Width(axis, groups[i].Slab);
        const std::vector<SheetPlan> plans =
          plan ? PlanSheets(groups[i], width) : std::vector<SheetPlan>();
        ofGroup[i] = RealizeSheets(std::move(groups[i]), plans, width);
      }
    });
  std::vector<SlabGroup> result;
  for (std::vector<SlabGroup>& part : ofGroup)
  {
    std::move(part.begin(), part.end(), std::back_inserter(result));
  }
  return result;
}
}

StitchedSlabs StitchSlabs(const CycleGeometry& geometry, CorrespondenceCriterion criterion,
  const std::vector<LoopPair>& pairs, const Execution& execution)
{
  const int axis = FindOnlyFamily(geometry.Grid);
  if (axis < 0 || geometry.Graph.Loops.empty())
  {
    return {};
  }
  std::vector<SlabGroup> groups = OverlayGroups(
    geometry.Grid, axis, criterion, FormSlabGroups(geometry, criterion, pairs), execution);
  StitchedLoops stitched = InsertVertices(geometry, axis, execution, groups);
  StitchedSlabs result;
  result.Patches = BuildPatches({ geometry, axis, groups, stitched }, execution);
  result.Loops = std::move(stitched.Loops);
  return result;
}
}
