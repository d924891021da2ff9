// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PairNodePoints.h"

#include <cmath>

namespace orthoslices
{
NodePoints PairNodePoints(const Crossings& crossings, const EdgeRegister& edges)
{
  NodePoints nodes;
  nodes.NodeOf.assign(crossings.Count(), Crossings::None);
  nodes.First.reserve(crossings.Count() / 2);
  nodes.Second.reserve(crossings.Count() / 2);
  for (Index edge = 0; edge < edges.Count(); ++edge)
  {
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
  }
  return nodes;
}

Point3 NodePosition(const SpatialGrid& grid, const GridEdgeCode& code, const Crossings& crossings,
  const NodePoints& nodes, Index node)
{
  const Index a = nodes.First[node];
  const Index b = nodes.Second[node];
  const double low = crossings.Position[a];
  return CrossingPoint(grid, code, crossings.Edge[a], low + 0.5 * (crossings.Position[b] - low));
}

double NodeDisagreement(const Crossings& crossings, const NodePoints& nodes, Index node)
{
  return std::abs(crossings.Position[nodes.First[node]] - crossings.Position[nodes.Second[node]]);
}
}
