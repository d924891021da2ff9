// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/GuideSurface.h"

#include <limits>

namespace orthoslices
{
void GuideSurface(const std::vector<Point3>& guides, double reach, SurfaceMesh& mesh)
{
  const std::vector<Point3> before = mesh.Points;
  // Squared distance of the guide that a point has moved to; fixed points take none.
  std::vector<double> nearest;
  for (const std::uint8_t isFixed : mesh.Fixed)
  {
    nearest.push_back(isFixed ? 0.0 : std::numeric_limits<double>::infinity());
  }
  for (const Point3& guide : guides)
  {
    double least = reach * reach;
    Index found = -1;
    for (Index point = 0; point < static_cast<Index>(before.size()); ++point)
    {
      const double distance = SquaredDistance(before[point], guide);
      if (distance < least && mesh.Corners.IsUsed(point))
      {
        least = distance;
        found = point;
      }
    }
    if (found >= 0 && least < nearest[found])
    {
      nearest[found] = least;
      mesh.Points[found] = guide;
      mesh.Fixed[found] = 1;
    }
  }
}
}
