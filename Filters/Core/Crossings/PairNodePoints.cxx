// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/PairNodePoints.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Nodes [First, Last), which lie on one edge.
struct NodesOfEdge
{
  GridEdge Edge;
  Index First, Last;
};

/// The share of the second family in the mean of two crossings.
double ShareOfSecond(const SpatialGrid& grid, const AxisWeights& weights, const GridEdge& edge)
{
  const bool first = IsVirtualSlice(grid, edge, 0);
  const bool second = IsVirtualSlice(grid, edge, 1);
  if (first || second)
  {
    return first && second ? 0.5 : first ? 1.0 : 0.0;
  }
  const double w = weights[SecondAxis(edge.Direction)];
  const double sum = weights[FirstAxis(edge.Direction)] + w;
  return sum > 0.0 ? w / sum : 0.5;
}

/// Places each node at the weighted mean of its two crossings.
void PlaceAtMeans(const SpatialGrid& grid, const GridCrossings& crossings,
  const AxisWeights& weights, const NodesOfEdge& range, NodePoints& nodes)
{
  const int t = range.Edge.Direction;
  const double share = ShareOfSecond(grid, weights, range.Edge);
  const bool areReal = AreReal(grid, range.Edge);
  for (Index node = range.First; node < range.Last; ++node)
  {
    const double low = crossings.Position[nodes.First[node]];
    const double high = crossings.Position[nodes.Second[node]];
    const double difference = high - low;
    // The sum may miss the position of the second by rounding.
    const double mean = !areReal && share == 1.0 ? high : low + share * difference;
    nodes.Difference.push_back(areReal ? difference : 0.0);
    nodes.Position.push_back(grid.MoveInside(t, range.Edge.Slab, mean));
  }
}

/// Moves the nodes of one edge apart, by the grid's margin or as far as there is room.
void MoveApart(const SpatialGrid& grid, const NodesOfEdge& range, NodePoints& nodes)
{
  const int t = range.Edge.Direction;
  const Index slab = range.Edge.Slab, first = range.First, last = range.Last;
  double low, high;
  grid.GetExtent(t, slab, nodes.Position[first], nodes.Position[last - 1], low, high);
  grid.ClipToBounds(t, low, high);
  // Half of what there would be for each at equal distances: so all of them find room.
  const double gap = std::min(grid.Margin(t, slab), (high - low) / (2.0 * (last - first + 1)));
  for (Index node = first + 1; node < last; ++node)
  {
    const double minimum = nodes.Position[node - 1] + gap;
    nodes.Position[node] = grid.Round(std::max(nodes.Position[node], minimum));
  }
  // What was pushed beyond the end goes back, and takes those before it along.
  double maximum =
    slab < grid.Count(t) ? high - gap : std::min(high - gap, nodes.Position[last - 1]);
  for (Index node = last - 1; node >= first && nodes.Position[node] > maximum; --node)
  {
    nodes.Position[node] = grid.Round(maximum);
    maximum = nodes.Position[node] - gap;
  }
}
}

NodePoints PairNodePoints(const SpatialGrid& grid, const GridCrossings& crossings,
  const EdgeRegister& edges, const AxisWeights& weights, const Execution& execution)
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
  ForInOrder(execution, static_cast<std::size_t>(edges.Count()),
    [&](std::size_t number)
    {
      const Index edge = static_cast<Index>(number);
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
        const NodesOfEdge range{ code.Decode(crossings.Edge[nodes.First[first]]), first,
          nodes.Count() };
        PlaceAtMeans(grid, crossings, weights, range, nodes);
        if (range.Last - range.First > 1)
        {
          MoveApart(grid, range, nodes);
        }
      }
    });
  return nodes;
}

Point3 NodePosition(const SpatialGrid& grid, const GridEdgeCode& code,
  const GridCrossings& crossings, const NodePoints& nodes, Index node)
{
  return CrossingPoint(grid, code, crossings.Edge[nodes.First[node]], nodes.Position[node]);
}
}
