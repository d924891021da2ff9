// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/AxisFrame.h"

#include "Support/TurnedSlices.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(AxisFrame, WorldLeavesEverythingAsItIs)
{
  const AxisFrame world;
  EXPECT_TRUE(world.IsWorld());
  EXPECT_TRUE(world.IsRotation());
  EXPECT_TRUE(AxisFrame(UnitMatrix()).IsWorld());
  const Point3 p{ 0.1, -2.0 / 3.0, 1e300 };
  EXPECT_EQ(world.ToAxes(p), p);
  EXPECT_EQ(world.ToWorld(p), p);
}

//----------------------------------------------------------------------------
TEST(AxisFrame, CoordinatesAreDistancesAlongTheNormals)
{
  // Slices inclined by 15 degrees, as those of an inclined gantry.
  const double s = 0.25881904510252074, c = 0.9659258262890683;
  const AxisFrame frame({ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, -s, c } } });
  EXPECT_FALSE(frame.IsWorld());
  EXPECT_FALSE(frame.IsRotation());
  const Point3 p{ 3.0, -4.0, 5.0 };
  const Point3 along = frame.ToAxes(p);
  EXPECT_NEAR(along[2], 4.0 * s + 5.0 * c, 1e-14);
  EXPECT_LT(Length(frame.ToWorld(along) - p), 1e-14);
  Point3 sum{ 0.0, 0.0, 0.0 };
  for (const int axis : { 0, 1, 2 })
  {
    EXPECT_NEAR(Dot(frame.Normal(axis), frame.Edge(axis)), 1.0, 1e-14);
    sum = sum + along[axis] * frame.Edge(axis);
  }
  EXPECT_LT(Length(sum - p), 1e-14);
  EXPECT_NEAR(frame.Volume() * c, 1.0, 1e-14);
  // A surface along the planes of a family has the normal of these.
  EXPECT_LT(Length(frame.NormalToWorld({ 0.0, 0.0, 0.3 }) - frame.Normal(2)), 1e-14);
  EXPECT_EQ(frame.NormalToWorld({ 0.0, 0.0, 0.0 }), (Point3{ 0.0, 0.0, 0.0 }));
}

//----------------------------------------------------------------------------
TEST(AxisFrame, RotationsKeepLengthsAndNormals)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const Matrix3 rotation = RandomRotation(seed);
    const AxisFrame frame(rotation);
    EXPECT_TRUE(frame.IsRotation());
    const Point3 p{ 3.0, -4.0, 12.0 };
    EXPECT_NEAR(Length(frame.ToAxes(p)), 13.0, 1e-13);
    EXPECT_LT(Length(frame.ToWorld(frame.ToAxes(p)) - p), 1e-13);
    EXPECT_LT(Length(frame.NormalToWorld(frame.ToAxes(Unit(p))) - Unit(p)), 1e-14);
  }
}
