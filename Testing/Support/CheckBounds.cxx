// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CheckBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace orthoslices
{
namespace support
{
namespace
{
/// The coordinates of all vertices along an axis.
std::vector<double> CoordinatesAlong(int axis, const Contours& contours)
{
  std::vector<double> coordinates;
  for (Index c = 0; c < contours.Count(); ++c)
  {
    for (Index v = contours.Offsets[c]; v < contours.Offsets[c + 1]; ++v)
    {
      coordinates.push_back(contours.World(c, v)[axis]);
    }
  }
  return coordinates;
}

/// Mean distance of the planes of an axis; 0 if it has fewer than two.
double MeanDistance(int axis, const Contours& contours)
{
  std::set<double> planes;
  for (Index c = 0; c < contours.Count(); ++c)
  {
    if (contours.Axis[c] == axis)
    {
      planes.insert(contours.Coordinate[c]);
    }
  }
  return planes.size() < 2 ? 0.0 : (*planes.rbegin() - *planes.begin()) / (planes.size() - 1.0);
}
}

Point3 AllowedExcess(const Contours& contours, bool singlePrecision)
{
  const double epsilon = singlePrecision ? std::numeric_limits<float>::epsilon()
                                         : std::numeric_limits<double>::epsilon();
  Point3 extent{}, distance{}, step{}, allowed{};
  for (int axis = 0; axis < 3 && contours.Count() > 0; ++axis)
  {
    const std::vector<double> coordinates = CoordinatesAlong(axis, contours);
    const auto ends = std::minmax_element(coordinates.begin(), coordinates.end());
    extent[axis] = *ends.second - *ends.first;
    step[axis] = epsilon * std::max(std::abs(*ends.first), std::abs(*ends.second));
    distance[axis] = MeanDistance(axis, contours);
  }
  const double longest = *std::max_element(extent.begin(), extent.end());
  for (int axis = 0; axis < 3; ++axis)
  {
    double spacing = distance[axis];
    if (spacing == 0.0)
    {
      spacing = 0.5 * (extent[axis] > 0.0 ? extent[axis] : longest);
      for (const double other : distance)
      {
        spacing = other > 0.0 ? std::min(spacing, other) : spacing;
      }
    }
    allowed[axis] = std::max(0.5 * spacing, 128.0 * step[axis]);
  }
  return allowed;
}

Point3 FindExcess(const TriangleMesh& mesh, const Contours& contours, bool singlePrecision)
{
  const Point3 allowed = AllowedExcess(contours, singlePrecision);
  Point3 excess{ -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  for (int axis = 0; axis < 3 && contours.Count() > 0; ++axis)
  {
    const std::vector<double> coordinates = CoordinatesAlong(axis, contours);
    const auto ends = std::minmax_element(coordinates.begin(), coordinates.end());
    const double low = *ends.first - allowed[axis], high = *ends.second + allowed[axis];
    for (const Point3& p : mesh.Points)
    {
      excess[axis] = std::max({ excess[axis], low - p[axis], p[axis] - high });
    }
  }
  return excess;
}

std::string DescribeExcess(const TriangleMesh& mesh, const Contours& contours, bool singlePrecision)
{
  const Point3 excess = FindExcess(mesh, contours, singlePrecision);
  std::ostringstream text;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (excess[axis] > 0.0)
    {
      text << "leaves its bounds along "
           << "xyz"[axis] << " by " << excess[axis] << "\n";
    }
  }
  return text.str();
}

} // namespace support
} // namespace orthoslices
