// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   ears of long rings, and whether long polygons are simple, against a look at all pairs
 */

#include "Core/Planar/CutEars.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"
#include "Core/Planar/SimplePolygon.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A horseshoe with a rough outside.
std::vector<Point2> Horseshoe(int count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Point2> polygon;
  for (int i = 0; i < count; ++i)
  {
    const double t = (i + 0.5) / count;
    const bool isOutside = t < 0.5;
    const double angle = isOutside ? 11.0 * t : 11.0 * (1.0 - t);
    const double radius = isOutside ? 1.0 + 0.001 * random.Uniform(-1.0, 1.0) : 0.6;
    polygon.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return polygon;
}

/// The ears that a look at all points finds, one after another.
std::vector<std::array<Index, 3>> CutSlowly(const std::vector<Point2>& points)
{
  std::vector<Index> left(points.size());
  std::iota(left.begin(), left.end(), 0);
  std::vector<std::array<Index, 3>> triangles;
  std::size_t from = 0;
  while (left.size() > 3)
  {
    const std::size_t n = left.size();
    const auto corners = [&](std::size_t ear) {
      return std::array<Index, 3>{ left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n] };
    };
    const auto isEar = [&](std::size_t ear)
    {
      const auto [a, b, c] = corners(ear);
      const auto isIn = [&, p = a, q = b, r = c](Index i)
      {
        return i != p && i != q && i != r && SideOf(points[p], points[q], points[i]) >= 0 &&
          SideOf(points[q], points[r], points[i]) >= 0 &&
          SideOf(points[r], points[p], points[i]) >= 0;
      };
      return SideOf(points[a], points[b], points[c]) > 0 &&
        std::none_of(left.begin(), left.end(), isIn);
    };
    std::size_t ear = from % n, tried = 0;
    for (; tried < n && !isEar(ear); ++tried)
    {
      ear = (ear + 1) % n;
    }
    triangles.push_back(corners(ear));
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    from = ear + 1;
  }
  triangles.push_back({ left[0], left[1], left[2] });
  return triangles;
}
}

//----------------------------------------------------------------------------
TEST(CutEars, FindsTheSameEarsAsALookAtAllPoints)
{
  for (const int count : { 4, 5, 9, 30, 150, 400 })
  {
    const std::vector<Point2> polygon = Horseshoe(count, static_cast<std::uint64_t>(count));
    std::vector<Index> ring(polygon.size());
    std::iota(ring.begin(), ring.end(), 0);
    std::vector<std::array<Index, 3>> triangles;
    CutEars(polygon, ring, triangles);
    EXPECT_EQ(triangles, CutSlowly(polygon)) << count;
  }
}

//----------------------------------------------------------------------------
TEST(CutEars, FillsLongRings)
{
  const std::vector<Point2> polygon = Horseshoe(20000, 1);
  std::vector<Index> ring(polygon.size());
  std::iota(ring.begin(), ring.end(), 0);
  std::vector<std::array<Index, 3>> triangles;
  CutEars(polygon, ring, triangles);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  double area = 0.0;
  for (const auto& [a, b, c] : triangles)
  {
    EXPECT_GT(SideOf(polygon[a], polygon[b], polygon[c]), 0);
    area += 0.5 * Cross(polygon[b] - polygon[a], polygon[c] - polygon[a]);
  }
  EXPECT_NEAR(area, SignedArea(polygon), 1e-9);
}

//----------------------------------------------------------------------------
TEST(IsSimple, OfLongPolygons)
{
  for (const int count : { 90, 110, 5000 })
  {
    std::vector<Point2> polygon = Horseshoe(count, 7);
    EXPECT_TRUE(IsSimple(polygon)) << count;
    // A vertex of the outside beyond the inside.
    polygon[count / 4] = 0.8 * polygon[3 * count / 4];
    EXPECT_FALSE(IsSimple(polygon)) << count;
  }
}
