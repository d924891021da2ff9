// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/StitchSlabs.h"

#include "Core/Slabs/SlabPatch.h"

#include <algorithm>
#include <iterator>

namespace orthoslices
{
namespace
{
/// The axis of the only family of slices; -1 if there are none or several.
int FindOnlyFamily(const SpatialGrid& grid)
{
  int families = 0;
  int axis = -1;
  for (int i = 0; i < 3; ++i)
  {
    families += grid.Count(i) > 0 ? 1 : 0;
    axis = grid.Count(i) > 0 ? i : axis;
  }
  return families == 1 ? axis : -1;
}

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
}

StitchedSlabs StitchSlabs(const CycleGeometry& geometry, CorrespondenceCriterion criterion,
  const std::vector<LoopPair>& pairs, const Execution& execution)
{
  const int axis = FindOnlyFamily(geometry.Grid);
  if (axis < 0 || geometry.Graph.Loops.empty())
  {
    return {};
  }
  std::vector<SlabGroup> groups = FormSlabGroups(geometry, criterion, pairs);
  const bool mayShear = criterion != CorrespondenceCriterion::ByEvidence &&
    criterion != CorrespondenceCriterion::Overlap;
  execution.For(groups.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        OverlayGroup(mayShear, groups[i]);
      }
    });
  StitchedLoops stitched = InsertVertices(geometry, axis, execution, groups);
  StitchedSlabs result;
  result.Patches = BuildPatches({ geometry, axis, groups, stitched }, execution);
  result.Loops = std::move(stitched.Loops);
  return result;
}
}
