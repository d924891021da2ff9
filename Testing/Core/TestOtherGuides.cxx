// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   contours on planes of no family guide the surface that bends between few slices
 *
 * A ball with a dent that no slice of the stack meets, nor either of two slices through its axis. A
 * third one does.
 */

#include "Core/ReconstructSorted.h"

#include "Support/CheckEmbedding.h"
#include "Support/NearestTriangle.h"
#include "Support/Random.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SliceSolid.h"
#include "Support/SparseSolids.h"
#include "Support/Threads.h"
#include "Support/TurnedSlices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
const double Pi = std::acos(-1.0);
constexpr Index Points = 120;
/// Where the dent is: between two of the stack's slices, at 1 / 8.
const double DentAngle = 2.0 * Pi / 3.0;
constexpr double DentDepth = 0.16;

/// The point of the ball's surface at an angle around z and a latitude; the ball has a radius of 1.
Point3 PointOfBall(double angle, double latitude)
{
  const double around = std::remainder(angle - DentAngle, 2.0 * Pi) / 0.5;
  const double along = (std::sin(latitude) - 1.0 / 8.0) / 0.1;
  const double radius = 1.0 - DentDepth * std::exp(-around * around - along * along);
  return { radius * std::cos(angle) * std::cos(latitude),
    radius * std::sin(angle) * std::cos(latitude), std::sin(latitude) };
}

void AddLoop(const std::vector<Point3>& points, Polylines& lines)
{
  for (const Point3& p : points)
  {
    lines.X.push_back(p[0]);
    lines.Y.push_back(p[1]);
    lines.Z.push_back(p[2]);
  }
  lines.Offsets.push_back(static_cast<Index>(lines.X.size()));
  lines.Closed.push_back(1);
  lines.From.Port.push_back(3);
  lines.From.Block.push_back(0);
  lines.From.Cell.push_back(static_cast<std::int64_t>(lines.From.Cell.size()));
}

/// The cut by a plane through the axis.
std::vector<Point3> CutThroughAxis(double angle)
{
  std::vector<Point3> points;
  for (Index i = 0; i < Points; ++i)
  {
    const double turn = 2.0 * Pi * (static_cast<double>(i) + 0.5) / Points;
    const double latitude = std::remainder(turn, 2.0 * Pi);
    const bool isBehind = std::abs(latitude) > 0.5 * Pi;
    points.push_back(PointOfBall(
      isBehind ? angle + Pi : angle, isBehind ? std::copysign(Pi, latitude) - latitude : latitude));
  }
  return points;
}

/// `count` slices across z.
void AddStack(int count, Polylines& lines)
{
  for (int k = 0; k < count; ++k)
  {
    std::vector<Point3> points;
    for (Index i = 0; i < Points; ++i)
    {
      points.push_back(PointOfBall(
        2.0 * Pi * static_cast<double>(i) / Points, std::asin(2.0 * (k + 0.5) / count - 1.0)));
    }
    AddLoop(points, lines);
  }
}

/// The stack and slices through the axis at these angles, in radians.
Polylines Slices(int stack, const std::vector<double>& angles)
{
  Polylines lines;
  AddStack(stack, lines);
  for (const double angle : angles)
  {
    AddLoop(CutThroughAxis(angle), lines);
  }
  return lines;
}

enum class Rule
{
  Bending,
  Field
};

Reconstruction RunCore(
  const Polylines& lines, Rule rule = Rule::Field, const Execution& execution = Execution())
{
  Options options;
  options.Virtual = VirtualSlices::Automatic;
  options.FollowField = rule == Rule::Field;
  return ReconstructSorted(SortByPlanes(lines, FrameOptions()), options, execution);
}

/// The root mean square of the distances of points from a mesh.
double DistanceFrom(const TriangleMesh& mesh, const std::vector<Point3>& points)
{
  std::vector<NearestTriangle::Triangle> triangles;
  for (const auto& t : mesh.Triangles)
  {
    triangles.push_back({ mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]] });
  }
  const NearestTriangle nearest(std::move(triangles));
  double sum = 0.0;
  for (const Point3& p : points)
  {
    const double distance = nearest.Find(p).Distance;
    sum += distance * distance;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/// Points of the true surface around the dent.
std::vector<Point3> PointsOfDent()
{
  std::vector<Point3> points;
  for (int i = -10; i <= 10; ++i)
  {
    for (int j = -10; j <= 10; ++j)
    {
      points.push_back(PointOfBall(DentAngle + 0.05 * i, std::asin(1.0 / 8.0 + 0.01 * j)));
    }
  }
  return points;
}

/// Families have the greatest contours: the slice with the dent is of none.
Polylines WithThirdPlane() { return Slices(8, { 0.0, Pi / 3.0, 2.0 * Pi / 3.0 }); }
}

//----------------------------------------------------------------------------
/// A surface that bends goes into the dent with it; a field is nearer to the dent than that without
/// it.
TEST(OtherGuides, AThirdPlaneThroughAStackGuides)
{
  const std::vector<Point3> dent = PointsOfDent(), other = CutThroughAxis(DentAngle);
  const Polylines lines = WithThirdPlane();
  const SortedSlices sorted = SortByPlanes(lines, FrameOptions());
  ASSERT_EQ(sorted.Others.Count(), 1);
  for (const Rule rule : { Rule::Bending, Rule::Field })
  {
    SCOPED_TRACE(static_cast<int>(rule));
    const Reconstruction without = RunCore(Slices(8, { 0.0, Pi / 3.0 }), rule);
    EXPECT_TRUE(without.Guiding.empty());
    const Reconstruction result = RunCore(lines, rule);
    EXPECT_EQ(result.Guiding, std::vector<std::uint8_t>{ 1 });
    const TriangleMesh mesh = MeshOf(result), bare = MeshOf(without);
    EXPECT_EQ(DescribeFlaws(mesh), "");
    EXPECT_LT(
      DistanceFrom(mesh, dent), (rule == Rule::Bending ? 0.75 : 0.85) * DistanceFrom(bare, dent));
    EXPECT_LT(DistanceFrom(mesh, other), 0.5 * DistanceFrom(bare, other));
  }
}

