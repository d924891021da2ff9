// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/JunctionFit.h"

#include "Core/Base/Vectors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;

namespace
{
/// A square around the origin on a paraboloid over x and y.
std::vector<BorderSide> Paraboloid(double curvature)
{
  std::vector<Point3> points;
  constexpr int parts = 8;
  const Point2 corners[5] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 }, { -1, -1 } };
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < parts; ++i)
    {
      const Point2 p = Between(corners[side], corners[side + 1], double(i) / parts);
      points.push_back({ p[0], p[1], curvature * (p[0] * p[0] + p[1] * p[1]) });
    }
  }
  std::vector<BorderSide> sides;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    sides.push_back({ points[i], points[(i + 1) % points.size()] });
  }
  return sides;
}
}

TEST(JunctionFit, RunsStraightWithoutASurface)
{
  const JunctionFit fit({ -1, 0, 0 }, { 1, 0, 2 });
  Point3 place, normal;
  fit.Evaluate(0.25, place, normal);
  EXPECT_EQ(place, (Point3{ -0.5, 0.0, 0.5 }));
  EXPECT_EQ(normal, (Point3{ 0.0, 0.0, 0.0 }));
}

TEST(JunctionFit, RunsOnTheSurface)
{
  JunctionFit fit({ -1, 0, 0.2 }, { 1, 0, 0.2 });
  ASSERT_TRUE(fit.Try(Paraboloid(0.2)));
  Point3 place, normal;
  fit.Evaluate(0.5, place, normal);
  EXPECT_NEAR(place[2], 0.0, 0.01);
  EXPECT_NEAR(std::abs(normal[2]), 1.0, 1e-3);
  fit.Evaluate(1.0, place, normal);
  EXPECT_NEAR(Length(place - Point3{ 1, 0, 0.2 }), 0.0, 1e-12);
  fit.Evaluate(0.75, place, normal);
  EXPECT_NEAR(place[2], 0.05, 0.01);
  EXPECT_NEAR(normal[0] / normal[2], -0.2, 0.02);
}

/// Of two surfaces the smoother one counts, whichever comes first.
TEST(JunctionFit, TakesTheSmootherSurface)
{
  std::vector<BorderSide> folded = Paraboloid(0.0);
  for (BorderSide& side : folded)
  {
    side.From[2] = -0.5 * std::abs(side.From[0]);
    side.To[2] = -0.5 * std::abs(side.To[0]);
  }
  for (const bool foldedFirst : { false, true })
  {
    JunctionFit fit({ 0, -1, 0 }, { 0, 1, 0 });
    EXPECT_TRUE(fit.Try(foldedFirst ? folded : Paraboloid(0.1)));
    EXPECT_EQ(fit.Try(foldedFirst ? Paraboloid(0.1) : folded), foldedFirst);
    Point3 place, normal;
    fit.Evaluate(0.5, place, normal);
    EXPECT_NEAR(place[2], -0.1, 0.02);
  }
}
