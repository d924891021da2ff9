// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/MeshImprover.h"

#include "Core/Base/TriangleDistance.h"
#include "Core/Surface/TriangleMeasures.h"
#include "Support/CheckSurface.h"
#include "Support/ClosedMeshes.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A ball of radius 1 whose rings of 16 points lie alternately `gap` and much more apart.
PlainMesh BallOfPairs(double gap)
{
  std::vector<double> heights, radii;
  for (double z = -0.75; z < 0.8; z += 0.25)
  {
    for (const double height : { z, z + gap })
    {
      heights.push_back(height);
      radii.push_back(std::sqrt(1.0 - height * height));
    }
  }
  return RingMesh(16, radii, heights, -1.0, 1.0);
}

ImprovableMesh Improvable(const PlainMesh& mesh)
{
  const std::size_t count = mesh.Points.size();
  return { CornerTable(static_cast<Index>(count), mesh.Triangles), mesh.Points, mesh.Points,
    std::vector<std::uint8_t>(count, 0) };
}

TriangleMesh Plain(const ImprovableMesh& mesh) { return CopyUsed(mesh.Corners, mesh.Points); }

TriangleQuality QualityOf(const TriangleMesh& mesh)
{
  std::vector<double> points;
  std::vector<long long> ids;
  for (const Point3& point : mesh.Points)
  {
    points.insert(points.end(), point.begin(), point.end());
  }
  for (const auto& triangle : mesh.Triangles)
  {
    ids.insert(ids.end(), triangle.begin(), triangle.end());
  }
  return MeasureQuality(
    points.data(), ids.data(), static_cast<std::int64_t>(mesh.Triangles.size()), Execution());
}

/// The greatest distance of points from a surface.
double DistanceOf(const std::vector<Point3>& points, const TriangleMesh& mesh)
{
  double farthest = 0.0;
  for (const Point3& point : points)
  {
    double nearest = HUGE_VAL;
    for (const auto& t : mesh.Triangles)
    {
      nearest = std::min(nearest,
        SquaredDistanceToTriangle(point, mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]]));
    }
    farthest = std::max(farthest, nearest);
  }
  return std::sqrt(farthest);
}
}

//----------------------------------------------------------------------------
TEST(MeshImprover, SliversGoWithinTheTolerance)
{
  const PlainMesh before = BallOfPairs(0.004);
  ImprovableMesh mesh = Improvable(before);
  const double tolerance = 0.01;
  EXPECT_LT(QualityOf(Plain(mesh)).SmallestAngle, 2.0);
  MeshImprover(SpatialGrid(), { tolerance, 25.0 }, mesh).Run();
  const TriangleMesh after = Plain(mesh);
  EXPECT_GT(QualityOf(after).SmallestAngle, 12.0);
  EXPECT_GT(QualityOf(after).ShareAbove20Degrees, 0.97);
  EXPECT_LT(after.Triangles.size(), 0.75 * before.Triangles.size());
  EXPECT_LT(DistanceOf(before.Points, after), tolerance);
  const SurfaceCheck check = CheckSurface(after);
  EXPECT_TRUE(check.IsClosedManifold());
  EXPECT_EQ(after.Points.size() * 2, after.Triangles.size() + 4); // a sphere
}

//----------------------------------------------------------------------------
TEST(MeshImprover, NothingHappensWithoutTolerance)
{
  // The rings are no planes: whatever is changed moves the surface.
  const PlainMesh before = BallOfPairs(0.004);
  ImprovableMesh mesh = Improvable(before);
  MeshImprover(SpatialGrid(), { 0.0, 25.0 }, mesh).Run();
  EXPECT_EQ(mesh.Points, before.Points);
}

//----------------------------------------------------------------------------
TEST(MeshImprover, TrianglesAtFixedPointsStay)
{
  const PlainMesh before = BallOfPairs(0.004);
  ImprovableMesh mesh = Improvable(before);
  for (std::size_t i = 0; i < before.Points.size(); ++i)
  {
    mesh.Fixed[i] = before.Points[i][0] > 0.0 ? 1 : 0;
  }
  MeshImprover(SpatialGrid(), { 0.01, 25.0 }, mesh).Run();
  bool changed = false;
  for (std::size_t t = 0; t < before.Triangles.size(); ++t)
  {
    const auto& corners = before.Triangles[t];
    const bool isFixed =
      mesh.Fixed[corners[0]] != 0 || mesh.Fixed[corners[1]] != 0 || mesh.Fixed[corners[2]] != 0;
    changed |= mesh.Changed[t] != 0;
    for (Index i = 0; isFixed && i < 3; ++i)
    {
      EXPECT_EQ(mesh.Changed[t], 0);
      EXPECT_EQ(mesh.Corners.VertexOf(static_cast<Index>(3 * t) + i), corners[i]);
      EXPECT_EQ(mesh.Points[corners[i]], before.Points[corners[i]]);
    }
  }
  EXPECT_TRUE(changed);
}
