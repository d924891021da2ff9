// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SelectContours.h"

#include "Core/Base/EditContours.h"

#include <algorithm>

namespace orthoslices
{
void AddVirtual(const Contours& others, Contours& contours)
{
  contours.Virtual.resize(contours.Axis.size(), 0);
  AppendContours(others, contours);
  std::fill(contours.Virtual.end() - others.Count(), contours.Virtual.end(), std::uint8_t(1));
}

Contours SelectAxis(const Contours& contours, int axis, bool ofAxis)
{
  std::vector<std::uint8_t> isOther;
  for (const std::int8_t of : contours.Axis)
  {
    isOther.push_back((of == axis) != ofAxis ? 1 : 0);
  }
  Contours chosen = contours;
  RemoveMarked(isOther, chosen);
  return chosen;
}

std::vector<Point3> SamplePoints(const Contours& contours, double distance)
{
  std::vector<Point3> points;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      const Point3 point = contours.World(contour, i);
      if (i == contours.Offsets[contour] || Length(point - points.back()) >= distance)
      {
        points.push_back(point);
      }
    }
  }
  return points;
}
}
