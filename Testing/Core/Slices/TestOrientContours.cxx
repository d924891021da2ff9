// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/OrientContours.h"

#include "Core/Base/EditContours.h"
#include "Core/Slices/SpatialGrid.h"
#include "Support/Random.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
std::vector<Problem> Orient(
  Contours& contours, Orientation orientation = Orientation::ByNesting, bool removeCrossing = true)
{
  std::vector<Problem> problems;
  BuildSpatialGrid(contours, 0.0);
  OrientContours(orientation, removeCrossing, contours.Count(), Execution(), contours, problems);
  return problems;
}

/// Signs of the areas, by the contours' cells.
std::vector<int> Signs(const Contours& contours)
{
  std::vector<int> signs(contours.Count());
  for (Index i = 0; i < contours.Count(); ++i)
  {
    signs[contours.Cell[i]] = TwiceSignedArea(contours, i) > 0.0 ? 1 : -1;
  }
  return signs;
}
}

//----------------------------------------------------------------------------
TEST(OrientContours, SignedAreaIsPositiveCounterClockwise)
{
  const Contours contours =
    ParseContours("x=0: 0,0 2,0 2,3 0,3; y=0: 0,0 0,1 1,0; z=7: 1000,1000 1001,1000 1000,1001");
  EXPECT_EQ(TwiceSignedArea(contours, 0), 12.0);
  EXPECT_EQ(TwiceSignedArea(contours, 1), -1.0);
  EXPECT_EQ(TwiceSignedArea(contours, 2), 1.0);
}

//----------------------------------------------------------------------------
TEST(OrientContours, OuterBoundaryTurnsLeftAndHoleTurnsRight)
{
  Contours contours = ParseContours("z=0: 0,0 0,9 9,9 9,0; z=0: 3,3 6,3 6,6 3,6");
  EXPECT_TRUE(Orient(contours).empty());
  EXPECT_EQ(Signs(contours), (std::vector<int>{ 1, -1 }));
}

//----------------------------------------------------------------------------
/// Noise has put the leftmost corner of the second one into the first one: that makes it no hole.
TEST(OrientContours, MostOfAContourSaysWhereItLies)
{
  Contours contours = ParseContours("z=0: 0,0 9,0 9,9 0,9; z=0: 8.9,4 10,3 15,3 15,6 10,6");
  std::vector<Problem> crossing;
  OrientContours(Orientation::ByNesting, false, contours.Count(), Execution(), contours, crossing);
  EXPECT_EQ(Signs(contours), (std::vector<int>{ 1, 1 }));
}

//----------------------------------------------------------------------------
TEST(OrientContours, AsDrawnStaysAsItIs)
{
  Contours contours = ParseContours("z=0: 0,0 0,9 9,9 9,0; z=0: 3,3 6,3 6,6 3,6");
  const std::vector<double> u = contours.U, v = contours.V;
  EXPECT_TRUE(Orient(contours, Orientation::AsDrawn).empty());
  EXPECT_EQ(contours.U, u);
  EXPECT_EQ(contours.V, v);
}

//----------------------------------------------------------------------------
TEST(OrientContours, OtherSlicesDoNotCount)
{
  // The same squares one in another, but on different planes and axes.
  Contours contours =
    ParseContours("z=0: 0,0 9,0 9,9 0,9; z=1: 3,3 6,3 6,6 3,6; y=0: 4,4 5,4 5,5 4,5");
  EXPECT_TRUE(Orient(contours).empty());
  for (Index i = 0; i < contours.Count(); ++i)
  {
    EXPECT_GT(TwiceSignedArea(contours, i), 0.0);
  }
}

//----------------------------------------------------------------------------
TEST(OrientContours, NestedSquaresAlternateToDepthFive)
{
  Contours contours;
  for (int depth = 0; depth <= 5; ++depth)
  {
    const double a = depth, b = 20.0 - depth;
    AddContour(contours, { { a, a }, { b, a }, { b, b }, { a, b } });
  }
  EXPECT_TRUE(Orient(contours).empty());
  EXPECT_EQ(Signs(contours), (std::vector<int>{ 1, -1, 1, -1, 1, -1 }));
}

//----------------------------------------------------------------------------
/// Circles that do not cross: the depth is the number of circles around the center.
TEST(OrientContours, NestingDepthAsBruteForceHasIt)
{
  int deepest = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<std::array<double, 3>> circles;
    Contours contours;
    for (int attempt = 0; attempt < 200; ++attempt)
    {
      const std::array<double, 3> c{ random.Uniform(-4, 4), random.Uniform(-4, 4),
        random.Uniform(0.05, 4) };
      const bool apart = std::all_of(circles.begin(), circles.end(),
        [&](const auto& o)
        {
          const double d = std::hypot(c[0] - o[0], c[1] - o[1]);
          return d > c[2] + o[2] + 0.02 || d < std::abs(c[2] - o[2]) - 0.02;
        });
      if (apart)
      {
        circles.push_back(c);
        std::vector<std::array<double, 2>> vertices;
        const double turn = random.Chance(0.5) ? 1.0 : -1.0;
        const std::size_t start = random.Below(40);
        for (std::size_t k = 0; k < 40; ++k)
        {
          const double angle = turn * 0.157079632679 * static_cast<double>(k + start);
          vertices.push_back({ c[0] + c[2] * std::cos(angle), c[1] + c[2] * std::sin(angle) });
        }
        AddContour(contours, vertices);
      }
    }
    EXPECT_TRUE(Orient(contours).empty());
    std::vector<int> expected;
    for (const auto& c : circles)
    {
      const auto depth = std::count_if(circles.begin(), circles.end(),
        [&](const auto& o) { return o[2] > c[2] && std::hypot(c[0] - o[0], c[1] - o[1]) < o[2]; });
      deepest = std::max(deepest, static_cast<int>(depth));
      expected.push_back(depth % 2 == 0 ? 1 : -1);
    }
    EXPECT_EQ(Signs(contours), expected);
  }
  EXPECT_GE(deepest, 4);
}

