// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/DiscTriangulation.h"
#include "Core/Planar/SimplePolygon.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double DegreesPerRadian = 180.0 / Pi;

using Polygon = std::vector<Point2>;

Polygon RegularPolygon(int count)
{
  Polygon polygon;
  for (int i = 0; i < count; ++i)
  {
    polygon.push_back({ std::cos(2.0 * Pi * i / count), std::sin(2.0 * Pi * i / count) });
  }
  return polygon;
}

/// Each side of a square of side 1 in equal parts: many points on one line.
Polygon Square(int parts)
{
  const Point2 corners[4] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  Polygon polygon;
  for (int side = 0; side < 4; ++side)
  {
    const Point2 &p = corners[side], &q = corners[(side + 1) % 4];
    for (int i = 0; i < parts; ++i)
    {
      const double t = double(i) / parts;
      polygon.push_back({ p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]) });
    }
  }
  return polygon;
}

/// Seen as a whole from the origin.
Polygon RandomStar(Random& random)
{
  const int count = 3 + static_cast<int>(random.Below(40));
  Polygon polygon;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * (i + random.Uniform(-0.2, 0.2)) / count;
    const double radius = random.Uniform(0.3, 1.0);
    polygon.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return polygon;
}

/// Crossing sides are turned around until there are none; small integers: many points on one line.
Polygon RandomSimple(Random& random, int size)
{
  for (;;)
  {
    Polygon polygon;
    for (std::size_t i = 4 + random.Below(16); i > 0; --i)
    {
      polygon.push_back({ double(random.Below(size)), double(random.Below(size)) });
    }
    const std::size_t n = polygon.size();
    bool changed = true;
    for (int round = 0; changed && round < 200; ++round)
    {
      changed = false;
      for (std::size_t i = 0; i + 2 < n; ++i)
      {
        for (std::size_t j = i + 2; j < n && (i > 0 || j + 1 < n); ++j)
        {
          const Point2 &p = polygon[i], &q = polygon[i + 1], &r = polygon[j],
                       &s = polygon[(j + 1) % n];
          if (SideOf(p, q, r) * SideOf(p, q, s) < 0 && SideOf(r, s, p) * SideOf(r, s, q) < 0)
          {
            std::reverse(polygon.begin() + i + 1, polygon.begin() + j + 1);
            changed = true;
          }
        }
      }
    }
    if (SignedArea(polygon) < 0.0)
    {
      std::reverse(polygon.begin(), polygon.end());
    }
    if (IsSimple(polygon) && SignedArea(polygon) > 0.0)
    {
      return polygon;
    }
  }
}

bool IsBetween(const Point2& p, const Point2& a, const Point2& b)
{
  return SideOf(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
    std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
}

/// By definition, for every pair of sides.
bool IsSimpleByForce(const Polygon& polygon)
{
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point2 &p = polygon[i], &q = polygon[(i + 1) % n];
    for (std::size_t j = 0; j < n; ++j)
    {
      const Point2 &r = polygon[j], &s = polygon[(j + 1) % n];
      if (j == i)
      {
        continue;
      }
      const bool after = (i + 1) % n == j, before = (j + 1) % n == i;
      const bool crossing =
        SideOf(p, q, r) * SideOf(p, q, s) < 0 && SideOf(r, s, p) * SideOf(r, s, q) < 0;
      if (crossing || (!after && IsBetween(r, p, q)) || (!before && IsBetween(s, p, q)) ||
        (!before && IsBetween(p, r, s)) || (!after && IsBetween(q, r, s)))
      {
        return false;
      }
    }
  }
  return true;
}

double LengthOf(const Point2& a, const Point2& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

/// Of a triangle at one of its corners, in degrees.
double AngleAt(const Point2& a, const Point2& b, const Point2& c)
{
  const double x = b[0] - a[0], y = b[1] - a[1], u = c[0] - a[0], v = c[1] - a[1];
  return DegreesPerRadian * std::atan2(std::abs(x * v - y * u), x * u + y * v);
}

double SmallestAngle(const DiscTriangulation& disc)
{
  double smallest = 180.0;
  for (const auto& t : disc.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      smallest = std::min(smallest,
        AngleAt(disc.Points[t.Corners[k]], disc.Points[t.Corners[(k + 1) % 3]],
          disc.Points[t.Corners[(k + 2) % 3]]));
    }
  }
  return smallest;
}

