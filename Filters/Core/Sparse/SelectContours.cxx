// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SelectContours.h"

#include "Core/Sparse/MissingContours.h"

namespace orthoslices
{
Box3 BoxOf(const Contours& contours)
{
  Box3 box;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      box.Add(contours.World(contour, i));
    }
  }
  return box;
}

void AddVirtual(const Contours& others, Contours& contours)
{
  contours.Virtual.resize(contours.Axis.size(), 0);
  AppendContours(others, contours);
  std::fill(contours.Virtual.end() - others.Count(), contours.Virtual.end(), std::uint8_t(1));
}

Contours SelectAxis(const Contours& contours, int axis, bool ofAxis)
{
  Contours chosen;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    if ((contours.Axis[contour] == axis) != ofAxis)
    {
      continue;
    }
    const Index first = contours.Offsets[contour], last = contours.Offsets[contour + 1];
    chosen.U.insert(chosen.U.end(), contours.U.begin() + first, contours.U.begin() + last);
    chosen.V.insert(chosen.V.end(), contours.V.begin() + first, contours.V.begin() + last);
    chosen.Offsets.push_back(static_cast<Index>(chosen.U.size()));
    chosen.Axis.push_back(contours.Axis[contour]);
    chosen.Coordinate.push_back(contours.Coordinate[contour]);
    chosen.Cell.push_back(contours.Cell[contour]);
  }
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
