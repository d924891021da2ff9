// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCycleGeometry_h
#define OrthoSlicesCycleGeometry_h

#include "Core/Graph/TraceCycles.h"

#include <vector>

namespace orthoslices
{
/// The cycles of all cells, and what they are made of.
struct CycleGeometry
{
  const SpatialGrid& Grid;
  const NodeGraph& Graph;
  const GridCrossings& Crossings;
  const NodePoints& Nodes;
  const CellCycles& Cycles;

  const HalfArc& FirstArc(Index cycle) const
  {
    return this->Cycles.Arcs[this->Cycles.Offsets[cycle]];
  }
  bool IsLoop(Index cycle) const { return this->Graph.IsLoop(this->FirstArc(cycle).Arc); }
  /// The loop of a cycle that has no node points.
  Index LoopOf(Index cycle) const { return this->FirstArc(cycle).Arc - this->Graph.Arcs; }
  /// The node at which the cycle starts, or the number of its loop after all nodes.
  Index PartOf(Index cycle) const
  {
    return this->IsLoop(cycle) ? this->Graph.Nodes + this->LoopOf(cycle)
                               : StartNode(this->Crossings, this->Nodes, this->FirstArc(cycle));
  }
  /**
   * The points of G around a cycle, in its direction, and where the nodes are among them: node i of
   * the cycle is points[nodePlaces[i]]; a loop has none. Reuses the memory of both vectors.
   */
  void GetBoundary(Index cycle, std::vector<Index>& points, std::vector<Index>& nodePlaces) const;
  /// Whether an arc or a loop lies on a real slice, see SpatialGrid.
  bool IsOnReal(Index arc) const;
  /// Whether all arcs of the cycle lie on real slices.
  bool IsReal(Index cycle) const;
  /// The borders of several cycles, one after another.
  std::vector<Index> GetBorders(const std::vector<Index>& cycles) const;
};
}

#endif
