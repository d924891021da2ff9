// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContourRings_h
#define OrthoSlicesContourRings_h

#include "Core/Graph/NodeGraph.h"

#include <array>
#include <vector>

namespace orthoslices
{
/// A contour that is cut into arcs: its points in G, in order from a crossing.
struct ArcRing
{
  std::vector<Index> Points;
  std::vector<Index> Crossing; ///< of each point, or None
};

/// The contours of G that have node points.
class ContourRings
{
public:
  ContourRings(const SpatialGrid& grid, const GridCrossings& crossings, const NodePoints& nodes,
    const NodeGraph& graph)
    : Code(grid)
    , Crossings(crossings)
    , Nodes(nodes)
    , Graph(graph)
  {
  }

  /// The axis of the slice that a crossing's contour lies on.
  int AxisOf(Index crossing) const;
  /// One crossing of each contour, by the axis of its slice: always the same one, however contours
  /// are numbered.
  std::array<std::vector<Index>, 3> FindStarts() const;
  /// The contour of a crossing; reuses the memory of the ring.
  void List(Index start, ArcRing& ring) const;

private:
  GridEdgeCode Code;
  const GridCrossings& Crossings;
  const NodePoints& Nodes;
  const NodeGraph& Graph;
};
}

#endif