//----------------------------------------------------------------------------
/// Of slices through one axis, two families are slices and the others guide.
TEST(OtherGuides, SlicesAroundAnAxisGuide)
{
  std::vector<double> angles;
  for (int i = 0; i < 6; ++i)
  {
    angles.push_back(DentAngle + i * Pi / 6.0);
  }
  const Polylines lines = Slices(0, angles);
  const SortedSlices sorted = SortByPlanes(lines, FrameOptions());
  ASSERT_EQ(sorted.Others.Count(), 4);
  const Reconstruction result = RunCore(lines);
  EXPECT_EQ(result.Guiding, std::vector<std::uint8_t>(4, 1));
  const TriangleMesh mesh = MeshOf(result);
  EXPECT_EQ(DescribeFlaws(mesh), "");
  std::vector<Point3> all;
  for (Index i = 0; i < lines.Offsets.back(); ++i)
  {
    all.push_back(lines.PointAt(i));
  }
  EXPECT_LT(DistanceFrom(mesh, all), 0.02);
}

//----------------------------------------------------------------------------
/// Where no surface bends, such planes are left to be compared: nothing else changes.
TEST(OtherGuides, DenseSlicesTakeNoGuides)
{
  Polylines lines = Slices(9, {});
  for (int k = 0; k < 9; ++k)
  {
    for (const Matrix3& turn :
      { RotationAround({ 1.0, 0.0, 0.0 }, 0.5 * Pi), RotationAround({ 0.0, 1.0, 0.0 }, 0.5 * Pi) })
    {
      std::vector<Point3> points;
      for (Index i = lines.Offsets[k]; i < lines.Offsets[k + 1]; ++i)
      {
        points.push_back(Apply(turn, lines.PointAt(i)));
      }
      AddLoop(points, lines);
    }
  }
  const Reconstruction plain = RunCore(lines);
  AddLoop(CutThroughAxis(0.25 * Pi), lines);
  const Reconstruction result = RunCore(lines);
  EXPECT_EQ(result.Guiding, std::vector<std::uint8_t>{ 0 });
  EXPECT_EQ(MeshOf(result).Points, MeshOf(plain).Points);
}

//----------------------------------------------------------------------------
TEST(OtherGuides, TheResultDependsOnNoThreads)
{
  const Polylines lines = WithThirdPlane();
  EXPECT_EQ(
    MeshOf(RunCore(lines)).Points, MeshOf(RunCore(lines, Rule::Field, ManyThreads())).Points);
}

//----------------------------------------------------------------------------
/// Contours of the plane that are open or cross are mended as those of slices are; what cannot be
/// does no harm.
TEST(OtherGuides, BadContoursAreMendedOrLeftOut)
{
  Polylines lines = WithThirdPlane();
  const SortedSlices sorted = SortByPlanes(lines, FrameOptions());
  ASSERT_EQ(sorted.Others.Count(), 1);
  const Index other = static_cast<Index>(sorted.Others.From.Cell[0]);
  lines.Closed[other] = 0; // a gap of one side
  EXPECT_EQ(RunCore(lines).Guiding, std::vector<std::uint8_t>{ 1 });
  for (Index i = lines.Offsets[other]; i < lines.Offsets[other + 1]; ++i)
  {
    lines.X[i] += 40.0;
  }
  const Reconstruction result = RunCore(lines);
  EXPECT_EQ(result.Guiding, std::vector<std::uint8_t>{ 0 });
  EXPECT_EQ(DescribeFlaws(MeshOf(result)), "");
}

//----------------------------------------------------------------------------
/// Whatever the guides show, of the same solid or of another one, in the same place or not: closed
/// and embedded.
TEST(OtherGuides, AnyGuidesLeaveTheSurfaceEmbedded)
{
  const std::array<std::array<int, 3>, 3> counts{ { { 1, 1, 9 }, { 3, 3, 0 }, { 12, 0, 1 } } };
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(12); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Solid solids[] = { PlainBall(), TorusAround(2, 0.3), Pipe(0.3), TwoBalls(0, 0.2) };
    const Solid& solid = solids[random.Below(4)];
    const Solid& shown = random.Chance(0.5) ? solid : solids[random.Below(4)];
    SortedSlices sorted = SortByPlanes(
      MapSlices(SliceByFewPlanes(solid, EqualPlanes(solid, counts[random.Below(3)])), UnitMatrix()),
      FrameOptions());
    sorted.Others = MapSlices(
      SliceByFewPlanes(shown, EqualPlanes(shown, { 2, 1, 0 })), RandomRotation(random.Bits()));
    Options options;
    options.Virtual = VirtualSlices::Automatic;
    const Reconstruction result = ReconstructSorted(std::move(sorted), options, Execution());
    EXPECT_EQ(DescribeFlaws(MeshOf(result)), "");
    EXPECT_FALSE(result.Stopped);
  }
}
