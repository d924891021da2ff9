// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/TriangleDistance.h"
#include "Core/Base/Vectors.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Point3 RandomPoint(Random& random)
{
  return { random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0) };
}

/// The least squared distance of many points of a triangle.
double SampledSquaredDistance(const Point3& p, const Point3& a, const Point3& b, const Point3& c)
{
  constexpr int parts = 100;
  double least = HUGE_VAL;
  for (int i = 0; i <= parts; ++i)
  {
    for (int j = 0; i + j <= parts; ++j)
    {
      const Point3 q = a + (double(i) / parts) * (b - a) + (double(j) / parts) * (c - a);
      least = std::min(least, SquaredDistance(p, q));
    }
  }
  return least;
}
}

//----------------------------------------------------------------------------
TEST(TriangleDistance, KnownValuesInEveryPartOfSpace)
{
  const Point3 a{ 0, 0, 0 }, b{ 4, 0, 0 }, c{ 0, 4, 0 };
  const auto distance2 = [&](double x, double y, double z) {
    return SquaredDistanceToTriangle({ x, y, z }, a, b, c);
  };
  EXPECT_DOUBLE_EQ(distance2(1, 1, 3), 9.0);   // above the face
  EXPECT_DOUBLE_EQ(distance2(1, 1, -3), 9.0);  // below it
  EXPECT_DOUBLE_EQ(distance2(-1, -2, 2), 9.0); // beyond the corners
  EXPECT_DOUBLE_EQ(distance2(6, -1, 2), 9.0);  //
  EXPECT_DOUBLE_EQ(distance2(-1, 6, 2), 9.0);  //
  EXPECT_DOUBLE_EQ(distance2(1, -2, 0), 4.0);  // beyond the sides
  EXPECT_DOUBLE_EQ(distance2(-2, 1, 0), 4.0);  //
  EXPECT_DOUBLE_EQ(distance2(4, 4, 1), 9.0);   //
  EXPECT_DOUBLE_EQ(distance2(0.5, 0.5, 0), 0.0);
}

//----------------------------------------------------------------------------
TEST(TriangleDistance, IsThatOfTheNearestOfManyPoints)
{
  Random random(1);
  for (int i = 0; i < 300; ++i)
  {
    const Point3 a = RandomPoint(random), b = RandomPoint(random), c = RandomPoint(random);
    const Point3 p = 2.0 * RandomPoint(random);
    const double distance = std::sqrt(SquaredDistanceToTriangle(p, a, b, c));
    const double sampled = std::sqrt(SampledSquaredDistance(p, a, b, c));
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GE(distance, sampled - 0.04); // the nearest sample is that close to any point
    EXPECT_NEAR(distance, std::sqrt(SquaredDistanceToTriangle(p, c, b, a)), 1e-9);
    EXPECT_NEAR(distance, std::sqrt(SquaredDistanceToTriangle(p, b, c, a)), 1e-9);
  }
}

//----------------------------------------------------------------------------
TEST(TriangleDistance, OfATriangleWithoutAreaIsThatOfASegment)
{
  const Point3 a{ 0, 0, 0 }, b{ 1, 0, 0 }, c{ 3, 0, 0 };
  for (const Point3& p : { Point3{ 2, 1, 0 }, Point3{ -1, 1, 1 }, Point3{ 4, 0, 2 } })
  {
    EXPECT_NEAR(SquaredDistanceToTriangle(p, a, b, c), SquaredDistanceToSegment(p, a, c), 1e-12);
    EXPECT_NEAR(SquaredDistanceToTriangle(p, c, c, c), SquaredDistance(p, c), 1e-12);
  }
}

//----------------------------------------------------------------------------
TEST(TriangleDistance, ToASegment)
{
  const Point2 a{ 1, 1 }, b{ 5, 1 };
  EXPECT_DOUBLE_EQ(DistanceToSegment({ 3, 4 }, a, b), 3.0);
  EXPECT_DOUBLE_EQ(DistanceToSegment({ -2, 5 }, a, b), 5.0);
  EXPECT_DOUBLE_EQ(DistanceToSegment({ 8, -3 }, a, b), 5.0);
  EXPECT_DOUBLE_EQ(DistanceToSegment({ 2, 1 }, a, b), 0.0);
  EXPECT_DOUBLE_EQ(DistanceToSegment({ 4, 5 }, a, a), 5.0);
  Random random(2);
  for (int i = 0; i < 200; ++i)
  {
    const Point3 p = RandomPoint(random), q = RandomPoint(random), r = RandomPoint(random);
    const double distance2 = SquaredDistanceToSegment(p, q, r);
    EXPECT_NEAR(distance2, SquaredDistanceToSegment(p, r, q), 1e-12);
    double sampled = HUGE_VAL;
    for (int k = 0; k <= 1000; ++k)
    {
      sampled = std::min(sampled, SquaredDistance(p, Between(q, r, k / 1000.0)));
    }
    EXPECT_LE(distance2, sampled + 1e-12);
    EXPECT_GE(distance2, sampled - 1e-5);
  }
  EXPECT_DOUBLE_EQ(SquaredDistanceToSegment({ 1, 2, 2 }, { 0, 0, 0 }, { 0, 0, 0 }), 9.0);
}
