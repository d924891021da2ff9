// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesNodeGraph_h
#define OrthoSlicesNodeGraph_h

#include "Core/Base/Contours.h"
#include "Core/Base/DisjointSets.h"
#include "Core/Base/Execution.h"
#include "Core/Crossings/PairNodePoints.h"

#include <set>
#include <vector>

namespace orthoslices
{
/**
 * The graph G (the paper's section 4.1): node points joined by arcs. Arc c leads from the node of
 * crossing c to that of Next[c]; removed crossings have no arc. *Loops* are arcs without node
 * points, closed in themselves: the isolated contours that take part in the surface. Loop l is the
 * arc Arcs + l.
 *
 * The points of G are first the node points, then the vertices inside the arcs: arc c has the
 * points Nodes + Offsets[c] to Nodes + Offsets[c + 1] - 1 between its nodes.
 */
struct NodeGraph
{
  std::vector<double> Points;        ///< x, y, z of each point
  std::vector<Index> Offsets;        ///< for each crossing, each loop, and the end
  std::vector<Face> Loops;           ///< the face of each loop
  std::vector<Index> Component;      ///< of each node and each loop; see MeasureTopology
  std::vector<std::uint8_t> Redrawn; ///< arcs that EmbedArcs changed; empty if none
  Index Nodes = 0;
  Index Arcs = 0; ///< as many as there are crossings
  Index Components = 0;

  Index Count() const { return this->Nodes + this->Offsets.back(); }
  Index FirstPoint(Index arc) const { return this->Nodes + this->Offsets[arc]; }
  Index PointCount(Index arc) const { return this->Offsets[arc + 1] - this->Offsets[arc]; }
  bool IsLoop(Index arc) const { return arc >= this->Arcs; }
  Point3 PointAt(Index point) const
  {
    const double* p = this->Points.data() + 3 * static_cast<std::size_t>(point);
    return { p[0], p[1], p[2] };
  }
};

/// What G is made from.
struct ArcSource
{
  const orthoslices::Contours& Contours;
  const SpatialGrid& Grid;
  const GridCrossings& Crossings;
  const NodePoints& Nodes;
  /// Vertices of contours that stay in any case, because contours of other structures part from
  /// this one there; null if there are none.
  const std::set<Point3>* Fixed = nullptr;
};

/**
 * Builds G. Contour vertices at the place of their own crossing are the node point and are not
 * repeated. Where the two contours of a node point disagree by more than `tolerance`, the vertices
 * of the arcs beside it move with it within their planes, less and less along the arc, and none
 * from a fixed one on; elsewhere they stay as they are, bit for bit. With SpatialGrid::BothWays,
 * they move to the same places, to the last bit, if the contours run the other way.
 */
NodeGraph BuildNodeGraph(const ArcSource& source, double tolerance, const Execution& execution);

/// The connected parts of G: nodes joined by arcs, then each loop by itself.
DisjointSets ConnectArcs(
  const GridCrossings& crossings, const NodePoints& nodes, const NodeGraph& graph);
}

#endif
