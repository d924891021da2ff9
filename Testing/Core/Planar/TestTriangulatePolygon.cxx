// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/TriangulatePolygon.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Rings with points of their own, as TriangulateRings takes them.
struct Drawing
{
  std::vector<Point2> Points;
  std::vector<std::vector<Index>> Rings;
  std::vector<Point2> Empty; ///< points in holes and outside of everything
  int Parts = 0, Holes = 0;

  void Add(std::vector<Point2> ring, bool hole)
  {
    if (hole)
    {
      std::reverse(ring.begin(), ring.end());
    }
    std::vector<Index> places(ring.size());
    std::iota(places.begin(), places.end(), static_cast<Index>(this->Points.size()));
    this->Points.insert(this->Points.end(), ring.begin(), ring.end());
    this->Rings.push_back(places);
    ++(hole ? this->Holes : this->Parts);
  }

  void AddSquare(double u, double v, double size, bool hole)
  {
    this->Add({ { u, v }, { u + size, v }, { u + size, v + size }, { u, v + size } }, hole);
  }
};

double TwiceArea(const Point2& a, const Point2& b, const Point2& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

/**
 * All triangles run counter-clockwise, every side of the rings is a side of one triangle, every
 * other side has a triangle on either side, and the areas add up: so the triangles cover
 * what the rings enclose, once.
 */
void ExpectTriangulated(const Drawing& drawing)
{
  const auto& points = drawing.Points;
  const auto triangles = TriangulateRings(points, drawing.Rings);
  EXPECT_EQ(triangles.size(), points.size() + 2 * drawing.Holes - 2 * drawing.Parts);
  std::map<std::pair<Index, Index>, int> sides;
  double area = 0.0, expected = 0.0;
  for (const auto& t : triangles)
  {
    EXPECT_GT(SideOf(points[t[0]], points[t[1]], points[t[2]]), 0);
    area += TwiceArea(points[t[0]], points[t[1]], points[t[2]]);
    for (int i = 0; i < 3; ++i)
    {
      ++sides[{ t[i], t[(i + 1) % 3] }];
    }
    for (const Point2& p : drawing.Empty)
    {
      EXPECT_FALSE(SideOf(points[t[0]], points[t[1]], p) > 0 &&
        SideOf(points[t[1]], points[t[2]], p) > 0 && SideOf(points[t[2]], points[t[0]], p) > 0)
        << p[0] << ", " << p[1];
    }
  }
  for (const auto& ring : drawing.Rings)
  {
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Index a = ring[i], b = ring[(i + 1) % ring.size()];
      expected += TwiceArea(points[ring[0]], points[a], points[b]);
      EXPECT_EQ((sides[{ a, b }]), 1);
      EXPECT_EQ((sides[{ b, a }]), 0);
      sides.erase({ a, b });
      sides.erase({ b, a });
    }
  }
  for (const auto& side : sides)
  {
    EXPECT_EQ(side.second, 1);
    EXPECT_EQ(sides.count({ side.first.second, side.first.first }), 1u);
  }
  EXPECT_NEAR(area, expected, 1e-9 * std::abs(expected));
}
}

//----------------------------------------------------------------------------
TEST(TriangulateRings, OneRingIsAPolygon)
{
  Drawing drawing;
  drawing.Add(
    { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } }, false);
  drawing.Empty = { { 1.5, 2 }, { 5, 5 } };
  ExpectTriangulated(drawing);
  EXPECT_TRUE(TriangulateRings({}, {}).empty());
}

//----------------------------------------------------------------------------
TEST(TriangulateRings, OneHole)
{
  Drawing drawing;
  drawing.AddSquare(0, 0, 3, false);
  drawing.AddSquare(1, 1, 1, true);
  drawing.Empty = { { 1.5, 1.5 } };
  ExpectTriangulated(drawing);
  // The order of the rings does not matter.
  std::swap(drawing.Rings[0], drawing.Rings[1]);
  ExpectTriangulated(drawing);
}

//----------------------------------------------------------------------------
/// All corners lie on common lines, so that bridges must not run along sides of other holes.
TEST(TriangulateRings, HolesInRowsAndColumns)
{
  for (const int n : { 2, 3, 5 })
  {
    SCOPED_TRACE(n);
    Drawing drawing;
    drawing.AddSquare(0, 0, 2 * n + 1, false);
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n; ++j)
      {
        drawing.AddSquare(2 * i + 1, 2 * j + 1, 1, true);
        drawing.Empty.push_back({ 2 * i + 1.5, 2 * j + 1.5 });
      }
    }
    ExpectTriangulated(drawing);
  }
}

