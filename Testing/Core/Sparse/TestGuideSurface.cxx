// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/GuideSurface.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;

namespace
{
/// The octahedron with corners at distance 1; the one at -z is on a contour.
SurfaceMesh Octahedron()
{
  const std::vector<Point3> points{ { 1.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 },
    { 0.0, -1.0, 0.0 }, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, -1.0 } };
  const std::vector<std::array<Index, 3>> triangles{ { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 },
    { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  SurfaceMesh mesh{ CornerTable(6, triangles), points, { 0, 0, 0, 0, 0, 1 }, {}, {}, {}, -1, {} };
  return mesh;
}
}

//----------------------------------------------------------------------------
TEST(GuideSurface, MovesTheNearestFreePointAndHoldsIt)
{
  SurfaceMesh mesh = Octahedron();
  GuideSurface({ { 0.0, 0.1, 1.2 } }, 0.5, mesh);
  EXPECT_EQ(mesh.Points[4], (Point3{ 0.0, 0.1, 1.2 }));
  EXPECT_EQ(mesh.Fixed[4], 1);
  EXPECT_EQ(std::count(mesh.Fixed.begin(), mesh.Fixed.end(), 1), 2);
}

//----------------------------------------------------------------------------
TEST(GuideSurface, OfTwoGuidesTheNearerOneCounts)
{
  SurfaceMesh mesh = Octahedron();
  GuideSurface({ { 0.0, 0.0, 1.3 }, { 0.0, 0.0, 1.1 }, { 0.0, 0.0, 1.2 } }, 0.5, mesh);
  EXPECT_EQ(mesh.Points[4], (Point3{ 0.0, 0.0, 1.1 }));
}

//----------------------------------------------------------------------------
TEST(GuideSurface, FarGuidesAndPointsOfContoursMoveNothing)
{
  SurfaceMesh mesh = Octahedron();
  const std::vector<Point3> before = mesh.Points;
  GuideSurface({ { 0.0, 0.0, 1.6 }, { 0.0, 0.0, -1.1 } }, 0.5, mesh);
  EXPECT_EQ(mesh.Points, before);
  EXPECT_EQ(std::count(mesh.Fixed.begin(), mesh.Fixed.end(), 1), 1);
}
