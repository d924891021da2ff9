// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEmbedArcs_h
#define OrthoSlicesEmbedArcs_h

#include "NodeGraph.h"

namespace orthoslices
{
/**
 * Makes the arcs of every face of M simple curves that do not touch each other, strictly inside
 * the face but for their ends (our own addition; contours that do not cross have such arcs from
 * the start).
 *
 *  - Vertices on the border of their face move inside by the grid's Margin.
 *  - Faces whose arcs may still touch (contours that cross or touch, nodes moved far by
 *    contradictory slices, arcs along a grid line) have all their arcs drawn anew as *shells*: an
 *    arc follows the border of the face at a depth that grows with the number of arcs nested
 *    beneath it, so that no two can meet. If the ends of the arcs interlock, they are joined anew
 *    first, neighbour to neighbour.
 *
 * Other faces keep every vertex. `forced` lists arcs whose faces are drawn anew in any case.
 * Returns one repair for each face that was drawn anew, and marks its arcs in NodeGraph::Redrawn.
 */
std::vector<Repair> EmbedArcs(const SpatialGrid& grid, const NodePoints& nodes,
  const Execution& execution, Crossings& crossings, NodeGraph& graph,
  const std::vector<Index>& forced = {});
}

#endif
