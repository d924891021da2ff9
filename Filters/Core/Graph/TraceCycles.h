// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTraceCycles_h
#define OrthoSlicesTraceCycles_h

#include "Core/Base/Execution.h"
#include "Core/Graph/NodeGraph.h"

#include <vector>

namespace orthoslices
{
/// An arc as the border of one of its two cells: the cell above its slice or the one below.
struct HalfArc
{
  Index Arc;
  bool Above;
};

/**
 * The cycles of G within the cells of M, which are the spatial polygons (the paper's section 4.3).
 * Cycle i has the half-arcs Arcs[Offsets[i]] to Arcs[Offsets[i + 1] - 1] in order; half-arcs above
 * their slice are passed forward, those below backward, so that the outside of the surface lies
 * where the cycle is seen counter-clockwise. Cell[i] is the cell of M: slabs along x, y, z.
 *
 * The cycles of node points come first, then two for each loop of G, which has none: below its
 * slice and above.
 */
struct CellCycles
{
  std::vector<HalfArc> Arcs;
  std::vector<Index> Offsets{ 0 };
  std::vector<std::array<Index, 3>> Cell;

  Index Count() const { return static_cast<Index>(this->Cell.size()); }
  Index Size(Index cycle) const { return this->Offsets[cycle + 1] - this->Offsets[cycle]; }
};

/**
 * Walks along all cycles. At a node point the cell decides how to go on: each of the four cells
 * around the node's edge has exactly two of the four arcs that meet there. No search is needed,
 * and every arc is part of exactly one cycle on each side of its slice: the surface is closed by
 * construction.
 */
CellCycles TraceCycles(const SpatialGrid& grid, const GridCrossings& crossings,
  const NodePoints& nodes, const NodeGraph& graph, const Execution& execution = Execution());

/// Node at which a half-arc starts, in the direction of its cycle. REQUIRES: no loop.
inline Index StartNode(const GridCrossings& crossings, const NodePoints& nodes, const HalfArc& half)
{
  return nodes.NodeOf[half.Above ? half.Arc : crossings.Next[half.Arc]];
}

/// Cycles ordered by cell, and the range of each cell that has two or more of them.
struct CellGroups
{
  std::vector<Index> Cycles;
  std::vector<std::pair<Index, Index>> Several;
};

CellGroups GroupByCell(
  const SpatialGrid& grid, const CellCycles& cycles, const Execution& execution);

/// Entry i counts the cycles with i node points (the paper's Figure 8); loops are not counted.
std::vector<Index> CountPolygonSizes(const CellCycles& cycles, const NodeGraph& graph);
}

#endif