double LongestSideInside(const DiscTriangulation& disc)
{
  double longest = 0.0;
  for (const auto& t : disc.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (t.Neighbors[k] >= 0)
      {
        longest = std::max(
          longest, LengthOf(disc.Points[t.Corners[k]], disc.Points[t.Corners[(k + 1) % 3]]));
      }
    }
  }
  return longest;
}

/**
 * All triangles run counter-clockwise, neighbours know each other, the border is that of the
 * polygon, and the areas add up: so the triangles cover the polygon once.
 */
void ExpectValid(const DiscTriangulation& disc, const Polygon& polygon)
{
  const Index n = static_cast<Index>(polygon.size());
  ASSERT_GE(disc.Points.size(), polygon.size());
  EXPECT_TRUE(std::equal(polygon.begin(), polygon.end(), disc.Points.begin()));
  // Euler: each point inside adds two triangles.
  EXPECT_EQ(disc.Triangles.size(), 2 * disc.Points.size() - polygon.size() - 2);
  double area = 0.0;
  std::map<std::pair<Index, Index>, Index> sides;
  for (std::size_t i = 0; i < disc.Triangles.size(); ++i)
  {
    const auto& corners = disc.Triangles[i].Corners;
    const Polygon triangle{ disc.Points[corners[0]], disc.Points[corners[1]],
      disc.Points[corners[2]] };
    EXPECT_EQ(SideOf(triangle[0], triangle[1], triangle[2]), 1);
    area += SignedArea(triangle);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(
        sides.insert({ { corners[k], corners[(k + 1) % 3] }, static_cast<Index>(i) }).second);
    }
  }
  for (std::size_t i = 0; i < disc.Triangles.size(); ++i)
  {
    const auto& t = disc.Triangles[i];
    for (int k = 0; k < 3; ++k)
    {
      const Index a = t.Corners[k], b = t.Corners[(k + 1) % 3];
      const auto other = sides.find({ b, a });
      EXPECT_EQ(t.Neighbors[k], other == sides.end() ? -1 : other->second);
      EXPECT_EQ(t.Neighbors[k] < 0, a < n && b == (a + 1) % n);
    }
  }
  EXPECT_NEAR(area, SignedArea(polygon), 1e-12 * area);
}

/// No diagonal has the opposite point of its neighbour inside the circumcircle, unless it must
/// stay.
void ExpectDelaunay(const DiscTriangulation& disc)
{
  for (const auto& t : disc.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (t.Neighbors[k] < 0)
      {
        continue;
      }
      const Index ia = t.Corners[k], ib = t.Corners[(k + 1) % 3];
      Index id = -1;
      for (const Index corner : disc.Triangles[t.Neighbors[k]].Corners)
      {
        id = corner != ia && corner != ib ? corner : id;
      }
      const Point2 &a = disc.Points[ia], &b = disc.Points[ib],
                   &c = disc.Points[t.Corners[(k + 2) % 3]], &d = disc.Points[id];
      const bool canFlip = SideOf(c, a, d) > 0 && SideOf(d, b, c) > 0;
      if (canFlip)
      {
        EXPECT_LE(AngleAt(c, a, b) + AngleAt(d, a, b), 180.0 + 1e-6);
      }
    }
  }
}

/// With points all over it, of all points none lies inside a circumcircle.
bool IsInCircle(const Point2& a, const Point2& b, const Point2& c, const Point2& p)
{
  const double ax = a[0] - p[0], ay = a[1] - p[1], bx = b[0] - p[0], by = b[1] - p[1];
  const double cx = c[0] - p[0], cy = c[1] - p[1];
  const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  return aa * (bx * cy - by * cx) + bb * (cx * ay - cy * ax) + cc * (ax * by - ay * bx) > 1e-9;
}
}

