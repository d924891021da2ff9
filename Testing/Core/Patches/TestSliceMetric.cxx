// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/SliceMetric.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Point3 RandomVector(Random& random)
{
  return { random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0) };
}

/// Axes inclined by up to some 30 degrees.
AxisFrame RandomFrame(Random& random)
{
  std::array<Point3, 3> normals;
  for (int axis = 0; axis < 3; ++axis)
  {
    normals[axis] = 0.4 * RandomVector(random);
    normals[axis][axis] += 1.0;
    normals[axis] = Unit(normals[axis]);
  }
  return AxisFrame(normals);
}

/// A vector along the axes that lies within the slices across one of them.
Point3 RandomWithin(int axis, Random& random)
{
  Point3 vector = RandomVector(random);
  vector[axis] = 0.0;
  return vector;
}
}

//----------------------------------------------------------------------------
TEST(SliceMetric, LengthsAndAnglesAreThoseOfTheWorld)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    Random random(seed);
    const AxisFrame frame = RandomFrame(random);
    for (const int axis : { 0, 1, 2 })
    {
      const SliceMetric metric(frame, axis);
      const Point3 a = RandomWithin(axis, random), b = RandomWithin(axis, random);
      const Point2 p = metric.ToTrue(a), q = metric.ToTrue(b);
      const Point3 inWorldA = frame.ToWorld(a), inWorldB = frame.ToWorld(b);
      EXPECT_NEAR(p[0] * q[0] + p[1] * q[1], Dot(inWorldA, inWorldB), 1e-12);
      EXPECT_NEAR(
        p[0] * q[1] - p[1] * q[0], Dot(Cross(inWorldA, inWorldB), frame.Normal(axis)), 1e-12);
      EXPECT_LT(Length(metric.ToAxes(p[0], p[1]) - a), 1e-12);
    }
  }
}

//----------------------------------------------------------------------------
/// Normals stay at right angles to tangents, as long as they are in the world, and are found again.
TEST(SliceMetric, NormalsAreThoseOfTheWorld)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    Random random(seed);
    const AxisFrame frame = RandomFrame(random);
    for (const int axis : { 0, 1, 2 })
    {
      const SliceMetric metric(frame, axis);
      const Point3 along = RandomVector(random), tangent = RandomWithin(axis, random);
      const Point3 normal = metric.NormalToTrue(along);
      const Point2 inSlice = metric.ToTrue(tangent);
      EXPECT_NEAR(normal[FirstAxis(axis)] * inSlice[0] + normal[SecondAxis(axis)] * inSlice[1],
        Dot(along, tangent), 1e-12);
      EXPECT_LT(Length(metric.NormalToAxes(normal) - along), 1e-12);
      const Point3 first = RandomVector(random), second = RandomVector(random);
      const Point3 crossed = metric.NormalToTrue(frame.Volume() * Cross(first, second));
      EXPECT_NEAR(
        Length(crossed), Length(Cross(frame.ToWorld(first), frame.ToWorld(second))), 1e-12);
    }
  }
}

//----------------------------------------------------------------------------
TEST(SliceMetric, ThatOfTheWorldChangesNothing)
{
  Random random(1);
  const AxisFrame world;
  for (const int axis : { 0, 1, 2 })
  {
    const SliceMetric metric(world, axis);
    const Point3 a = RandomWithin(axis, random), n = RandomVector(random);
    const Point2 p = metric.ToTrue(a);
    EXPECT_EQ(p, (Point2{ a[FirstAxis(axis)], a[SecondAxis(axis)] }));
    EXPECT_EQ(metric.ToAxes(p[0], p[1]), a);
    EXPECT_EQ(metric.NormalToTrue(n), n);
    EXPECT_EQ(metric.NormalToAxes(n), n);
  }
}
