// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/PressedPoints.h"

#include <gtest/gtest.h>

using namespace orthoslices;

namespace
{
SpatialGrid GridOfPlanes()
{
  SpatialGrid grid;
  grid.Planes = { { { 0.0, 1.0 }, {}, { 2.0 } } };
  return grid;
}
}

TEST(FindPressing, IsNearAPlaneButNotAtIt)
{
  const SpatialGrid grid = GridOfPlanes();
  EXPECT_EQ(FindPressing(grid, { 0.5, 0.0, 0.0 }, 0.01).Axis, -1);
  EXPECT_EQ(FindPressing(grid, { 1.0, 0.0, 2.0 }, 0.01).Axis, -1);
  const PressedPoint below = FindPressing(grid, { 0.999, 0.0, 0.0 }, 0.01);
  EXPECT_EQ(below.Axis, 0);
  EXPECT_EQ(below.Way, -1.0);
  const PressedPoint above = FindPressing(grid, { 1.0, 0.0, 2.001 }, 0.01);
  EXPECT_EQ(above.Axis, 2);
  EXPECT_EQ(above.Way, 1.0);
  EXPECT_EQ(FindPressing(grid, { 0.999, 0.0, 2.001 }, 0.01, 1).Axis, 2);
}

/// The top of a tetrahedron whose base lies in a plane, or across it.
TEST(FindPressing, OnlyIfATriangleLiesInThePlane)
{
  const SpatialGrid grid = GridOfPlanes();
  const CornerTable corners(4, { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
  std::vector<Point3> points{ { 0.3, 0.2, 2.0 }, { 0.6, 0.2, 2.0 }, { 0.3, 0.6, 2.0 },
    { 0.4, 0.3, 2.001 } };
  EXPECT_EQ(FindPressing(grid, corners, points, 3, 0.01).Axis, 2);
  points[1][2] = points[2][2] = 1.9;
  EXPECT_EQ(FindPressing(grid, corners, points, 3, 0.01).Axis, -1);
}
