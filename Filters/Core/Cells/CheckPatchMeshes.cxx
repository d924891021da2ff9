// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CheckPatchMeshes.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace orthoslices
{
std::string CheckPatchCoversBorders(const CycleGeometry& geometry, const std::vector<Index>& cycles,
  const std::vector<std::array<Index, 3>>& triangles)
{
  using Side = std::pair<Index, Index>;
  std::vector<Side> sides;
  for (const auto& triangle : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      sides.emplace_back(triangle[i], triangle[(i + 1) % 3]);
    }
  }
  // With the borders run through backwards, every side has its opposite.
  Index first = 0;
  std::vector<Index> border, places;
  for (const Index cycle : cycles)
  {
    geometry.GetBoundary(cycle, border, places);
    const Index count = static_cast<Index>(border.size());
    for (Index i = 0; i < count; ++i)
    {
      sides.emplace_back(first + (i + 1) % count, first + i);
    }
    first += count;
  }
  std::vector<Side> opposite;
  for (const Side& side : sides)
  {
    opposite.emplace_back(side.second, side.first);
  }
  std::sort(sides.begin(), sides.end());
  std::sort(opposite.begin(), opposite.end());
  if (std::adjacent_find(sides.begin(), sides.end()) != sides.end() || sides != opposite)
  {
    return "the patch of cycle " + std::to_string(cycles.front()) + " does not cover its borders";
  }
  return {};
}

std::string CheckPatchMeshes(const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes)
{
  std::vector<std::uint8_t> hasPatch(geometry.Cycles.Count(), 0);
  for (const PatchMesh& mesh : meshes)
  {
    for (const Index cycle : mesh.Cycles)
    {
      if (hasPatch[cycle] != 0)
      {
        return "cycle " + std::to_string(cycle) + " has two patches";
      }
      hasPatch[cycle] = 1;
    }
    const std::string wrong = CheckPatchCoversBorders(geometry, mesh.Cycles, mesh.Triangles);
    if (!wrong.empty())
    {
      return wrong;
    }
  }
  return {};
}
}
