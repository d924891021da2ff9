// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/RoundnessLoad.h"

#include "Support/ClosedMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace orthoslices
{
namespace support
{
namespace
{
constexpr double Radius = 1.5;

/// A ball of about equal triangles around the origin, in a cell of that width.
SurfaceMesh Ball(double width)
{
  std::vector<double> heights, radii;
  for (int i = 1; i < 16; ++i)
  {
    const double angle = 3.14159265358979 * i / 16.0;
    heights.push_back(-Radius * std::cos(angle));
    radii.push_back(Radius * std::sin(angle));
  }
  return FreeSurface(RingMesh(32, radii, heights, -Radius, Radius), 0.5 * width);
}

/// The force away from the origin by area, in the mean over the points away from the poles, where
/// triangles are slender.
double MeanPush(const RoundnessLoad& load, const SurfaceMesh& mesh)
{
  const auto isMeant = [&](Index point) { return std::abs(mesh.Points[point][2]) < 0.8 * Radius; };
  double push = 0.0, area = 0.0;
  for (Index corner = 0; corner < mesh.Corners.CornerCount(); ++corner)
  {
    const Index point = mesh.Corners.VertexOf(corner);
    const Point3 u = mesh.InWorld(point, mesh.Corners.StartOf(corner));
    const Point3 v = mesh.InWorld(point, mesh.Corners.EndOf(corner));
    area += isMeant(point) ? Length(Cross(u, v)) / 6.0 : 0.0;
  }
  for (Index point = 0; point < mesh.Corners.PointCount(); ++point)
  {
    push += isMeant(point) ? Dot(load.Force[point], mesh.Points[point]) / Radius : 0.0;
  }
  return push / area;
}
}

//----------------------------------------------------------------------------
/// A ball of radius r is loaded with 4 / r^3, outwards; what is fixed or stretched is not.
TEST(RoundnessLoad, BallsArePushedOutwards)
{
  SurfaceMesh mesh = Ball(1.0);
  const Index fixed = 5, stretched = 40;
  mesh.Fixed[fixed] = 1;
  mesh.Stretch[stretched] = { 2.0, 1.0, 2.0 };
  const RoundnessLoad load = KeepRound(mesh);
  ASSERT_FALSE(load.IsEmpty());
  EXPECT_NEAR(MeanPush(load, mesh), 4.0 / std::pow(Radius, 3.0), 0.05);
  for (const Index point : { fixed, stretched })
  {
    EXPECT_EQ(load.Force[point], Point3{});
    EXPECT_EQ(load.Reach[point], 0.0);
  }
  EXPECT_NEAR(load.Reach[fixed + 32 * 7], 0.25 * 0.3, 0.05); // edges are about 0.3 long
}

//----------------------------------------------------------------------------
/// What is rounder than half of the distance of planes counts as if it were not.
TEST(RoundnessLoad, CurvatureIsBoundedByTheWidthOfCells)
{
  const SurfaceMesh mesh = Ball(5.0);
  const double most = 4.0 / std::pow(2.5, 3.0);
  EXPECT_LE(MeanPush(KeepRound(mesh), mesh), most * 1.0001);
  EXPECT_GT(MeanPush(KeepRound(mesh), mesh), 0.9 * most);
}

//----------------------------------------------------------------------------
/// A cavity would shrink as well: its surface is pushed away from its middle, into the solid.
TEST(RoundnessLoad, CavitiesArePushedOutwards)
{
  SurfaceMesh mesh = Ball(1.0);
  for (Point3& point : mesh.Points)
  {
    point[0] = -point[0]; // so that normals point inwards
  }
  EXPECT_NEAR(MeanPush(KeepRound(mesh), mesh), 4.0 / std::pow(Radius, 3.0), 0.05);
}
}
}
