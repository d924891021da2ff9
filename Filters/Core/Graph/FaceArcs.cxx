// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/FaceArcs.h"

#include <algorithm>
#include <numeric>

namespace orthoslices
{
namespace
{
Face FaceOf(const GridEdgeCode& code, const GridCrossings& crossings, Index arc)
{
  const GridEdge edge = code.Decode(crossings.Edge[arc]);
  const Index beyond = crossings.Direction[arc] > 0 ? 1 : 0;
  return crossings.Family[arc] == 0
    ? Face{ FirstAxis(edge.Direction), edge.First, { edge.Second + beyond, edge.Slab } }
    : Face{ SecondAxis(edge.Direction), edge.Second, { edge.Slab, edge.First + beyond } };
}

/// The slabs of a face as one number.
std::uint64_t SlabCode(const Face& face)
{
  return static_cast<std::uint64_t>(face.Slab[0]) << 32 | static_cast<std::uint32_t>(face.Slab[1]);
}

/// An arc of a known slice.
struct ArcInSlice
{
  std::uint64_t Slabs;
  Index Arc;
};

/// The arcs that are not removed by slice: slice s has those from offsets[s] to offsets[s + 1] - 1.
std::vector<ArcInSlice> GroupBySlice(const SpatialGrid& grid, const GridCrossings& crossings,
  const Execution& execution, std::vector<std::size_t>& offsets)
{
  const GridEdgeCode code(grid);
  std::vector<ArcInSlice> inOrder(crossings.Count());
  std::vector<Index> slice(crossings.Count());
  execution.For(inOrder.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index arc = static_cast<Index>(i);
        const Face face = FaceOf(code, crossings, arc);
        slice[i] = crossings.IsRemoved(arc) ? GridCrossings::Removed
                                            : grid.SliceNumber(face.Axis, face.Plane);
        inOrder[i] = { SlabCode(face), arc };
      }
    });
  offsets.assign(grid.SliceNumber(2, grid.Count(2)) + 1, 0);
  for (const Index s : slice)
  {
    if (s != GridCrossings::Removed)
    {
      ++offsets[s + 1];
    }
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<std::size_t> place(offsets.begin(), offsets.end() - 1);
  std::vector<ArcInSlice> bySlice(offsets.back());
  for (std::size_t i = 0; i < slice.size(); ++i)
  {
    if (slice[i] != GridCrossings::Removed)
    {
      bySlice[place[slice[i]]++] = inOrder[i];
    }
  }
  return bySlice;
}
}

ArcsByFace GroupArcsByFace(
  const SpatialGrid& grid, const GridCrossings& crossings, const Execution& execution)
{
  std::vector<std::size_t> slices;
  std::vector<ArcInSlice> arcs = GroupBySlice(grid, crossings, execution, slices);
  execution.For(slices.size() - 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t slice = begin; slice < end; ++slice)
      {
        std::sort(arcs.begin() + slices[slice], arcs.begin() + slices[slice + 1],
          [](const ArcInSlice& a, const ArcInSlice& b)
          { return a.Slabs != b.Slabs ? a.Slabs < b.Slabs : a.Arc < b.Arc; });
      }
    });
  ArcsByFace result;
  result.Arcs.reserve(arcs.size());
  std::size_t slice = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (Index plane = 0; plane < grid.Count(axis); ++plane, ++slice)
    {
      for (std::size_t i = slices[slice]; i < slices[slice + 1]; ++i)
      {
        const std::uint64_t slabs = arcs[i].Slabs;
        if (i == slices[slice] || arcs[i - 1].Slabs != slabs)
        {
          result.Faces.push_back({ axis, plane,
            { static_cast<Index>(slabs >> 32), static_cast<Index>(slabs & 0xffffffffu) } });
          result.Offsets.push_back(0);
        }
        result.Arcs.push_back(arcs[i].Arc);
        result.Offsets.back() = static_cast<Index>(result.Arcs.size());
      }
    }
  }
  return result;
}

int BorderEdge(const GridCrossings& crossings, Index crossing, bool isStart)
{
  // An arc that starts upwards starts at the lower border; one that ends upwards ends at the
  // upper one.
  const bool lower = (crossings.Direction[crossing] > 0) == isStart;
  const bool acrossFirst = crossings.Family[crossing] == 0;
  return acrossFirst ? (lower ? 3 : 1) : (lower ? 0 : 2);
}
}