//----------------------------------------------------------------------------
TEST(IsSimple, KnownPolygons)
{
  EXPECT_TRUE(IsSimple({ { 0, 0 }, { 1, 0 }, { 0, 1 } }));
  EXPECT_TRUE(IsSimple({ { 0, 0 }, { 0, 1 }, { 1, 0 } })); // clockwise
  EXPECT_FALSE(IsSimple({ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }));
  EXPECT_FALSE(IsSimple({ { 0, 0 }, { 2, 0 }, { 2, 2 }, { 1, 0 }, { 0, 2 } })); // touches a side
  EXPECT_FALSE(IsSimple({ { 0, 0 }, { 3, 0 }, { 1, 0 }, { 1, 2 } }));           // turns back
  EXPECT_FALSE(IsSimple({ { 0, 0 }, { 1, 0 }, { 2, 0 } }));
}

//----------------------------------------------------------------------------
TEST(IsSimple, SidesOnOneLineMayBeApart)
{
  EXPECT_TRUE(IsSimple(Square(3)));
  EXPECT_TRUE(
    IsSimple({ { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } }));
  EXPECT_FALSE(
    IsSimple({ { 0, 0 }, { 3, 0 }, { 3, 3 }, { 1, 3 }, { 1, 1 }, { 2, 1 }, { 2, 3 }, { 0, 3 } }));
}

