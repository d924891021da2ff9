// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/MeshImprover.h"

#include "Core/Base/TriangleDistance.h"
#include "Core/Improve/MakesFold.h"
#include "Core/Surface/TriangleMeasures.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/ClosedMeshes.h"
#include "Support/ThreadRanks.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Rings of 16 points that lie alternately `gap` and much more apart.
PlainMesh BallOfPairs(double gap) { return support::BallOfPairs(16, -0.75, 0.25, gap); }

ImprovableMesh Improvable(const PlainMesh& mesh)
{
  const std::size_t count = mesh.Points.size();
  return { CornerTable(static_cast<Index>(count), mesh.Triangles), mesh.Points, mesh.Points };
}

/// In a grid without planes, which bounds nothing.
void Improve(const ImprovementLimits& limits, ImprovableMesh& mesh,
  const Execution& execution = Execution(), const Ranks& ranks = Ranks())
{
  SpatialGrid grid;
  grid.Lowest = { -10.0, -10.0, -10.0 };
  grid.Highest = { 10.0, 10.0, 10.0 };
  MeshImprover(grid, limits, execution, mesh, ranks).Run();
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
  Improve({ tolerance, 25.0 }, mesh);
  const TriangleMesh after = Plain(mesh);
  EXPECT_GT(QualityOf(after).SmallestAngle, 12.0);
  EXPECT_GT(QualityOf(after).ShareAbove20Degrees, 0.97);
  EXPECT_LT(after.Triangles.size(), 0.75 * before.Triangles.size());
  EXPECT_LT(DistanceOf(before.Points, after), 1.5001 * tolerance);
  const SurfaceCheck check = CheckSurface(after);
  EXPECT_TRUE(check.IsClosedManifold());
  EXPECT_EQ(after.Points.size() * 2, after.Triangles.size() + 4); // a sphere
}

//----------------------------------------------------------------------------
/// Splits do not move the surface, so that they are done without a tolerance, too; nothing else is,
/// as the rings are no planes.
TEST(MeshImprover, NothingMovesWithoutTolerance)
{
  const PlainMesh before = BallOfPairs(0.004);
  ImprovableMesh mesh = Improvable(before);
  Improve({ 0.0, 25.0 }, mesh);
  ASSERT_GE(mesh.Points.size(), before.Points.size());
  mesh.Points.resize(before.Points.size());
  EXPECT_EQ(mesh.Points, before.Points);
}

//----------------------------------------------------------------------------
TEST(MeshImprover, KeptPointsStay)
{
  const PlainMesh before = BallOfPairs(0.004);
  ImprovableMesh mesh = Improvable(before);
  ImprovementLimits limits{ 0.01, 25.0 };
  limits.Kept = static_cast<Index>(before.Points.size()) / 2;
  Improve(limits, mesh);
  bool changed = false;
  for (Index i = 0; i < static_cast<Index>(before.Points.size()); ++i)
  {
    const bool stays = mesh.Corners.IsUsed(i) && mesh.Points[i] == before.Points[i];
    EXPECT_TRUE(stays || i >= limits.Kept);
    changed |= !stays;
  }
  EXPECT_TRUE(changed);
}

//----------------------------------------------------------------------------
/// The walls of a slim prism: there is nothing to collapse within the tolerance.
TEST(MeshImprover, LongTrianglesAreSplit)
{
  const PlainMesh before = RingMesh(6, { 0.1, 0.1, 0.1 }, { 0.0, 0.4, 0.8 }, -0.05, 0.85);
  ImprovableMesh mesh = Improvable(before);
  mesh.Normals.assign(before.Points.size(), { 0.0, 0.0, 0.0 });
  EXPECT_LT(QualityOf(Plain(mesh)).SmallestAngle, 15.0);
  Improve({ 0.002, 22.0 }, mesh);
  const TriangleMesh after = Plain(mesh);
  EXPECT_GT(QualityOf(after).SmallestAngle, 20.0);
  EXPECT_GT(after.Triangles.size(), before.Triangles.size());
  EXPECT_EQ(mesh.Origins.size() + before.Triangles.size(),
    static_cast<std::size_t>(mesh.Corners.CornerCount()) / 3);
  EXPECT_LT(DistanceOf(before.Points, after), 0.0031);
  EXPECT_EQ(DescribeFlaws(after), "");
}

//----------------------------------------------------------------------------
/// However often the surface is changed: no sum of small moves.
TEST(MeshImprover, PointsStayWithinTheTolerance)
{
  for (const double tolerance : { 0.003, 0.02, 0.1 })
  {
    const PlainMesh before = BallOfPairs(0.01);
    ImprovableMesh mesh = Improvable(before);
    Improve({ tolerance, 25.0 }, mesh);
    EXPECT_LT(DistanceOf(before.Points, Plain(mesh)), 1.5001 * tolerance);
    EXPECT_EQ(DescribeFlaws(Plain(mesh)), "");
  }
}

