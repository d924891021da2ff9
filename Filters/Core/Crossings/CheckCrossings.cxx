// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/CheckCrossings.h"

#include <array>
#include <vector>

namespace orthoslices
{
std::string CheckCrossingOrder(const GridCrossings& crossings)
{
  for (Index c = 0; c < crossings.Count(); ++c)
  {
    if (crossings.IsRemoved(c))
    {
      continue;
    }
    const Index next = crossings.Next[c];
    if (next < 0 || next >= crossings.Count() || crossings.IsRemoved(next) ||
      crossings.Previous[next] != c)
    {
      return "the arc of crossing " + std::to_string(c) + " has no end that knows it";
    }
  }
  return {};
}

std::string CheckSlicesAgree(const GridCrossings& crossings, const EdgeRegister& edges)
{
  std::array<std::vector<int>, 2> signs;
  for (Index edge = 0; edge < edges.Count(); ++edge)
  {
    signs[0].clear();
    signs[1].clear();
    for (Index i = edges.Offsets[edge]; i < edges.Offsets[edge + 1]; ++i)
    {
      const Index crossing = edges.Crossing[i];
      if (!crossings.IsRemoved(crossing))
      {
        signs[crossings.Family[crossing]].push_back(crossings.Sign(crossing));
      }
    }
    if (signs[0] != signs[1])
    {
      return "the slices contradict each other on edge " + std::to_string(edge);
    }
  }
  return {};
}

std::string CheckNodePoints(const GridCrossings& crossings, const NodePoints& nodes)
{
  for (Index c = 0; c < crossings.Count(); ++c)
  {
    const Index node = nodes.NodeOf[c];
    if (crossings.IsRemoved(c) ? node != GridCrossings::None : node < 0 || node >= nodes.Count())
    {
      return "crossing " + std::to_string(c) + " has the wrong node point";
    }
  }
  for (Index node = 0; node < nodes.Count(); ++node)
  {
    const Index first = nodes.First[node], second = nodes.Second[node];
    if (nodes.NodeOf[first] != node || nodes.NodeOf[second] != node ||
      crossings.Family[first] != 0 || crossings.Family[second] != 1 ||
      crossings.Edge[first] != crossings.Edge[second] ||
      crossings.Sign(first) != crossings.Sign(second))
    {
      return "node point " + std::to_string(node) + " does not join two crossings that match";
    }
  }
  return {};
}
}
