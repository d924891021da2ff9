// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCrossingTables_h
#define OrthoSlicesCrossingTables_h

#include "Core/Crossings/RegisterCrossings.h"

#include <vector>

namespace orthoslices
{
/// The crossings of all contours, for the stage that makes the slices agree. It is the only one
/// that changes them.
struct CrossingTables
{
  const SpatialGrid& Grid;
  GridCrossings& Crossings;
  EdgeRegister& Edges;
  std::vector<IsolatedLoop>& Isolated; ///< gets contours that lose all of their crossings
  const GridEdgeCode Code{ this->Grid };

  /// The place in M of a filed edge.
  GridEdge EdgeOf(Index edge) const
  {
    return this->Code.Decode(this->Crossings.Edge[this->Edges.Crossing[this->Edges.Offsets[edge]]]);
  }

  /// By how much the winding number of a family's slice grows along an edge, from its lower end to
  /// its upper end.
  int SignSum(Index edge, int family) const
  {
    int sum = 0;
    for (Index i = this->Edges.Offsets[edge]; i < this->Edges.Offsets[edge + 1]; ++i)
    {
      const Index crossing = this->Edges.Crossing[i];
      sum += this->Crossings.Family[crossing] == family ? this->Crossings.Sign(crossing) : 0;
    }
    return sum;
  }
};

/// Whether two edges of M lie on the same grid line.
inline bool OnSameLine(const GridEdge& a, const GridEdge& b)
{
  return a.Direction == b.Direction && a.First == b.First && a.Second == b.Second;
}
}

#endif
