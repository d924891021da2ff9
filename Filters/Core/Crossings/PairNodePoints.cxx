// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/PairNodePoints.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Places nodes [first, last), which lie on one edge, at least a margin apart.
void PlaceNodes(const SpatialGrid& grid, const GridEdge& edge, const GridCrossings& crossings,
  const AxisWeights& weights, NodePoints& nodes, Index first, Index last)
{
  const int t = edge.Direction;
  const double sum = weights[FirstAxis(t)] + weights[SecondAxis(t)];
  const double share = sum > 0.0 ? weights[SecondAxis(t)] / sum : 0.5;
  for (Index node = first; node < last; ++node)
  {
    const double low = crossings.Position[nodes.First[node]];
    const double difference = crossings.Position[nodes.Second[node]] - low;
    const double mean = low + share * difference;
    nodes.Difference.push_back(difference);
    nodes.Position.push_back(grid.MoveInside(t, edge.Slab, mean));
  }
  if (last - first == 1)
  {
    return;
  }
  double low, high;
  grid.GetExtent(t, edge.Slab, nodes.Position[first], nodes.Position[last - 1], low, high);
  const double gap = std::min(grid.Margin(t, edge.Slab), (high - low) / (2.0 * (last - first + 1)));
  for (Index node = first + 1; node < last; ++node)
  {
    const double minimum = nodes.Position[node - 1] + gap;
    nodes.Position[node] = grid.Round(std::max(nodes.Position[node], minimum));
  }
  // What was pushed beyond the end goes back, and takes those before it along.
  double maximum = edge.Slab < grid.Count(t) ? high - gap : nodes.Position[last - 1];
  for (Index node = last - 1; node >= first && nodes.Position[node] > maximum; --node)
  {
    nodes.Position[node] = grid.Round(maximum);
    maximum = nodes.Position[node] - gap;
  }
}
}

NodePoints PairNodePoints(const SpatialGrid& grid, const GridCrossings& crossings,
  const EdgeRegister& edges, const AxisWeights& weights)
{
  const GridEdgeCode code(grid);
  NodePoints nodes;
  nodes.NodeOf.assign(crossings.Count(), GridCrossings::None);
  for (std::vector<Index>* side : { &nodes.First, &nodes.Second })
  {
    side->reserve(crossings.Count() / 2);
  }
  nodes.Position.reserve(crossings.Count() / 2);
  nodes.Difference.reserve(crossings.Count() / 2);
  for (Index edge = 0; edge < edges.Count(); ++edge)
  {
    const Index first = nodes.Count();
    for (Index i = edges.Offsets[edge]; i < edges.Offsets[edge + 1]; ++i)
    {
      const Index crossing = edges.Crossing[i];
      if (!crossings.IsRemoved(crossing))
      {
        std::vector<Index>& side = crossings.Family[crossing] == 0 ? nodes.First : nodes.Second;
        nodes.NodeOf[crossing] = static_cast<Index>(side.size());
        side.push_back(crossing);
      }
    }
    if (first < nodes.Count())
    {
      PlaceNodes(grid, code.Decode(crossings.Edge[nodes.First[first]]), crossings, weights, nodes,
        first, nodes.Count());
    }
  }
  return nodes;
}

Point3 NodePosition(const SpatialGrid& grid, const GridEdgeCode& code,
  const GridCrossings& crossings, const NodePoints& nodes, Index node)
{
  return CrossingPoint(grid, code, crossings.Edge[nodes.First[node]], nodes.Position[node]);
}
}