//----------------------------------------------------------------------------
TEST(MeshImprover, TheSameForAnyNumberOfThreads)
{
  ImprovableMesh one = Improvable(BallOfPairs(0.004)), many = one;
  Improve({ 0.01, 25.0 }, one);
  Improve({ 0.01, 25.0 }, many, ManyThreads());
  EXPECT_EQ(one.Points, many.Points);
  EXPECT_EQ(one.Corners.ListTriangles(), many.Corners.ListTriangles());
}

namespace
{
/// A ball whose rings of points lie alternately close together and apart, as slivers all over it.
PlainMesh LargeBallOfPairs() { return support::BallOfPairs(120, -0.96, 0.05, 0.002); }
}

//----------------------------------------------------------------------------
/// A surface of several blocks has no seams: what lies at the faces of some is improved in others.
TEST(MeshImprover, BlocksLeaveNoSeams)
{
  const PlainMesh before = LargeBallOfPairs();
  ImprovableMesh mesh = Improvable(before);
  const double tolerance = 0.01;
  Improve({ tolerance, 22.0 }, mesh);
  const TriangleMesh after = Plain(mesh);
  EXPECT_GT(QualityOf(after).ShareAbove20Degrees, 0.99);
  EXPECT_EQ(DescribeFlaws(after), "");
  EXPECT_LT(after.Triangles.size(), 0.6 * before.Triangles.size());
  EXPECT_EQ(mesh.Origins.size() + before.Triangles.size(),
    static_cast<std::size_t>(mesh.Corners.CornerCount()) / 3);
  std::vector<Point3> some;
  for (std::size_t i = 0; i < before.Points.size(); i += 37)
  {
    some.push_back(before.Points[i]);
  }
  EXPECT_LT(DistanceOf(some, after), 1.7001 * tolerance);
}

//----------------------------------------------------------------------------
TEST(MeshImprover, BlocksAreTheSameForAnyNumberOfThreads)
{
  ImprovableMesh one = Improvable(LargeBallOfPairs()), many = one;
  Improve({ 0.01, 22.0 }, one);
  Improve({ 0.01, 22.0 }, many, ManyThreads());
  EXPECT_EQ(one.Points, many.Points);
  EXPECT_EQ(one.Corners.ListTriangles(), many.Corners.ListTriangles());
  EXPECT_EQ(one.Origins, many.Origins);
}

//----------------------------------------------------------------------------
/// Processes improve a surface together: each a part of it, of which the others hear, so that all
/// have the surface that one alone makes.
TEST(MeshImprover, BlocksAreTheSameForAnyNumberOfProcesses)
{
  const PlainMesh before = LargeBallOfPairs();
  ImprovableMesh alone = Improvable(before);
  Improve({ 0.01, 22.0 }, alone);
  for (const int count : { 2, 3, 7 })
  {
    ThreadRanks group(count);
    group.ForAll(
      [&](Ranks ranks)
      {
        std::size_t handedOn = 0;
        ranks.Gather = [&handedOn, gather = ranks.Gather](const Ranks::Bytes& own)
        {
          handedOn += own.size();
          return gather(own);
        };
        ImprovableMesh mesh = Improvable(before);
        Improve({ 0.01, 22.0 }, mesh, Execution(), ranks);
        EXPECT_EQ(mesh.Points, alone.Points);
        EXPECT_EQ(mesh.Corners.ListTriangles(), alone.Corners.ListTriangles());
        EXPECT_EQ(mesh.Origins, alone.Origins);
        EXPECT_GT(handedOn, count < 7 ? std::size_t(10000) : std::size_t(0));
      });
  }
}

