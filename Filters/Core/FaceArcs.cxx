// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceArcs.h"

#include <algorithm>
#include <numeric>

namespace orthoslices
{
namespace
{
Face FaceOf(const GridEdgeCode& code, const Crossings& crossings, Index arc)
{
  const GridEdge edge = code.Decode(crossings.Edge[arc]);
  const Index beyond = crossings.Direction[arc] > 0 ? 1 : 0;
  return crossings.Family[arc] == 0
    ? Face{ FirstAxis(edge.Direction), edge.First, { edge.Second + beyond, edge.Slab } }
    : Face{ SecondAxis(edge.Direction), edge.Second, { edge.Slab, edge.First + beyond } };
}

struct ArcInFace
{
  orthoslices::Face Face;
  Index Arc;
};

/// Of arcs on one slice.
bool operator<(const ArcInFace& a, const ArcInFace& b)
{
  return a.Face.Slab != b.Face.Slab ? a.Face.Slab < b.Face.Slab : a.Arc < b.Arc;
}

/// The arcs that are not removed by slice: slice s has those from offsets[s] to offsets[s + 1] - 1.
std::vector<ArcInFace> GroupBySlice(const SpatialGrid& grid, const Crossings& crossings,
  const Execution& execution, std::vector<std::size_t>& offsets)
{
  const GridEdgeCode code(grid);
  const std::array<Index, 3> firstSlice{ 0, grid.Count(0), grid.Count(0) + grid.Count(1) };
  std::vector<ArcInFace> inOrder(crossings.Count());
  execution.For(inOrder.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t arc = begin; arc < end; ++arc)
      {
        const Index number = static_cast<Index>(arc);
        inOrder[arc] = { FaceOf(code, crossings, number),
          crossings.IsRemoved(number) ? Crossings::Removed : number };
      }
    });
  const auto sliceOf = [&](const ArcInFace& arc)
  { return static_cast<std::size_t>(firstSlice[arc.Face.Axis] + arc.Face.Plane); };
  offsets.assign(firstSlice[2] + grid.Count(2) + 1, 0);
  for (const ArcInFace& arc : inOrder)
  {
    offsets[sliceOf(arc) + 1] += arc.Arc == Crossings::Removed ? 0 : 1;
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<std::size_t> place(offsets.begin(), offsets.end() - 1);
  std::vector<ArcInFace> bySlice(offsets.back());
  for (const ArcInFace& arc : inOrder)
  {
    if (arc.Arc != Crossings::Removed)
    {
      bySlice[place[sliceOf(arc)]++] = arc;
    }
  }
  return bySlice;
}
}

ArcsByFace GroupArcsByFace(
  const SpatialGrid& grid, const Crossings& crossings, const Execution& execution)
{
  std::vector<std::size_t> slices;
  std::vector<ArcInFace> arcs = GroupBySlice(grid, crossings, execution, slices);
  execution.For(slices.size() - 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t slice = begin; slice < end; ++slice)
      {
        std::sort(arcs.begin() + slices[slice], arcs.begin() + slices[slice + 1]);
      }
    });
  ArcsByFace result;
  result.Arcs.reserve(arcs.size());
  for (const ArcInFace& arc : arcs)
  {
    const bool same = !result.Faces.empty() && result.Faces.back().Axis == arc.Face.Axis &&
      result.Faces.back().Plane == arc.Face.Plane && result.Faces.back().Slab == arc.Face.Slab;
    if (!same)
    {
      result.Faces.push_back(arc.Face);
      result.Offsets.push_back(0);
    }
    result.Arcs.push_back(arc.Arc);
    result.Offsets.back() = static_cast<Index>(result.Arcs.size());
  }
  return result;
}

int BorderEdge(const Crossings& crossings, Index crossing, bool isStart)
{
  // An arc that starts upwards starts at the lower border; one that ends upwards ends at the
  // upper one.
  const bool lower = (crossings.Direction[crossing] > 0) == isStart;
  const bool acrossFirst = crossings.Family[crossing] == 0;
  return acrossFirst ? (lower ? 3 : 1) : (lower ? 0 : 2);
}
}
