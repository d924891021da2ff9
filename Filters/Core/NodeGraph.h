// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesNodeGraph_h
#define OrthoSlicesNodeGraph_h

#include "PairNodePoints.h"

namespace orthoslices
{
/**
 * The graph G (the paper's section 4.1): node points joined by arcs. Arc c leads from the node of
 * crossing c to that of Next[c]; removed crossings have no arc.
 *
 * The points of G are first the node points, then the vertices inside the arcs: arc c has the
 * points Nodes + Offsets[c] to Nodes + Offsets[c + 1] - 1 between its nodes.
 */
struct NodeGraph
{
  std::vector<double> Points;        ///< x, y, z of each point
  std::vector<Index> Offsets;        ///< for each crossing, and the end
  std::vector<Index> Component;      ///< of each node, numbered from 0 by their first node
  std::vector<std::uint8_t> Redrawn; ///< arcs that EmbedArcs changed; empty if none
  Index Nodes = 0;
  Index Components = 0;

  Index Count() const { return this->Nodes + this->Offsets.back(); }
  Index FirstPoint(Index arc) const { return this->Nodes + this->Offsets[arc]; }
  Index PointCount(Index arc) const { return this->Offsets[arc + 1] - this->Offsets[arc]; }
};

/**
 * Builds G. Contour vertices at the place of their own crossing are the node point and are not
 * repeated. Where the two contours of a node point disagree by more than `tolerance`, the
 * vertices of the arcs beside it move with it within their planes, less and less along the arc;
 * elsewhere they stay as they are, bit for bit.
 */
NodeGraph BuildNodeGraph(const Contours& contours, const SpatialGrid& grid,
  const Crossings& crossings, const NodePoints& nodes, double tolerance,
  const Execution& execution);

/// Numbers the connected components of G.
void FindComponents(const Crossings& crossings, const NodePoints& nodes, NodeGraph& graph);
}

#endif
