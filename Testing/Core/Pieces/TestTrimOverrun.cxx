// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/TrimOverrun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Points of a circle of radius 10 in steps of a hundredth of the round, from number `from` to
/// `to`.
OpenCurve Arc(int from, int to, double radius = 10.0)
{
  OpenCurve curve;
  for (int i = from; i <= to; ++i)
  {
    // Remainders, so that a second round has the very same points.
    const double angle = 0.02 * Pi * ((i % 100 + 100) % 100);
    curve.Points.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return curve;
}

double AreaOf(const std::vector<Point2>& loop)
{
  double area = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    area += 0.5 * Cross(loop[i], loop[(i + 1) % loop.size()]);
  }
  return area;
}
}

//----------------------------------------------------------------------------
TEST(TrimOverrun, ARetracedPartGoes)
{
  for (int beyond = 0; beyond <= 20; ++beyond)
  {
    SCOPED_TRACE(beyond);
    OpenCurve curve = Arc(7, 107 + beyond);
    const double extra = curve.Length() - Arc(7, 107).Length();
    ASSERT_TRUE(TrimOverrun(curve));
    EXPECT_TRUE(curve.IsLoop);
    EXPECT_NEAR(curve.Trimmed, extra, 1e-9);
    EXPECT_NEAR(AreaOf(curve.Points), AreaOf(Arc(0, 99).Points), 1e-9);
    std::vector<Point2> points = curve.Points;
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    EXPECT_EQ(points.size(), 100u) << "every point of the circle, once";
  }
}

//----------------------------------------------------------------------------
TEST(TrimOverrun, APartThatRunsBesideTheStartGoes)
{
  for (const double aside : { -0.3, -0.02, 0.02, 0.3 })
  {
    for (const int beyond : { 4, 10, 20 })
    {
      SCOPED_TRACE(std::to_string(aside) + " " + std::to_string(beyond));
      OpenCurve curve = Arc(0, 99);
      const OpenCurve tail = Arc(100, 100 + beyond, 10.0 + aside);
      curve.Points.insert(curve.Points.end(), tail.Points.begin(), tail.Points.end());
      ASSERT_TRUE(TrimOverrun(curve));
      EXPECT_NEAR(AreaOf(curve.Points), 100.0 * Pi, 1.0);
      EXPECT_NEAR(curve.EndDistance(), 0.0, 0.7) << "at most a step of the circle";
      EXPECT_NEAR(curve.Trimmed, tail.Length(), 0.7);
    }
  }
}

//----------------------------------------------------------------------------
TEST(TrimOverrun, EndsThatCrossAreCutAtTheCrossing)
{
  // A square whose ends stick out by 1 and by 0.5 beyond its corner.
  OpenCurve curve;
  curve.Points = { { -1.0, 0.0 }, { 10.0, 0.0 }, { 10.0, 10.0 }, { 0.0, 10.0 }, { 0.0, -0.5 } };
  ASSERT_TRUE(TrimOverrun(curve));
  EXPECT_EQ(curve.Points,
    (std::vector<Point2>{ { 0.0, 0.0 }, { 10.0, 0.0 }, { 10.0, 10.0 }, { 0.0, 10.0 } }));
  EXPECT_DOUBLE_EQ(curve.Trimmed, 1.5);
}

//----------------------------------------------------------------------------
TEST(TrimOverrun, CurvesThatDoNotPassTheirStartStayAsTheyAre)
{
  std::vector<OpenCurve> curves{ Arc(0, 60), Arc(0, 90), Arc(0, 98), Arc(0, 99) };
  OpenCurve square;
  square.Points = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
  curves.push_back(square);
  square.Points.resize(2);
  curves.push_back(square);
  square.Points.resize(1);
  curves.push_back(square);
  // A long tail that turns away: much of it is no overrun.
  OpenCurve tail = Arc(0, 99);
  tail.Points.push_back({ 11.0, 0.0 });
  tail.Points.push_back({ 80.0, 0.0 });
  curves.push_back(tail);
  for (const OpenCurve& before : curves)
  {
    OpenCurve curve = before;
    EXPECT_FALSE(TrimOverrun(curve));
    EXPECT_EQ(curve.Points, before.Points);
    EXPECT_FALSE(curve.IsLoop);
  }
}

//----------------------------------------------------------------------------
TEST(TrimOverrun, PiecesThatOverlapMeetInOnePoint)
{
  for (int beyond = 1; beyond < 10; ++beyond)
  {
    SCOPED_TRACE(beyond);
    OpenCurve first = Arc(0, 50 + beyond);
    OpenCurve next = Arc(50, 99);
    const double trimmed = TrimOverlap(first.Points, next.Points);
    EXPECT_NEAR(trimmed, beyond * 20.0 * std::sin(0.01 * Pi), 1e-9);
    std::vector<Point2> points = first.Points;
    points.insert(points.end(), next.Points.begin(), next.Points.end());
    EXPECT_NEAR(AreaOf(points), AreaOf(Arc(0, 99).Points), 1e-9);
  }
  OpenCurve first = Arc(0, 49), next = Arc(51, 99);
  EXPECT_EQ(TrimOverlap(first.Points, next.Points), 0.0);
  EXPECT_EQ(first.Points.size(), 50u);
  EXPECT_EQ(next.Points.size(), 49u);
}
