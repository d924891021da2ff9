// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/BalancedCurve.h"

#include "Core/Base/Vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;

namespace
{
/// A quarter of the unit circle, counter-clockwise.
std::vector<Point2> Quarter()
{
  std::vector<Point2> curve;
  for (int i = 0; i <= 90; ++i)
  {
    const double angle = i * 3.14159265358979323846 / 180.0;
    curve.push_back({ std::cos(angle), std::sin(angle) });
  }
  return curve;
}
}

//----------------------------------------------------------------------------
TEST(BalancedCurve, LiesOnBothSidesOfTheCurve)
{
  const BalancedCurve light = BalanceCurve(Quarter(), 0.01);
  ASSERT_GE(light.Vertices.size(), 2u);
  EXPECT_LT(light.Vertices.size(), 8u);
  EXPECT_EQ(light.Vertices.size(), light.Places.size());
  for (std::size_t i = 0; i < light.Vertices.size(); ++i)
  {
    EXPECT_GT(Length(light.Vertices[i]), 1.0);
    EXPECT_LT(Length(light.Vertices[i]), 1.02);
  }
  // The ends would have to move outwards, too.
  EXPECT_GT(light.Bulges[0][0], 0.0);
  EXPECT_GT(light.Bulges[1][1], 0.0);
}

//----------------------------------------------------------------------------
TEST(BalancedCurve, TheSameBackwards)
{
  std::vector<Point2> curve = Quarter();
  const BalancedCurve forwards = BalanceCurve(curve, 0.01);
  std::reverse(curve.begin(), curve.end());
  const BalancedCurve backwards = BalanceCurve(curve, 0.01);
  ASSERT_EQ(forwards.Vertices.size(), backwards.Vertices.size());
  for (std::size_t i = 0; i < forwards.Vertices.size(); ++i)
  {
    EXPECT_LT(
      Distance(forwards.Vertices[i], backwards.Vertices[backwards.Vertices.size() - 1 - i]), 1e-9);
  }
}
