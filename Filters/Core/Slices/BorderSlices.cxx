// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/BorderSlices.h"

#include "Core/Base/Vectors.h"

#include <vector>

namespace orthoslices
{
namespace
{
/// Moves what lies on one side out. A point next to one that is not there is kept before or after
/// it.
std::vector<Point2> MoveOut(
  const std::vector<Point2>& points, int direction, double side, double beyond)
{
  std::vector<Point2> moved;
  const std::size_t count = points.size();
  const auto isOn = [&](std::size_t i) { return points[i % count][direction] == side; };
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!isOn(i))
    {
      moved.push_back(points[i]);
      continue;
    }
    Point2 out = points[i];
    out[direction] += beyond;
    if (!isOn(i + count - 1))
    {
      moved.push_back(points[i]);
    }
    moved.push_back(out);
    if (!isOn(i + 1))
    {
      moved.push_back(points[i]);
    }
  }
  return moved;
}
}

Contours ContinueBeyond(const Contours& contours, const Box3& border, const Point3& beyond)
{
  Contours result = contours;
  result.U.clear();
  result.V.clear();
  result.Offsets.assign(1, 0);
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    std::vector<Point2> points;
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      points.push_back({ contours.U[i], contours.V[i] });
    }
    for (const int direction : { 0, 1 })
    {
      const int axis =
        direction == 0 ? FirstAxis(contours.Axis[contour]) : SecondAxis(contours.Axis[contour]);
      points = MoveOut(points, direction, border.Low[axis], -beyond[axis]);
      points = MoveOut(points, direction, border.High[axis], beyond[axis]);
    }
    for (const Point2& point : points)
    {
      result.U.push_back(point[0]);
      result.V.push_back(point[1]);
    }
    result.Offsets.push_back(static_cast<Index>(result.U.size()));
  }
  return result;
}
}
