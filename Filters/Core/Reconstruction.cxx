// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Reconstruction.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
CycleGeometry GeometryOf(const Reconstruction& result)
{
  return { result.Grid, result.Graph, result.Crossings, result.Nodes, result.Cycles };
}

Index CountLeftOut(const Reconstruction& result)
{
  const IsolatedContours& isolated = result.Isolated;
  Index count = CountLeftOut(isolated);
  for (Index i = 0; i < isolated.Count() && result.Grid.HasVirtual(); ++i)
  {
    const bool isVirtual = result.Grid.IsVirtual(isolated.Axis[i], isolated.Plane[i]);
    count -= isVirtual && isolated.Loop[i] == IsolatedContours::None ? 1 : 0;
  }
  return count;
}

Index CountRealNodes(
  const SpatialGrid& grid, const GridCrossings& crossings, const NodePoints& nodes)
{
  if (!grid.HasVirtual())
  {
    return nodes.Count();
  }
  const GridEdgeCode code(grid);
  return static_cast<Index>(std::count_if(nodes.First.begin(), nodes.First.end(),
    [&](Index crossing) { return AreReal(grid, code.Decode(crossings.Edge[crossing])); }));
}

Index CountDisagreements(const Reconstruction& result, double tolerance)
{
  const std::vector<double>& differences =
    result.RealDifferences.empty() ? result.Nodes.Difference : result.RealDifferences;
  return static_cast<Index>(std::count_if(differences.begin(), differences.end(),
    [&](double difference) { return std::abs(difference) > tolerance; }));
}
}
