// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/PressedPoints.h"

#include <cmath>

namespace orthoslices
{
PressedPoint FindPressing(const SpatialGrid& grid, const Point3& place, double distance, int axis)
{
  for (; axis < 3; ++axis)
  {
    const Index slab = grid.Slab(axis, place[axis]);
    const double above = slab > 0 ? place[axis] - grid.Planes[axis][slab - 1] : HUGE_VAL;
    const double below = slab < grid.Count(axis) ? grid.Planes[axis][slab] - place[axis] : HUGE_VAL;
    if (above > 0.0 && std::min(above, below) < distance)
    {
      return { axis, above < below ? 1.0 : -1.0 };
    }
  }
  return {};
}

PressedPoint FindPressing(const SpatialGrid& grid, const CornerTable& corners,
  const std::vector<Point3>& points, Index point, double distance)
{
  const Point3& place = points[point];
  PressedPoint pressed = FindPressing(grid, place, distance);
  while (pressed.Axis >= 0)
  {
    const int axis = pressed.Axis;
    const auto isNear = [&](Index other)
    { return std::abs(points[other][axis] - place[axis]) < 2.0 * distance; };
    bool isFlat = false;
    corners.ForCornersAt(point,
      [&](Index corner)
      { isFlat = isFlat || (isNear(corners.StartOf(corner)) && isNear(corners.EndOf(corner))); });
    if (isFlat)
    {
      break;
    }
    pressed = FindPressing(grid, place, distance, axis + 1);
  }
  return pressed;
}
}
