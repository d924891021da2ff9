// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/ConstrainedTriangulation.h"

#include "Core/Base/Vectors.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr Index None = -1;

/// Nodes, and the rings of two regions through them.
struct Plane
{
  std::vector<Point2> Places;
  std::vector<std::int8_t> Levels;
  std::array<std::vector<std::vector<Index>>, 2> Rings;

  std::vector<Index> AddNodes(const std::vector<Point2>& places, std::int8_t level)
  {
    std::vector<Index> ring(places.size());
    std::iota(ring.begin(), ring.end(), static_cast<Index>(this->Places.size()));
    this->Places.insert(this->Places.end(), places.begin(), places.end());
    this->Levels.insert(this->Levels.end(), places.size(), level);
    return ring;
  }
  std::array<PlaneRegion, 2> Regions() const
  {
    std::array<PlaneRegion, 2> regions{ PlaneRegion(this->Places.size()),
      PlaneRegion(this->Places.size()) };
    for (int number = 0; number < 2; ++number)
    {
      for (const std::vector<Index>& ring : this->Rings[number])
      {
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
          EXPECT_TRUE(regions[number].Add(ring[i], ring[(i + 1) % ring.size()], 0));
        }
      }
    }
    return regions;
  }
  bool Triangulate(std::array<TriangleAdjacency, 2>& triangles) const
  {
    const std::array<PlaneRegion, 2> regions = this->Regions();
    ConstrainedTriangulation triangulation(this->Places, this->Levels, regions);
    std::vector<Index> order(this->Places.size());
    std::iota(order.begin(), order.end(), 0);
    if (!triangulation.Run(order))
    {
      return false;
    }
    triangles = triangulation.GetRegions();
    return true;
  }
  double AreaOf(int region) const
  {
    double area = 0.0;
    for (const std::vector<Index>& ring : this->Rings[region])
    {
      std::vector<Point2> polygon;
      for (const Index node : ring)
      {
        polygon.push_back(this->Places[node]);
      }
      area += SignedArea(polygon);
    }
    return area;
  }
};

std::vector<Point2> Star(Random& random, const Point2& center, double size, std::size_t count)
{
  std::vector<Point2> polygon;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double angle =
      2.0 * Pi * (static_cast<double>(i) + random.Uniform(-0.3, 0.3)) / static_cast<double>(count);
    const double radius = size * random.Uniform(0.5, 1.0);
    polygon.push_back(center + radius * Point2{ std::cos(angle), std::sin(angle) });
  }
  return polygon;
}

/// How far d is inside the circle through a, b and c, counter-clockwise: the determinant in numbers
/// with more digits, divided by the largest of its terms.
double InCircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  long double rows[3][3];
  const Point2* points[3] = { &a, &b, &c };
  for (int i = 0; i < 3; ++i)
  {
    rows[i][0] = (long double)(*points[i])[0] - d[0];
    rows[i][1] = (long double)(*points[i])[1] - d[1];
    rows[i][2] = rows[i][0] * rows[i][0] + rows[i][1] * rows[i][1];
  }
  long double sum = 0.0L, largest = 0.0L;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const long double term = rows[i][2] * (rows[j][0] * rows[k][1] - rows[j][1] * rows[k][0]);
    sum += term;
    largest = std::max(largest, std::abs(term));
  }
  return largest > 0.0L ? static_cast<double>(sum / largest) : 0.0;
}

/// Triangles turn left, cover the region, are linked, and have empty circles but across borders.
void CheckRegion(const Plane& plane, int number, const TriangleAdjacency& triangles)
{
  const PlaneRegion region = plane.Regions()[number];
  double area = 0.0;
  std::size_t borders = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const auto& corners = triangles[t].Corners;
    const Point2 &a = plane.Places[corners[0]], &b = plane.Places[corners[1]],
                 &c = plane.Places[corners[2]];
    EXPECT_EQ(SideOf(a, b, c), 1);
    area += 0.5 * Cross(b - a, c - a);
    for (int i = 0; i < 3; ++i)
    {
      const TriangleSide side{ static_cast<Index>(t), i };
      const Index neighbor = triangles.NeighborOf(side);
      EXPECT_EQ(neighbor == None, region.Next[triangles.StartOf(side)] == triangles.EndOf(side));
      borders += neighbor == None;
      if (neighbor != None)
      {
        const TriangleSide back = triangles.BackOf(side);
        EXPECT_EQ(triangles.NeighborOf(back), side.Triangle);
        EXPECT_EQ(triangles.EndOf(back), triangles.StartOf(side));
        EXPECT_LT(InCircle(a, b, c, plane.Places[triangles.ApexOf(back)]), 1e-9);
      }
    }
  }
  EXPECT_NEAR(area, plane.AreaOf(number), 1e-12 * (1.0 + area));
  std::size_t sides = 0;
  for (const std::vector<Index>& ring : plane.Rings[number])
  {
    sides += ring.size();
  }
  EXPECT_EQ(borders, sides);
}
}