namespace
{
/// A cone over a polygon that turns back, and a nearly flat one on it: from its apex the side that
/// turns back is seen from behind, so triangles lie on each other. All are well shaped.
PlainMesh FoldedFan()
{
  constexpr double degree = 3.14159265358979323846 / 180.0;
  const std::vector<double> angles{ 0.0, 60.0, 30.0, 120.0, 180.0, 240.0, 300.0 };
  PlainMesh mesh;
  const Index count = static_cast<Index>(angles.size());
  for (Index i = 0; i < count; ++i)
  {
    const double radius = i == 2 ? 0.6 : 1.0;
    mesh.Points.push_back(
      { radius * std::cos(degree * angles[i]), radius * std::sin(degree * angles[i]), 0.0 });
    mesh.Triangles.push_back({ i, (i + 1) % count, count });
    mesh.Triangles.push_back({ (i + 1) % count, i, count + 1 });
  }
  mesh.Points.push_back({ 0.0, 0.0, 1e-4 });
  mesh.Points.push_back({ 0.0, 0.0, -1.0 });
  return mesh;
}

/// A wedge of 4.6 degrees, blunt at one end of its edge by a side between the first two points.
PlainMesh BluntWedge(double width)
{
  PlainMesh mesh;
  mesh.Points = { { 0.0, 0.0, 0.5 * width }, { 0.0, 0.0, -0.5 * width }, { 1.0, 0.0, 0.0 },
    { 0.5, 1.0, 0.04 }, { 0.5, 1.0, -0.04 }, { 0.2, 0.5, 0.0 } };
  mesh.Triangles = { { 0, 2, 3 }, { 1, 4, 2 }, { 0, 1, 2 }, { 2, 4, 3 }, { 0, 3, 5 }, { 3, 4, 5 },
    { 4, 1, 5 }, { 1, 0, 5 } };
  return mesh;
}

int CountFolds(const ImprovableMesh& mesh)
{
  const CornerTable corners(mesh.Corners.PointCount(), mesh.Corners.ListTriangles());
  int folds = 0;
  for (Index corner = 0; corner < corners.CornerCount(); ++corner)
  {
    folds += corners.OppositeOf(corner) > corner && IsFolded(corners, mesh.Points, corner) ? 1 : 0;
  }
  return folds;
}
}

//----------------------------------------------------------------------------
/// Triangles that lie on each other are well shaped, but no mesh generator takes them.
TEST(MeshImprover, FoldsAreOpened)
{
  const PlainMesh before = FoldedFan();
  ImprovableMesh mesh = Improvable(before);
  mesh.Normals.assign(before.Points.size(), { 0.0, 0.0, 0.0 });
  EXPECT_EQ(CountFolds(mesh), 2);
  ImprovementLimits limits{ 0.2, 22.0 };
  limits.Kept = static_cast<Index>(before.Points.size());
  Improve(limits, mesh);
  EXPECT_EQ(CountFolds(mesh), 0);
  EXPECT_EQ(DescribeFlaws(Plain(mesh)), "");
  EXPECT_EQ(mesh.Points, before.Points);
}

//----------------------------------------------------------------------------
/// The ends of a side that is tiny against the tolerance become one, though this makes a fold: that
/// was there before, but for its rim.
TEST(MeshImprover, TinySidesGo)
{
  const PlainMesh before = BluntWedge(1e-5);
  ImprovableMesh mesh = Improvable(before);
  mesh.Normals.assign(before.Points.size(), { 0.0, 0.0, 0.0 });
  const double tolerance = 0.002;
  EXPECT_LT(QualityOf(Plain(mesh)).SmallestAngle, 0.001);
  Improve({ tolerance, 22.0 }, mesh);
  EXPECT_GT(QualityOf(Plain(mesh)).SmallestAngle, 2.0);
  EXPECT_EQ(DescribeFlaws(Plain(mesh)), "");
  EXPECT_LT(DistanceOf(before.Points, Plain(mesh)), 1.7001 * tolerance);
}

//----------------------------------------------------------------------------
/// The apex of a nearly flat cone on a plane: what comes through the plane beside it nearly touched it.
TEST(MeshImprover, PressedPointsMoveAwayFromPlanes)
{
  PlainMesh before;
  for (Index i = 0; i < 6; ++i)
  {
    const double angle = 3.14159265358979323846 / 3.0 * i;
    before.Points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    before.Triangles.push_back({ i, (i + 1) % 6, 6 });
    before.Triangles.push_back({ (i + 1) % 6, i, 7 });
  }
  before.Points.push_back({ 0.0, 0.0, 1e-6 });
  before.Points.push_back({ 0.0, 0.0, -1.0 });
  ImprovableMesh mesh = Improvable(before);
  mesh.FirstInside = 6;
  SpatialGrid grid;
  grid.Planes[2] = { -2.0, 0.0 };
  grid.Lowest = { -10.0, -10.0, -10.0 };
  grid.Highest = { 10.0, 10.0, 10.0 };
  const double tolerance = 0.01;
  MeshImprover(grid, { tolerance, 22.0 }, Execution(), mesh).Run();
  EXPECT_GT(mesh.Points[6][2], 0.5 * tolerance);
  EXPECT_LT(mesh.Points[6][2], 1.7001 * tolerance);
  EXPECT_EQ(DescribeFlaws(Plain(mesh)), "");
}
