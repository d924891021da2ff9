// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLoopRegions_h
#define OrthoSlicesLoopRegions_h

#include "Core/Loops/LoopRule.h"
#include "Core/Loops/LoopWindings.h"

#include <vector>

namespace orthoslices
{
/// What is inside, face by face of the plane graph that the loops of a slice make.
class LoopRegions
{
public:
  /// The winding numbers have to outlive this.
  explicit LoopRegions(const LoopWindings& windings);

  /**
   * Which faces are inside, 1 or 0.
   *
   * Union: a part surrounds what its winding number is not zero for. One that no other part
   * surrounds is an outline; one within outlines is a hole, one within holes an outline again, and
   * so on. Inside is what an outline surrounds, but for its holes. A part is within another one if
   * that surrounds 98 % of its area, so that noise on a thin wall does not fill holes; two parts of
   * which each surrounds that much of the other one are alike. A part is no hole of another one
   * that it shares more than two thirds of its length with, the interior on the same side: there is
   * no wall in between, so that it is the same once more.
   *
   * EvenOdd, NonZero: by the sum of all winding numbers. With EvenOdd, a part that runs around
   * everything several times counts once.
   */
  std::vector<std::uint8_t> FindInside(LoopRule rule) const;

  /// The same with the interior on the left of loops as they are drawn: inside is what the sum of
  /// all winding numbers is positive for. Where loops bound the outside, as `insideOut` says of all
  /// slices together, it is what the sum is not negative for. EvenOdd: as above, or all the rest.
  std::vector<std::uint8_t> FindInsideAsDrawn(LoopRule rule, bool insideOut) const;

private:
  void FindContainers();
  void FindRepeated();
  void RemoveRepeated();
  bool Contains(Index outer, Index inner) const;
  std::vector<Index> FindLevels() const;
  std::vector<Index> SumWindings(LoopRule rule) const;

  const LoopWindings& Windings;
  const PlaneFaces& Graph;
  std::vector<std::vector<Index>> Containers; ///< of each part: the others that surround all of it
  std::vector<std::uint8_t> IsRepeated;       ///< of each part: it is part of another one's border
};
}

#endif
