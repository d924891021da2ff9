// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSnapVertices_h
#define OrthoSlicesSnapVertices_h

#include "Core/Base/Types.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace orthoslices
{
/// Polygons in a plane, to which corners of other ones are moved that are close to them. Time is
/// linear in the length of polygons by the reach, or by the mean length of their sides if that is
/// more.
class SnapTarget
{
public:
  /// `sideLength` is the mean length of sides.
  SnapTarget(double reach, double sideLength)
    : Reach(reach)
    , CellSize(sideLength > 4.0 * reach ? sideLength : 4.0 * reach)
  {
  }

  void Add(const std::vector<Point2>& polygon);

  /// Moves a point to the nearest corner within reach, or else to the nearest place of a side.
  /// False if it stays where it is.
  bool Snap(Point2& point) const;

private:
  struct Side
  {
    Point2 From, To;
  };
  std::int64_t CellOf(double x) const;
  static std::uint64_t KeyOf(std::int64_t i, std::int64_t j);

  const double Reach, CellSize;
  std::vector<Side> Sides;
  std::unordered_map<std::uint64_t, std::vector<Index>> SidesIn; ///< squares of that size
};
}

#endif
