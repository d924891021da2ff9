// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/PairLoops.h"

#include "Core/Slabs/SlabGroup.h"

#include <algorithm>
#include <tuple>

namespace orthoslices
{
namespace
{
/// The loops across an axis as a stack, and their numbers.
ContourStack StackOf(const CycleGeometry& geometry, int axis, std::vector<Index>& loops)
{
  ContourStack stack;
  stack.Coordinate = geometry.Grid.Planes[axis];
  for (std::size_t loop = 0; loop < geometry.Graph.Loops.size(); ++loop)
  {
    if (geometry.Graph.Loops[loop].Axis == axis)
    {
      loops.push_back(static_cast<Index>(loop));
    }
  }
  std::stable_sort(loops.begin(), loops.end(),
    [&](Index a, Index b)
    { return geometry.Graph.Loops[a].Plane < geometry.Graph.Loops[b].Plane; });
  for (const Index loop : loops)
  {
    for (const Point2& p : OutlineOf(geometry.Graph, loop))
    {
      stack.U.push_back(p[0]);
      stack.V.push_back(p[1]);
    }
    stack.Offsets.push_back(static_cast<Index>(stack.U.size()));
    stack.Slice.push_back(geometry.Graph.Loops[loop].Plane);
  }
  return stack;
}
}

std::vector<LoopPair> PairLoops(
  const CycleGeometry& geometry, CorrespondenceCriterion criterion, const PriorKnowledge& known)
{
  std::vector<LoopPair> pairs;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<Index> loops;
    const ContourStack stack = StackOf(geometry, axis, loops);
    for (const Correspondence& match : FindCorrespondences(criterion, stack, known))
    {
      const auto cycle = [&](Index contour, bool above)
      { return CycleOfLoop(geometry, loops[contour], above); };
      const Index a = cycle(match.First, match.Where != Passage::Below);
      const Index b = cycle(match.Second, match.Where == Passage::Above);
      if (geometry.Cycles.Cell[a] == geometry.Cycles.Cell[b])
      {
        pairs.push_back({ std::min(a, b), std::max(a, b) });
      }
    }
  }
  std::sort(pairs.begin(), pairs.end(),
    [](const LoopPair& a, const LoopPair& b)
    { return std::tie(a.First, a.Second) < std::tie(b.First, b.Second); });
  return pairs;
}
}
