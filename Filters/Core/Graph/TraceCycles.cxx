// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/TraceCycles.h"

#include <algorithm>
#include <numeric>

namespace orthoslices
{
namespace
{
/**
 * The half-arc that follows in the same cell. At its end the arc meets a contour of another slice,
 * on whose upper or lower side the cell lies: on the upper side the cycle goes on along that
 * contour, on the lower side it goes back.
 */
HalfArc NextHalfArc(const GridCrossings& crossings, const NodePoints& nodes, const HalfArc& half)
{
  const Index end = half.Above ? crossings.Next[half.Arc] : half.Arc;
  const Index other = nodes.Partner(crossings, end);
  // Forward we come from the side that the contour leaves here, backward from the one it enters.
  const bool above = half.Above ? crossings.Direction[end] < 0 : crossings.Direction[end] > 0;
  return { above ? other : crossings.Previous[other], above };
}

std::array<Index, 3> CellOf(
  const GridEdgeCode& code, const GridCrossings& crossings, const HalfArc& half)
{
  // The start of the arc: its edge, the side of the crossed plane it goes to, the side of its
  // slice.
  const GridEdge edge = code.Decode(crossings.Edge[half.Arc]);
  const int t = edge.Direction;
  const Index side = half.Above ? 1 : 0;
  const Index after = crossings.Direction[half.Arc] > 0 ? 1 : 0;
  const bool family0 = crossings.Family[half.Arc] == 0;
  std::array<Index, 3> cell;
  cell[t] = edge.Slab;
  cell[FirstAxis(t)] = edge.First + (family0 ? side : after);
  cell[SecondAxis(t)] = edge.Second + (family0 ? after : side);
  return cell;
}
}

CellCycles TraceCycles(const SpatialGrid& grid, const GridCrossings& crossings,
  const NodePoints& nodes, const NodeGraph& graph, const Execution& execution)
{
  const GridEdgeCode code(grid);
  CellCycles cycles;
  cycles.Arcs.reserve(2 * static_cast<std::size_t>(crossings.Count()));
  std::vector<std::uint8_t> visited(2 * static_cast<std::size_t>(crossings.Count()), 0);
  const auto mark = [&](const HalfArc& half) -> std::uint8_t&
  { return visited[2 * static_cast<std::size_t>(half.Arc) + (half.Above ? 1 : 0)]; };
  ForInOrder(execution, static_cast<std::size_t>(crossings.Count()),
    [&](std::size_t number)
    {
      const Index arc = static_cast<Index>(number);
      for (const bool above : { false, true })
      {
        HalfArc half{ arc, above };
        if (crossings.IsRemoved(arc) || mark(half))
        {
          continue;
        }
        cycles.Cell.push_back(CellOf(code, crossings, half));
        for (; !mark(half); half = NextHalfArc(crossings, nodes, half))
        {
          mark(half) = 1;
          cycles.Arcs.push_back(half);
        }
        cycles.Offsets.push_back(static_cast<Index>(cycles.Arcs.size()));
      }
    });
  for (std::size_t loop = 0; loop < graph.Loops.size(); ++loop)
  {
    const Face& face = graph.Loops[loop];
    std::array<Index, 3> cell;
    cell[face.Axis] = face.Plane;
    cell[FirstAxis(face.Axis)] = face.Slab[0];
    cell[SecondAxis(face.Axis)] = face.Slab[1];
    for (const bool above : { false, true })
    {
      cycles.Arcs.push_back({ graph.Arcs + static_cast<Index>(loop), above });
      cycles.Offsets.push_back(static_cast<Index>(cycles.Arcs.size()));
      cycles.Cell.push_back(cell);
      ++cell[face.Axis];
    }
  }
  return cycles;
}

CellGroups GroupByCell(
  const SpatialGrid& grid, const CellCycles& cycles, const Execution& execution)
{
  // Layer by layer along the first axis; sorting the cells of a layer is quick.
  std::vector<Index> layers(grid.Count(0) + 2, 0);
  for (const auto& cell : cycles.Cell)
  {
    ++layers[cell[0] + 1];
  }
  std::partial_sum(layers.begin(), layers.end(), layers.begin());
  std::vector<Index> place(layers.begin(), layers.end() - 1);
  std::vector<std::pair<std::uint64_t, Index>> cells(cycles.Count());
  for (Index i = 0; i < cycles.Count(); ++i)
  {
    const auto& cell = cycles.Cell[i];
    const std::uint64_t code =
      (static_cast<std::uint64_t>(cell[0]) * (grid.Count(1) + 1) + cell[1]) * (grid.Count(2) + 1) +
      cell[2];
    cells[place[cell[0]]++] = { code, i };
  }
  execution.For(layers.size() - 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t layer = begin; layer < end; ++layer)
      {
        std::sort(cells.begin() + layers[layer], cells.begin() + layers[layer + 1]);
      }
    });
  CellGroups groups;
  groups.Cycles.reserve(cells.size());
  Index first = 0;
  for (Index i = 0; i < cycles.Count(); ++i)
  {
    groups.Cycles.push_back(cells[i].second);
    first = i > 0 && cells[i].first == cells[i - 1].first ? first : i;
    const bool last = i + 1 == cycles.Count() || cells[i + 1].first != cells[i].first;
    if (last && i > first)
    {
      groups.Several.emplace_back(first, i + 1);
    }
  }
  return groups;
}

std::vector<Index> CountPolygonSizes(const CellCycles& cycles, const NodeGraph& graph)
{
  std::vector<Index> histogram;
  const Index count = cycles.Count() - 2 * static_cast<Index>(graph.Loops.size());
  for (Index i = 0; i < count; ++i)
  {
    const std::size_t size = cycles.Size(i);
    histogram.resize(std::max(histogram.size(), size + 1), 0);
    ++histogram[size];
  }
  return histogram;
}
}