//----------------------------------------------------------------------------
/// The hole's rightmost point sees the outline's nearest corner only past another hole.
TEST(TriangulateRings, HoleBehindAHoleAndInABay)
{
  Drawing drawing;
  drawing.Add(
    { { 0, 0 }, { 10, 0 }, { 10, 10 }, { 8, 10 }, { 8, 2 }, { 2, 2 }, { 2, 10 }, { 0, 10 } },
    false);
  drawing.AddSquare(0.5, 0.5, 1, true);
  drawing.AddSquare(8.5, 8.5, 1, true);
  drawing.Add({ { 4, 0.25 }, { 5, 0.5 }, { 4, 1.75 } }, true);
  drawing.Add({ { 5.5, 0.25 }, { 5.75, 1.75 }, { 5.25, 1.75 } }, true);
  drawing.Empty = { { 1, 1 }, { 9, 9 }, { 4.2, 0.6 }, { 5.5, 1.5 }, { 5, 5 } };
  ExpectTriangulated(drawing);
}

//----------------------------------------------------------------------------
TEST(TriangulateRings, NestedParts)
{
  Drawing drawing;
  for (int i = 0; i < 6; ++i)
  {
    drawing.AddSquare(i, i, 20 - 2 * i, i % 2 == 1);
  }
  drawing.Empty = { { 1.5, 1.5 }, { 10.0, 1.5 }, { 10.0, 5.5 }, { 10.0, 10.0 } };
  // A part beside it.
  drawing.AddSquare(30, 0, 5, false);
  drawing.AddSquare(31, 1, 1, true);
  ExpectTriangulated(drawing);
}

//----------------------------------------------------------------------------
TEST(TriangulateRings, HolesThatLieInNoPartAreLeftOut)
{
  Drawing drawing;
  drawing.AddSquare(0, 0, 3, false);
  drawing.AddSquare(5, 5, 1, true);
  const auto triangles = TriangulateRings(drawing.Points, drawing.Rings);
  EXPECT_EQ(triangles.size(), 2u);
}

//----------------------------------------------------------------------------
namespace
{
/// A star of at most the given radius that contains the disc of half of it, with rings within.
void AddStar(
  Random& random, double u, double v, double radius, bool hole, int depth, Drawing& drawing)
{
  // At an angle of up to 2 pi / 9 from each other, sides pass outside 0.75 * cos(40 / 2 degrees).
  const std::size_t count = 9 + random.Below(20);
  std::vector<Point2> star;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(count);
    const double r = random.Uniform(0.75, 1.0) * radius;
    star.push_back({ u + r * std::cos(angle), v + r * std::sin(angle) });
  }
  drawing.Add(star, hole);
  const std::size_t children = depth == 0 ? 0 : random.Below(5);
  for (std::size_t i = 0; i < children; ++i)
  {
    const double angle = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(children);
    const double distance = children == 1 ? 0.0 : 0.4 * radius;
    const double minimum = children == 1 ? 0.6 : 0.26;
    AddStar(random, u + distance * std::cos(angle), v + distance * std::sin(angle),
      random.Uniform(0.1, minimum) * radius, !hole, depth - 1, drawing);
  }
  if (hole && children != 1)
  {
    drawing.Empty.push_back({ u, v });
  }
}
}

TEST(TriangulateRings, RandomNestedStars)
{
  Random random(2);
  int holes = 0;
  for (int run = 0; run < 200; ++run)
  {
    SCOPED_TRACE(run);
    Drawing drawing;
    const std::size_t stars = 1 + random.Below(3);
    for (std::size_t i = 0; i < stars; ++i)
    {
      AddStar(random, 3.0 * static_cast<double>(i), 0.0, 1.0, false, 4, drawing);
    }
    random.Shuffle(drawing.Rings);
    ExpectTriangulated(drawing);
    holes += drawing.Holes;
  }
  EXPECT_GT(holes, 300);
}

//----------------------------------------------------------------------------
/// Corners on a coarse lattice: many of them lie on common lines.
TEST(TriangulateRings, RandomBlocksOnALattice)
{
  Random random(3);
  for (int run = 0; run < 200; ++run)
  {
    SCOPED_TRACE(run);
    Drawing drawing;
    drawing.AddSquare(0, 0, 25, false);
    for (int i = 0; i < 5; ++i)
    {
      for (int j = 0; j < 5; ++j)
      {
        const double u = 5 * i + 1, v = 5 * j + 1;
        switch (random.Below(4))
        {
          case 0:
            drawing.AddSquare(u, v, 3, true);
            drawing.AddSquare(u + 1, v + 1, 1, false);
            break;
          case 1:
            drawing.Add({ { u, v }, { u + 2, v + 1 }, { u + 1, v + 3 } }, true);
            break;
          case 2:
            drawing.Add({ { u, v }, { u + 1, v }, { u + 2, v }, { u + 2, v + 1 }, { u + 1, v + 1 },
                          { u + 1, v + 2 }, { u, v + 2 } },
              true);
            break;
          default:
            break;
        }
      }
    }
    ExpectTriangulated(drawing);
  }
}
