// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLoopRoles_h
#define OrthoSlicesLoopRoles_h

#include "Core/Slabs/SlabGroup.h"

#include <vector>

namespace orthoslices
{
/// The loops of a slab by what they bound, and how they lie in each other. Members are numbers of
/// loops in the group; lists of them ascend.
class LoopRoles
{
public:
  using Members = std::vector<Index>;

  /// The loops have to outlive this.
  explicit LoopRoles(const std::vector<SlabLoop>& loops);

  bool IsHole(Index member) const { return this->Holes[member] != 0; }
  bool IsUpper(Index member) const { return this->Loops[member].Upper; }
  /// Within the loop, without sign.
  double AreaOf(Index member) const { return this->Areas[member]; }
  /// Of the area within the loop.
  const Point2& CenterOf(Index member) const { return this->Centers[member]; }
  /// The smallest loop of its slice around a loop; -1 without.
  Index ParentOf(Index member) const { return this->Nesting[member]; }

  /// The smallest loop of the other slice around a loop that crosses none of that slice; -1
  /// without.
  Index FindAround(Index member) const;
  /// Those of the members on a slice that are directly inside one of them, or, for -1, in none.
  Members ChildrenOf(Index parent, const Members& members, bool upper) const;
  /// How many of the members are around a loop.
  Index DepthOf(Index member, const Members& members) const;
  /// The nearest of the members on the other slice, of one role; -1 without.
  Index FindNearest(Index member, const Members& members) const;
  /// Adds pairs of loops one to one, the most alike first, after moving the upper ones back by a
  /// shift. False if that is not possible for all.
  bool PairOff(const Members& lower, const Members& upper, const Point2& shift,
    std::vector<Members>& pairs) const;

private:
  const std::vector<SlabLoop>& Loops;
  std::vector<Index> Nesting;
  std::vector<std::uint8_t> Holes;
  std::vector<double> Areas;
  std::vector<Point2> Centers;
};
}

#endif
