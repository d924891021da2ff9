// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   objects that the border of the image cuts off end flat there, with an edge
 */

#include "Core/BorderCaps.h"

#include "Core/Reconstruct.h"
#include "Core/Slices/BorderSlices.h"
#include "Support/AnalyticSolids.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/Damage.h"
#include "Support/NearestTriangle.h"
#include "Support/Random.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SliceSolid.h"
#include "Support/TextContours.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Border = 0.43;

Solid Ball()
{
  Solid solid;
  solid.Low = { -1.1, -1.1, -1.1 };
  solid.High = { 1.1, 1.1, 1.1 };
  solid.Function = [](const Point3& p) { return Length(p) - 1.0; };
  return solid;
}

PieceSets CutBall(int axis, bool below)
{
  PieceSets sets = SliceSolid(Ball(), EqualPlanes(Ball(), { 9, 9, 9 }), 12, InPlaneGrid::Free);
  CutOff(sets, axis, below ? Border : -Border, below);
  return sets;
}

/// The greatest distance of the rim where the border cuts the ball from a surface.
double DistanceOfRim(const TriangleMesh& mesh, int axis, double border)
{
  std::vector<NearestTriangle::Triangle> triangles;
  for (const auto& t : mesh.Triangles)
  {
    triangles.push_back({ mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]] });
  }
  const NearestTriangle nearest(std::move(triangles));
  const double radius = std::sqrt(1.0 - border * border);
  double greatest = 0.0;
  for (int i = 0; i < 360; ++i)
  {
    Point3 p;
    p[axis] = border;
    p[FirstAxis(axis)] = radius * std::cos(i * Pi / 180.0);
    p[SecondAxis(axis)] = radius * std::sin(i * Pi / 180.0);
    greatest = std::max(greatest, nearest.Find(p).Distance);
  }
  return greatest;
}
}

//----------------------------------------------------------------------------
TEST(ContinueBeyond, PartsOnTheBorderMoveOut)
{
  Contours contours = ParseContours("z=0: 0,0 3,0 3,1 3,2 0,2; z=1: 1,1 2,1 2,2; x=1: 0,0 2,0 2,1");
  Box3 border = Everywhere();
  border.High[0] = 3.0;
  const Contours moved = ContinueBeyond(contours, border, { 0.5, 0.5, 0.5 });
  ASSERT_EQ(moved.Count(), contours.Count());
  const Index first = moved.Axis[0] == 2 ? 0 : 1;
  std::vector<Point2> points;
  for (Index i = moved.Offsets[first]; i < moved.Offsets[first + 1]; ++i)
  {
    points.push_back({ moved.U[i], moved.V[i] });
  }
  EXPECT_EQ(points,
    (std::vector<Point2>{
      { 0, 0 }, { 3, 0 }, { 3.5, 0 }, { 3.5, 1 }, { 3.5, 2 }, { 3, 2 }, { 0, 2 } }));
  EXPECT_EQ(moved.U.size(), contours.U.size() + 2);
}

//----------------------------------------------------------------------------
TEST(BorderCaps, TheSurfaceEndsFlatWithAnEdge)
{
  const double height = 1.0 - Border;
  const double volume = 4.0 / 3.0 * Pi - Pi * height * height * (3.0 - height) / 3.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool below : { true, false })
    {
      SCOPED_TRACE(std::to_string(axis) + (below ? " below" : " above"));
      const double side = below ? Border : -Border;
      const Reconstruction result = Reconstruct(CutBall(axis, below), Options(), Execution());
      const TriangleMesh mesh = MeshOf(result);
      EXPECT_EQ(DescribeFlaws(mesh), "");
      EXPECT_EQ(result.Topology.Components, 1);
      EXPECT_EQ(result.Topology.Genus, 0);
      const double spacing = result.Grid.SpacingAtEnds[axis];
      EXPECT_LT(DistanceOfRim(mesh, axis, side), 0.005 * spacing);
      EXPECT_NEAR(CheckSurface(mesh).TotalVolume() / volume, 1.0, 1e-3);
      for (const Point3& p : mesh.Points)
      {
        EXPECT_LE((below ? 1.0 : -1.0) * (p[axis] - side), 0.0021 * spacing);
      }
    }
  }
}

//----------------------------------------------------------------------------
TEST(BorderCaps, TheResultDependsOnNoThreads)
{
  const TriangleMesh one = MeshOf(Reconstruct(CutBall(0, true), Options(), Execution()));
  const TriangleMesh many = MeshOf(Reconstruct(CutBall(0, true), Options(), ManyThreads()));
  EXPECT_EQ(one.Points, many.Points);
  EXPECT_EQ(one.Triangles, many.Triangles);
}

//----------------------------------------------------------------------------
/// The slices on the border are nobody's: what is said of the input stays the same.
TEST(BorderCaps, TheReportIsThatOfTheSlices)
{
  const Reconstruction result = Reconstruct(CutBall(1, true), Options(), Execution());
  EXPECT_TRUE(result.Grid.HasVirtual());
  EXPECT_EQ(result.Grid.Count(1) - 1,
    std::count(result.Grid.Virtual[1].begin(), result.Grid.Virtual[1].end(), std::uint8_t(0)));
  EXPECT_TRUE(result.Repairs.empty());
  EXPECT_TRUE(result.Undecided.Places.empty());
}

//----------------------------------------------------------------------------
/// Solids of any topology, cut off at any sides, with any numbers of slices.
TEST(BorderCaps, AnythingCutOffIsClosedAndEmbedded)
{
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(25); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Solid solid = random.Chance(0.5) ? RandomSolid(seed) : TiltedTorus();
    std::array<int, 3> counts;
    for (int& count : counts)
    {
      count = 2 + static_cast<int>(random.Below(9));
    }
    PieceSets sets = SliceSolid(solid, EqualPlanes(solid, counts), 8, InPlaneGrid::Free);
    for (int cut = 0; cut < 2; ++cut)
    {
      const int axis = static_cast<int>(random.Below(3));
      const bool below = random.Chance(0.5);
      const double share = below ? random.Uniform(0.5, 0.9) : random.Uniform(0.1, 0.5);
      const double border = solid.Low[axis] + share * (solid.High[axis] - solid.Low[axis]);
      CutOff(sets, axis, std::round(64.0 * border) / 64.0, below);
    }
    Options options;
    options.SinglePrecision = random.Chance(0.5);
    options.Virtual = random.Chance(0.2) ? VirtualSlices::Automatic : VirtualSlices::Off;
    options.Patching.Method = random.Chance(0.2) ? PatchMethod::Fan : options.Patching.Method;
    options.ContourTolerance = random.Chance(0.2) ? 0.01 : 0.0;
    const Reconstruction result = Reconstruct(PieceSets(sets), options, Execution());
    TriangleMesh mesh = MeshOf(result);
    for (Point3& p : mesh.Points)
    {
      for (double& x : p)
      {
        volatile float rounded = static_cast<float>(x);
        x = options.SinglePrecision ? rounded : x;
      }
    }
    EXPECT_EQ(DescribeFlaws(mesh), "");
  }
}
