// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/TotalCurvature.h"

#include "Core/Base/Vectors.h"

#include <gtest/gtest.h>

using namespace orthoslices;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// A box from the origin on; its faces are flat, whatever their diagonals.
SurfaceTriangles Box(const Point3& extent)
{
  SurfaceTriangles box;
  for (int i = 0; i < 8; ++i)
  {
    box.Points.push_back({ (i & 1) != 0 ? extent[0] : 0.0, (i & 2) != 0 ? extent[1] : 0.0,
      (i & 4) != 0 ? extent[2] : 0.0 });
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const Index u = 1 << FirstAxis(axis), v = 1 << SecondAxis(axis), top = 1 << axis;
    box.Triangles.push_back({ 0, u + v, u });
    box.Triangles.push_back({ 0, v, u + v });
    box.Triangles.push_back({ top, top + u, top + u + v });
    box.Triangles.push_back({ top, top + u + v, top + v });
  }
  return box;
}
}

//----------------------------------------------------------------------------
TEST(TotalCurvature, OfABoxIsThatOfItsEdges)
{
  // Twelve edges, each a quarter turn.
  EXPECT_NEAR(TotalCurvature(Box({ 1.0, 1.0, 1.0 })), 3.0 * Pi, 1e-12);
  EXPECT_NEAR(TotalCurvature(Box({ 1.0, 2.0, 5.0 })), 8.0 * Pi, 1e-12);
}

//----------------------------------------------------------------------------
TEST(TotalCurvature, ADentAddsToIt)
{
  // A corner of a box that is pushed in: its three edges become grooves, and three diagonals rims.
  SurfaceTriangles dented = Box({ 1.0, 1.0, 1.0 });
  dented.Points[7] = { 0.2, 0.2, 0.2 };
  EXPECT_GT(TotalCurvature(dented), 1.1 * 3.0 * Pi);
}

//----------------------------------------------------------------------------
TEST(TotalCurvature, OfNothingIsNone) { EXPECT_EQ(TotalCurvature(SurfaceTriangles()), 0.0); }
