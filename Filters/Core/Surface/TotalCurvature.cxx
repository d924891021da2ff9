// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/TotalCurvature.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
double TotalCurvature(const SurfaceTriangles& surface)
{
  using Side = std::array<Index, 3>; // its ends, ascending, and its triangle
  std::vector<Side> sides;
  std::vector<Point3> areas;
  for (const auto& [a, b, c] : surface.Triangles)
  {
    const Index triangle = static_cast<Index>(areas.size());
    sides.push_back({ std::min(a, b), std::max(a, b), triangle });
    sides.push_back({ std::min(b, c), std::max(b, c), triangle });
    sides.push_back({ std::min(c, a), std::max(c, a), triangle });
    const Point3& at = surface.Points[a];
    areas.push_back(Cross(surface.Points[b] - at, surface.Points[c] - at));
  }
  std::sort(sides.begin(), sides.end());
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
  {
    const Point3 &one = areas[sides[i][2]], &other = areas[sides[i + 1][2]];
    sum += std::atan2(Length(Cross(one, other)), Dot(one, other)) *
      Length(surface.Points[sides[i][1]] - surface.Points[sides[i][0]]);
  }
  return 0.5 * sum;
}
}
