// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/SharpestFold.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace support
{

double SharpestFold(const TriangleMesh& mesh)
{
  struct Side
  {
    std::array<std::int64_t, 2> Ends;
    Point3 Normal;
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.Triangles.size());
  for (const auto& t : mesh.Triangles)
  {
    const Point3 normal =
      Cross(mesh.Points[t[1]] - mesh.Points[t[0]], mesh.Points[t[2]] - mesh.Points[t[0]]);
    for (int i = 0; i < 3; ++i)
    {
      const std::int64_t a = t[i], b = t[(i + 1) % 3];
      sides.push_back({ { std::min(a, b), std::max(a, b) }, normal });
    }
  }
  std::sort(
    sides.begin(), sides.end(), [](const Side& s, const Side& t) { return s.Ends < t.Ends; });
  double sharpest = 180.0;
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
  {
    const Point3 &p = sides[i].Normal, &q = sides[i + 1].Normal;
    const double turn = std::atan2(Length(Cross(p, q)), Dot(p, q));
    sharpest = std::min(sharpest, 180.0 - turn * 180.0 / 3.14159265358979323846);
  }
  return sharpest;
}

} // namespace support
} // namespace orthoslices