//----------------------------------------------------------------------------
TEST(IsSimple, AsByDefinition)
{
  Random random(1);
  std::array<int, 2> count{ 0, 0 };
  for (int run = 0; run < 20000; ++run)
  {
    Polygon polygon;
    for (std::size_t i = 3 + random.Below(4); i > 0; --i)
    {
      polygon.push_back({ double(random.Below(5)), double(random.Below(5)) });
    }
    const bool simple = IsSimpleByForce(polygon);
    ++count[simple ? 1 : 0];
    ASSERT_EQ(IsSimple(polygon), simple) << run;
  }
  EXPECT_GT(std::min(count[0], count[1]), 2000);
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, FanIsValid)
{
  Random random(2);
  for (int run = 0; run < 200; ++run)
  {
    const Polygon polygon = RandomStar(random);
    DiscTriangulation disc;
    if (disc.StartWithFan(polygon, { 0.0, 0.0 }))
    {
      ExpectValid(disc, polygon);
      EXPECT_EQ(disc.Triangles.size(), polygon.size());
    }
  }
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, FanMustSeeTheBorderOnce)
{
  DiscTriangulation disc;
  EXPECT_TRUE(disc.StartWithFan(Square(2), { 0.5, 0.5 }));
  EXPECT_FALSE(disc.StartWithFan(Square(2), { 1.5, 0.5 }));
  EXPECT_FALSE(disc.StartWithFan(Square(2), { 0.5, 0.0 })); // on the border
  Polygon clockwise = Square(2);
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_FALSE(disc.StartWithFan(clockwise, { 0.5, 0.5 }));
  Polygon twice = RegularPolygon(7); // every second point: twice around the center
  Polygon star;
  for (int i = 0; i < 7; ++i)
  {
    star.push_back(twice[2 * i % 7]);
  }
  EXPECT_FALSE(disc.StartWithFan(star, { 0.0, 0.0 }));
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, EarsOfRandomPolygonsAreValid)
{
  Random random(3);
  for (int run = 0; run < 300; ++run)
  {
    const Polygon polygon = RandomSimple(random, run % 2 == 0 ? 8 : 1000);
    DiscTriangulation disc;
    ASSERT_TRUE(disc.StartWithEars(polygon)) << run;
    EXPECT_EQ(disc.Points.size(), polygon.size());
    ExpectValid(disc, polygon);
  }
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, EarsOfPointsOnOneLine)
{
  for (const int parts : { 2, 3, 10 })
  {
    DiscTriangulation disc;
    ASSERT_TRUE(disc.StartWithEars(Square(parts)));
    ExpectValid(disc, Square(parts));
  }
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, NoEarsOfWhatIsNotSimpleAndCounterClockwise)
{
  DiscTriangulation disc;
  EXPECT_FALSE(disc.StartWithEars({ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }));
  EXPECT_FALSE(disc.StartWithEars({ { 0, 0 }, { 0, 1 }, { 1, 0 } }));
  EXPECT_FALSE(disc.StartWithEars({ { 0, 0 }, { 1, 0 }, { 2, 0 } }));
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, DiagonalsBecomeDelaunay)
{
  Random random(4);
  for (int run = 0; run < 200; ++run)
  {
    const Polygon polygon = run % 2 == 0 ? RandomStar(random) : RandomSimple(random, 1000);
    DiscTriangulation disc;
    if (!disc.StartWithFan(polygon, { 0.0, 0.0 }))
    {
      ASSERT_TRUE(disc.StartWithEars(polygon));
    }
    const double before = SmallestAngle(disc);
    disc.MakeDelaunay();
    ExpectValid(disc, polygon);
    ExpectDelaunay(disc);
    EXPECT_GE(SmallestAngle(disc), before - 1e-9); // Delaunay triangulations have the greatest
  }
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, OfAConvexPolygonIsDelaunayForAllPoints)
{
  Polygon polygon = RegularPolygon(24);
  for (Point2& p : polygon)
  {
    p[0] *= 1.7;
  }
  DiscTriangulation disc;
  ASSERT_TRUE(disc.StartWithFan(polygon, { 0.1, 0.2 }));
  disc.MakeDelaunay();
  disc.Refine(0.4, 1000);
  ExpectValid(disc, polygon);
  EXPECT_GT(disc.Points.size(), polygon.size() + 10);
  for (const auto& t : disc.Triangles)
  {
    const bool border = std::count(t.Neighbors.begin(), t.Neighbors.end(), -1) > 0;
    for (const Point2& p : disc.Points)
    {
      EXPECT_TRUE(border ||
        !IsInCircle(
          disc.Points[t.Corners[0]], disc.Points[t.Corners[1]], disc.Points[t.Corners[2]], p));
    }
  }
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, RefinedTrianglesAreWellShaped)
{
  for (const int parts : { 2, 4, 8, 16 })
  {
    DiscTriangulation disc;
    ASSERT_TRUE(disc.StartWithFan(Square(parts), { 0.5, 0.5 }));
    disc.MakeDelaunay();
    disc.Refine(1.0 / parts, 4000);
    ExpectValid(disc, Square(parts));
    ExpectDelaunay(disc);
    EXPECT_GT(SmallestAngle(disc), 20.0) << parts;
  }
  for (const int count : { 5, 6, 12, 30, 100 })
  {
    const Polygon polygon = RegularPolygon(count);
    DiscTriangulation disc;
    ASSERT_TRUE(disc.StartWithFan(polygon, { 0.0, 0.0 }));
    disc.MakeDelaunay();
    disc.Refine(100.0, 4000); // for their shape only
    ExpectValid(disc, polygon);
    EXPECT_GT(SmallestAngle(disc), 20.0) << count;
  }
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, RefinesToTheSize)
{
  const Polygon polygon = Square(20);
  std::size_t before = polygon.size() + 1;
  for (const double size : { 0.5, 0.2, 0.1, 0.05 })
  {
    DiscTriangulation disc;
    ASSERT_TRUE(disc.StartWithFan(polygon, { 0.5, 0.5 }));
    disc.MakeDelaunay();
    disc.Refine(size, 10000);
    ExpectValid(disc, polygon);
    EXPECT_LT(LongestSideInside(disc), 1.4 * size);
    EXPECT_GT(disc.Points.size(), before);
    before = disc.Points.size();
  }
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, AddsNoMorePointsThanAllowed)
{
  DiscTriangulation disc;
  ASSERT_TRUE(disc.StartWithFan(Square(4), { 0.5, 0.5 }));
  disc.MakeDelaunay();
  disc.Refine(1e-3, 100);
  EXPECT_EQ(disc.Points.size(), 100u);
  ExpectValid(disc, Square(4));
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, NoPointsCrowdAroundTinySides)
{
  Polygon polygon = Square(4);
  polygon.insert(polygon.begin() + 2, { 0.25 + 1e-8, 0.0 });
  const auto nearest = [&](double minimum)
  {
    DiscTriangulation disc;
    EXPECT_TRUE(disc.StartWithFan(polygon, { 0.5, 0.5 }));
    disc.MakeDelaunay();
    disc.Refine(0.25, 4000, minimum);
    ExpectValid(disc, polygon);
    double distance = 1.0;
    for (std::size_t i = polygon.size(); i < disc.Points.size(); ++i)
    {
      distance = std::min(distance, LengthOf(disc.Points[i], polygon[1]));
    }
    return distance;
  };
  EXPECT_LT(nearest(0.0), 1e-6);
  EXPECT_GT(nearest(1e-2), 5e-3);
}

