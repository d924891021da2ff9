// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/MakesFold.h"

#include <gtest/gtest.h>

using namespace orthoslices;

namespace
{
/// A tetrahedron above the plane z = 0 whose last point may move.
const std::vector<Point3> Points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.3, 0.3, 1 } };

CornerTable Tetrahedron() { return { 4, { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } } }; }

SurfaceChange MoveTo(const Point3& place)
{
  return { { 1, 2, 3 }, { { 3, 0, 1 }, { 3, 1, 2 }, { 3, 2, 0 } }, 3, place };
}
}

TEST(MakesFold, IfTrianglesNearlyLieOnEachOther)
{
  const CornerTable corners = Tetrahedron();
  EXPECT_FALSE(MakesFold(corners, Points, MoveTo({ 0.3, 0.3, 0.5 })));
  EXPECT_FALSE(MakesFold(corners, Points, MoveTo({ 0.3, 0.3, 0.06 }))); // encloses 11 degrees
  EXPECT_TRUE(MakesFold(corners, Points, MoveTo({ 0.3, 0.3, 0.04 })));  // 7.6 degrees
  EXPECT_TRUE(MakesFold(corners, Points, MoveTo({ 0.3, 0.3, 0.02 })));
  EXPECT_TRUE(MakesFold(corners, Points, MoveTo({ 0.3, 0.3, 1e-17 })));
}

/// What is worse already may become better.
TEST(MakesFold, NotIfThereWasASharperOne)
{
  const CornerTable corners = Tetrahedron();
  std::vector<Point3> flat = Points;
  flat[3] = { 0.3, 0.3, 0.01 };
  EXPECT_FALSE(MakesFold(corners, flat, MoveTo({ 0.3, 0.3, 0.02 })));
  EXPECT_TRUE(MakesFold(corners, flat, MoveTo({ 0.3, 0.3, 0.005 })));
}

/// A split, of which the point is new, and triangles around it that stay.
TEST(MakesFold, AtTheSidesOfTrianglesThatStay)
{
  const CornerTable corners = Tetrahedron();
  SurfaceChange split{ { 0 }, { { 4, 0, 2 }, { 4, 2, 1 }, { 4, 1, 0 } }, 4, { 0.3, 0.3, -0.2 } };
  EXPECT_FALSE(MakesFold(corners, Points, split));
  split.Place = { 0.32, 0.1, 0.33 }; // close to the triangle above the side from 0 to 1
  EXPECT_TRUE(MakesFold(corners, Points, split));
}

TEST(IsFolded, IfTrianglesAtAnEdgeEncloseLessThanTenDegrees)
{
  const CornerTable corners = Tetrahedron();
  std::vector<Point3> points = Points;
  EXPECT_FALSE(IsFolded(corners, points, 4)); // between the bottom and what stands on it
  points[3] = { 0.3, 0.3, 0.04 };
  const Index edge = corners.FindEdge(0, 1);
  EXPECT_TRUE(IsFolded(corners, points, edge));
  EXPECT_TRUE(IsFolded(corners, points, corners.OppositeOf(edge)));
  EXPECT_FALSE(IsFolded(corners, points, corners.FindEdge(0, 3)));
  points[3] = { 0.3, 0.3, 0.0 };
  EXPECT_TRUE(IsFolded(corners, points, edge));
}
