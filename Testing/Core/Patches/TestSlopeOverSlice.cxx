// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/SlopeOverSlice.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;

namespace
{
Point2 OnCircle(int i, int count)
{
  const double angle = 2.0 * 3.14159265358979323846 * i / count;
  return { std::cos(angle), std::sin(angle) };
}

void ExpectSlope(const Point2& found, double u, double v, double tolerance)
{
  EXPECT_NEAR(found[0], u, tolerance);
  EXPECT_NEAR(found[1], v, tolerance);
}
}

//----------------------------------------------------------------------------
/// The height (1 - x^2 - y^2) / 2 * (1 + c x) is zero on the unit circle.
TEST(SlopeOverSlice, OfACubicThatVanishesOnACircleIsExact)
{
  for (const double c : { 0.0, 0.3 })
  {
    SlopeOverSlice slope;
    slope.Start({ 0.1, -0.2 }, 1.3);
    const auto expected = [c](const Point2& p) -> Point2 {
      return { -p[0] * (1.0 + c * p[0]), -p[1] * (1.0 + c * p[0]) };
    };
    for (int i = 0; i < 24; ++i)
    {
      const Point2 place = OnCircle(i, 24);
      slope.AddZero(place);
      if (i % 4 == 0)
      {
        slope.AddSlope(place, expected(place));
      }
    }
    ASSERT_TRUE(slope.Fit());
    for (int i = 0; i < 24; ++i)
    {
      const Point2 place = OnCircle(i, 24), at = expected(place);
      ExpectSlope(slope.SlopeAt(place), at[0], at[1], 1e-6);
    }
  }
}

//----------------------------------------------------------------------------
TEST(SlopeOverSlice, OfAPlaneAlongALine)
{
  SlopeOverSlice slope;
  slope.Start({ 0.0, 0.0 }, 1.0);
  for (int i = -5; i <= 5; ++i)
  {
    slope.AddZero({ 0.2 * i, 0.0 });
  }
  slope.AddSlope({ -1.0, 0.0 }, { 0.0, 2.0 });
  slope.AddSlope({ 1.0, 0.0 }, { 0.0, 2.0 });
  ASSERT_TRUE(slope.Fit());
  ExpectSlope(slope.SlopeAt({ 0.37, 0.0 }), 0.0, 2.0, 1e-4);
}

//----------------------------------------------------------------------------
/// Where the contour is and how large it is must not matter, if center and size say so.
TEST(SlopeOverSlice, DoesNotDependOnPlaceAndSize)
{
  const auto slopeAt = [](const Point2& center, double size)
  {
    SlopeOverSlice slope;
    slope.Start(center, size);
    for (int i = 0; i < 10; ++i)
    {
      const Point2 p = OnCircle(i, 20);
      const Point2 place{ center[0] + size * p[0], center[1] + size * p[1] };
      slope.AddZero(place);
      if (i % 3 == 0)
      {
        slope.AddSlope(place, { -0.5 * p[0] / size, (0.1 * i - p[1]) / size });
      }
    }
    EXPECT_TRUE(slope.Fit());
    const Point2 p = OnCircle(5, 20);
    const Point2 found = slope.SlopeAt({ center[0] + size * p[0], center[1] + size * p[1] });
    return Point2{ size * found[0], size * found[1] };
  };
  const Point2 here = slopeAt({ 0.0, 0.0 }, 1.0), there = slopeAt({ 128.0, -64.0 }, 16.0);
  EXPECT_GT(std::hypot(here[0], here[1]), 0.1);
  ExpectSlope(there, here[0], here[1], 1e-7);
}

//----------------------------------------------------------------------------
TEST(SlopeOverSlice, StartForgets)
{
  SlopeOverSlice slope;
  for (const double rise : { 5.0, 1.0 })
  {
    slope.Start({ 0.0, 0.0 }, 1.0);
    for (int i = -5; i <= 5; ++i)
    {
      slope.AddZero({ 0.2 * i, 0.0 });
    }
    slope.AddSlope({ 0.0, 0.0 }, { 0.0, rise });
    ASSERT_TRUE(slope.Fit());
    ExpectSlope(slope.SlopeAt({ 0.0, 0.0 }), 0.0, rise, 1e-4);
  }
}

//----------------------------------------------------------------------------
/// The flattest height is taken where nothing is known.
TEST(SlopeOverSlice, WithoutKnownSlopesIsZero)
{
  SlopeOverSlice slope;
  slope.Start({ 0.0, 0.0 }, 1.0);
  slope.AddZero({ 0.5, 0.0 });
  ASSERT_TRUE(slope.Fit());
  ExpectSlope(slope.SlopeAt({ 0.2, 0.3 }), 0.0, 0.0, 1e-12);
}