//----------------------------------------------------------------------------
/// Narrow parts, sharp angles, many points on one line: no good shapes, but nothing wrong.
TEST(DiscTriangulation, RefinedRandomPolygonsAreValid)
{
  Random random(5);
  for (int run = 0; run < 200; ++run)
  {
    const int size = run % 2 == 0 ? 8 : 100000;
    const Polygon polygon = run % 3 == 0 ? RandomStar(random) : RandomSimple(random, size);
    DiscTriangulation disc;
    ASSERT_TRUE(disc.StartWithEars(polygon) || disc.StartWithFan(polygon, { 0, 0 }));
    disc.MakeDelaunay();
    disc.Refine(0.2 * std::sqrt(SignedArea(polygon)), 10 * polygon.size() + 2000);
    ExpectValid(disc, polygon);
    ExpectDelaunay(disc);
    const Index n = static_cast<Index>(polygon.size());
    disc.SplitSides([n](Index a, Index b) { return a < n && b < n; });
    ExpectValid(disc, polygon);
  }
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, NearlyFlatPolygonsStayValid)
{
  Random random(6);
  for (const double height : { 1e-3, 1e-6, 1e-9, 1e-12 })
  {
    Polygon polygon;
    for (int i = 0; i <= 10; ++i)
    {
      polygon.push_back({ 0.1 * i, height * random.Uniform(-0.3, 0.0) });
    }
    for (int i = 10; i >= 0; --i)
    {
      polygon.push_back({ 0.1 * i + 0.03, height * random.Uniform(1.0, 1.3) });
    }
    DiscTriangulation disc;
    ASSERT_TRUE(disc.StartWithEars(polygon));
    disc.MakeDelaunay();
    disc.Refine(0.1, 2000);
    const Index n = static_cast<Index>(polygon.size());
    disc.SplitSides([n](Index a, Index b) { return a < n && b < n; });
    ExpectValid(disc, polygon);
  }
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, NoSideBetweenTwoPointsOfTheBorderIsLeft)
{
  Random random(7);
  for (int run = 0; run < 100; ++run)
  {
    const Polygon polygon = RandomSimple(random, 1000);
    const Index n = static_cast<Index>(polygon.size());
    DiscTriangulation disc;
    ASSERT_TRUE(disc.StartWithEars(polygon));
    const auto ofBorder = [n](Index a, Index b) { return a < n && b < n; };
    disc.SplitSides(ofBorder);
    ExpectValid(disc, polygon);
    EXPECT_EQ(disc.Points.size(), 2 * polygon.size() - 3); // one for each diagonal
    for (const auto& t : disc.Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_TRUE(t.Neighbors[k] < 0 || !ofBorder(t.Corners[k], t.Corners[(k + 1) % 3]));
      }
    }
  }
}

//----------------------------------------------------------------------------
TEST(DiscTriangulation, SplitsInTheMiddle)
{
  DiscTriangulation disc;
  ASSERT_TRUE(disc.StartWithEars(Square(1)));
  disc.SplitSides([](Index, Index) { return false; });
  EXPECT_EQ(disc.Points.size(), 4u);
  disc.SplitSides([](Index a, Index b) { return a < 4 && b < 4; });
  ASSERT_EQ(disc.Points.size(), 5u);
  EXPECT_EQ(disc.Points[4], (Point2{ 0.5, 0.5 }));
}