//----------------------------------------------------------------------------
TEST(ConstrainedTriangulation, CoversRandomRegionsWithDelaunayTriangles)
{
  Random random(1);
  for (int round = 0; round < 60; ++round)
  {
    Plane plane;
    // A ring with a hole, in it an island of the other region; another part of that farther away.
    const std::size_t count = 3 + random.Below(60);
    const auto outer = plane.AddNodes(Star(random, { 0, 0 }, 10.0, 40 + count), 0);
    auto hole = plane.AddNodes(Star(random, { 0, 0 }, 4.0, count), 1);
    const auto island = plane.AddNodes(Star(random, { 0, 0 }, 1.5, 3 + random.Below(9)), 0);
    const auto beside = plane.AddNodes(Star(random, { 16, 3 }, 5.0, 3 + random.Below(9)), 1);
    std::reverse(hole.begin(), hole.end());
    plane.Rings[0] = { outer, hole };
    plane.Rings[1] = { island, beside };
    std::array<TriangleAdjacency, 2> triangles;
    ASSERT_TRUE(plane.Triangulate(triangles));
    // Euler: a part with n sides has n - 2 triangles, and each hole adds two more than it has
    // sides.
    EXPECT_EQ(triangles[0].size(), outer.size() + hole.size());
    EXPECT_EQ(triangles[1].size(), island.size() + beside.size() - 4);
    CheckRegion(plane, 0, triangles[0]);
    CheckRegion(plane, 1, triangles[1]);
    ASSERT_FALSE(HasFailure());
  }
}

//----------------------------------------------------------------------------
TEST(ConstrainedTriangulation, BordersAreKeptAgainstTheCircles)
{
  // A thin spike between close points: without constraints the two rows would join each other.
  Plane plane;
  std::vector<Point2> comb{ { 0, -1 }, { 20, -1 } };
  for (int i = 20; i >= 0; --i)
  {
    comb.push_back({ double(i), i % 2 == 0 ? 10.0 : 0.0 });
  }
  plane.Rings[0] = { plane.AddNodes(comb, 0) };
  std::array<TriangleAdjacency, 2> triangles;
  ASSERT_TRUE(plane.Triangulate(triangles));
  EXPECT_EQ(triangles[0].size(), comb.size() - 2);
  EXPECT_TRUE(triangles[1].empty());
  CheckRegion(plane, 0, triangles[0]);
}

//----------------------------------------------------------------------------
TEST(ConstrainedTriangulation, OfEqualDiagonalsTakesTheOneThatJoinsLevels)
{
  // Four points on one circle, at all turns of the ring.
  const std::vector<Point2> square{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  for (std::size_t turn = 0; turn < 4; ++turn)
  {
    Plane plane;
    std::vector<Point2> turned = square;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(turn), turned.end());
    plane.Rings[0] = { plane.AddNodes(turned, 0) };
    plane.Levels = { 0, 0, 0, 1 };
    std::array<TriangleAdjacency, 2> triangles;
    ASSERT_TRUE(plane.Triangulate(triangles));
    ASSERT_EQ(triangles[0].size(), 2u);
    for (const LinkedTriangle& triangle : triangles[0])
    {
      EXPECT_EQ(std::count(triangle.Corners.begin(), triangle.Corners.end(), 3), 1);
    }
  }
}

//----------------------------------------------------------------------------
TEST(ConstrainedTriangulation, HoldsPointsOnOneLineAndOnCircles)
{
  // A grid of squares: four of its points on each circle, many on each line.
  constexpr int n = 8;
  Plane plane;
  std::vector<Point2> ring;
  for (int i = 0; i < n; ++i)
  {
    ring.push_back({ double(i), 0.0 });
  }
  for (int i = 0; i < n; ++i)
  {
    ring.push_back({ double(n), double(i) });
  }
  for (int i = n; i > 0; --i)
  {
    ring.push_back({ double(i), double(n) });
  }
  for (int i = n; i > 0; --i)
  {
    ring.push_back({ 0.0, double(i) });
  }
  plane.Rings[0] = { plane.AddNodes(ring, 0) };
  std::vector<Point2> inner;
  for (int i = 1; i < n; ++i)
  {
    for (int j = 1; j < n; ++j)
    {
      inner.push_back({ double(i), double(j) });
    }
  }
  plane.AddNodes(inner, 1);
  std::array<TriangleAdjacency, 2> triangles;
  ASSERT_TRUE(plane.Triangulate(triangles));
  EXPECT_EQ(triangles[0].size(), std::size_t(2 * n * n));
  CheckRegion(plane, 0, triangles[0]);
}

//----------------------------------------------------------------------------
TEST(ConstrainedTriangulation, RefusesWhatIsNoBorder)
{
  std::array<TriangleAdjacency, 2> triangles;
  Plane clockwise; // its left side is not bounded
  clockwise.Rings[0] = { clockwise.AddNodes({ { 0, 0 }, { 0, 1 }, { 1, 0 } }, 0) };
  EXPECT_FALSE(clockwise.Triangulate(triangles));

  Plane crossing;
  crossing.Rings[0] = { crossing.AddNodes({ { 0, 0 }, { 2, 2 }, { 2, 0 }, { 0, 1 } }, 0) };
  EXPECT_FALSE(crossing.Triangulate(triangles));

  Plane twice; // both regions on the left of one ring
  const auto ring = twice.AddNodes({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, 0);
  twice.Rings = { { { ring }, { ring } } };
  EXPECT_FALSE(twice.Triangulate(triangles));

  PlaneRegion region(3);
  EXPECT_TRUE(region.Add(0, 1, 0));
  EXPECT_FALSE(region.Add(0, 2, 0));
  EXPECT_FALSE(region.Add(2, 1, 0));
}