//----------------------------------------------------------------------------
TEST(OrientContours, BowTieIsReportedAndRemoved)
{
  Contours contours = ParseContours("y=3: 9,9 10,9 9,10; y=3: 0,0 2,2 2,0 0,2");
  const std::vector<Problem> problems = Orient(contours);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].Kind, ProblemKind::CrossesItself);
  EXPECT_EQ(problems[0].Port, 1);
  EXPECT_EQ(problems[0].Cell, 1);
  EXPECT_EQ(problems[0].Where[1], 3.0);
  ASSERT_EQ(contours.Count(), 1);
  EXPECT_EQ(contours.Cell[0], 0);
  EXPECT_EQ(contours.U, (std::vector<double>{ 9, 10, 9 }));
  EXPECT_EQ(contours.Offsets, (std::vector<Index>{ 0, 3 }));
}

//----------------------------------------------------------------------------
TEST(OrientContours, SmallerOfTwoCrossingContoursGoes)
{
  for (const char* text : { "z=0: 0,0 9,0 9,9 0,9; z=0: 8,8 12,8 12,12 8,12",
         "z=0: 8,8 12,8 12,12 8,12; z=0: 0,0 9,0 9,9 0,9" })
  {
    SCOPED_TRACE(text);
    Contours contours = ParseContours(text);
    const std::vector<Problem> problems = Orient(contours);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].Kind, ProblemKind::CrossesOther);
    ASSERT_EQ(contours.Count(), 1);
    EXPECT_EQ(TwiceSignedArea(contours, 0), 162.0);
    EXPECT_NE(problems[0].Cell, contours.Cell[0]);
  }
}

//----------------------------------------------------------------------------
TEST(OrientContours, SettledContoursStayAsTheyAre)
{
  Contours contours =
    ParseContours("z=0: 0,0 0,9 9,9 9,0; z=1: 0,0 0,9 9,9 9,0; z=1: 3,3 6,3 6,6 3,6");
  BuildSpatialGrid(contours, 0.0);
  std::vector<Problem> problems;
  OrientContours(Orientation::ByNesting, false, 1, Execution(), contours, problems);
  EXPECT_EQ(Signs(contours), (std::vector<int>{ 1, -1, 1 }));
}

//----------------------------------------------------------------------------
TEST(OrientContours, TouchingContoursAreNoProblem)
{
  for (const char* text : { "z=0: 0,0 1,0 1,1 0,1; z=0: 1,1 2,1 2,2 1,2", // in a corner
         "z=0: 0,0 1,0 1,1 0,1; z=0: 1,0 2,0 2,1 1,1",                    // along an edge
         "z=0: 0,0 4,0 4,4 0,4; z=0: 2,0 3,1 1,1",                        // corner on an edge
         "z=0: 0,0 1,1 2,2 2,0 1,1 0,2" })                                // itself, in a corner
  {
    SCOPED_TRACE(text);
    Contours contours = ParseContours(text);
    const Index count = contours.Count();
    EXPECT_TRUE(Orient(contours).empty());
    EXPECT_EQ(contours.Count(), count);
  }
}

//----------------------------------------------------------------------------
namespace
{
using IntPoint = std::array<long, 2>;

int SideOf(const IntPoint& p, const IntPoint& q, const IntPoint& r)
{
  const long det = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

/// Whether any two segments of a polygon cross within both, by exact arithmetic.
bool CrossesItself(const std::vector<IntPoint>& p)
{
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const IntPoint &a = p[i], &b = p[(i + 1) % n], &c = p[j], &d = p[(j + 1) % n];
      if (SideOf(a, b, c) * SideOf(a, b, d) < 0 && SideOf(c, d, a) * SideOf(c, d, b) < 0)
      {
        return true;
      }
    }
  }
  return false;
}
}

TEST(OrientContours, FindsSelfCrossingsAsExactArithmeticDoes)
{
  int crossing = 0, simple = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<IntPoint> polygon;
    std::vector<std::array<double, 2>> vertices;
    const std::size_t size = 3 + random.Below(5);
    while (polygon.size() < size)
    {
      const IntPoint p{ static_cast<long>(random.Below(7)), static_cast<long>(random.Below(7)) };
      if (std::find(polygon.begin(), polygon.end(), p) == polygon.end())
      {
        polygon.push_back(p);
        vertices.push_back({ static_cast<double>(p[0]), static_cast<double>(p[1]) });
      }
    }
    Contours contours;
    AddContour(contours, vertices);
    const bool expected = CrossesItself(polygon);
    EXPECT_EQ(!Orient(contours).empty(), expected);
    EXPECT_EQ(contours.Count(), expected ? 0 : 1);
    (expected ? crossing : simple) += 1;
  }
  EXPECT_GT(crossing, 300);
  EXPECT_GT(simple, 300);
}
