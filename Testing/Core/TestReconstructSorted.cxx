// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ReconstructSorted.h"

#include "Support/AnalyticSolids.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/NearestTriangle.h"
#include "Support/Random.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SliceSolid.h"
#include "Support/TurnedSlices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Reconstruction RunCore(const Polylines& lines, const Options& options = Options())
{
  return ReconstructSorted(SortByPlanes(lines, FrameOptions()), options, Execution());
}

/// The greatest distance of the points of one mesh from another one.
double GreatestDistance(const TriangleMesh& from, const TriangleMesh& to)
{
  std::vector<NearestTriangle::Triangle> triangles;
  for (const auto& t : to.Triangles)
  {
    triangles.push_back({ to.Points[t[0]], to.Points[t[1]], to.Points[t[2]] });
  }
  const NearestTriangle nearest(std::move(triangles));
  double greatest = 0.0;
  for (const Point3& p : from.Points)
  {
    greatest = std::max(greatest, nearest.Find(p).Distance);
  }
  return greatest;
}

/// The way in which a frame exchanges and reflects the axes of slices that were turned: the surface
/// depends on that a little, as it does on which family is called x.
Matrix3 OrderOf(const AxisFrame& frame, const Matrix3& rotation)
{
  Matrix3 order;
  for (int axis = 0; axis < 3; ++axis)
  {
    order[axis] = Apply(Transpose(rotation), frame.Normal(axis));
    for (double& x : order[axis])
    {
      x = std::round(x);
    }
  }
  return order;
}

/// Expects the surface of turned slices to be that of slices along the axes, turned; closed and
/// embedded.
void ExpectTurned(const PieceSets& sets, const Matrix3& rotation, double tolerance)
{
  const Reconstruction turned = RunCore(MapSlices(sets, rotation));
  const Matrix3 order = OrderOf(turned.Frame, rotation);
  const Reconstruction plain = RunCore(MapSlices(sets, order));
  EXPECT_EQ(turned.Topology.Components, plain.Topology.Components);
  EXPECT_EQ(turned.Topology.Genus, plain.Topology.Genus);
  TriangleMesh mesh = MeshOf(turned);
  const SurfaceCheck check = CheckSurface(mesh);
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_TRUE(FindMeetings(mesh).empty());
  for (Point3& p : mesh.Points)
  {
    p = Apply(order, Apply(Transpose(rotation), p));
  }
  const TriangleMesh reference = MeshOf(plain);
  EXPECT_LE(GreatestDistance(mesh, reference), tolerance);
  EXPECT_LE(GreatestDistance(reference, mesh), tolerance);
  const double volume = CheckSurface(reference).TotalVolume();
  EXPECT_GT(volume, 0.0);
  EXPECT_NEAR(check.TotalVolume(), volume, tolerance * volume);
}

/// The axes, each coordinate changed by up to `share`.
Matrix3 RandomInclination(double share, Random& random)
{
  Matrix3 inclined = UnitMatrix();
  for (Point3& row : inclined)
  {
    for (double& x : row)
    {
      x += random.Uniform(-share, share);
    }
  }
  return inclined;
}

PieceSets SlicesOf(const Solid& solid, const std::array<int, 3>& count)
{
  return SliceSolid(solid, EqualPlanes(solid, count), 6, InPlaneGrid::Free);
}
}

//----------------------------------------------------------------------------
TEST(ReconstructSorted, TurnsTheSurfaceWithTheSlices)
{
  for (const Solid& solid : { TiltedTorus(), BranchingTube(), HollowBall() })
  {
    const PieceSets sets = SlicesOf(solid, { 9, 9, 9 });
    for (std::uint64_t seed = 0; seed < 6; ++seed)
    {
      SCOPED_TRACE(solid.Name + " " + std::to_string(seed));
      ExpectTurned(sets, RandomRotation(seed), 1e-6);
    }
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructSorted, AxisOrdersAndReflectionsGiveTheSameTopology)
{
  const Solid solid = TiltedTorus();
  const PieceSets sets = SlicesOf(solid, { 6, 7, 8 });
  const double volume = CheckSurface(MeshOf(RunCore(MapSlices(sets, UnitMatrix())))).TotalVolume();
  for (int number = 0; number < 48; ++number)
  {
    SCOPED_TRACE(number);
    const Reconstruction result = RunCore(MapSlices(sets, AxisOrder(number), { 3, 0, 1 }));
    EXPECT_TRUE(result.Frame.IsWorld());
    EXPECT_EQ(result.Topology.Components, solid.Components);
    EXPECT_EQ(result.Topology.Genus, solid.Genus);
    const SurfaceCheck check = CheckSurface(MeshOf(result));
    EXPECT_TRUE(check.IsClosedManifold()) << check;
    EXPECT_NEAR(check.TotalVolume(), volume, 2e-3 * volume);
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructSorted, OneAndTwoFamiliesTurnToo)
{
  const PieceSets all = SlicesOf(TiltedTorus(), { 9, 9, 9 });
  for (const int families : { 1, 2, 3, 4, 5, 6 })
  {
    SCOPED_TRACE(families);
    PieceSets sets = EmptySets();
    for (int axis = 0; axis < 3; ++axis)
    {
      sets[axis] = ((families >> axis) & 1) != 0 ? all[axis] : sets[axis];
    }
    // Of one family, the other two axes are turned around its own, which changes the triangles.
    const bool isOne = families == 1 || families == 2 || families == 4;
    ExpectTurned(sets, RotationAround({ -2.0, 1.0, 3.0 }, 0.3), isOne ? 0.02 : 1e-6);
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructSorted, InclinedFamiliesGiveTheMappedSurface)
{
  const PieceSets sets = SlicesOf(TiltedTorus(), { 9, 9, 9 });
  const Reconstruction plain = RunCore(MapSlices(sets, UnitMatrix()));
  const double volume = CheckSurface(MeshOf(plain)).TotalVolume();
  for (std::uint64_t seed = 0; seed < 6; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Matrix3 inclined = RandomInclination(0.2, random);
    const Reconstruction result = RunCore(MapSlices(sets, inclined));
    const TriangleMesh mesh = MeshOf(result);
    const SurfaceCheck check = CheckSurface(mesh);
    EXPECT_TRUE(check.IsClosedManifold()) << check;
    EXPECT_TRUE(FindMeetings(mesh).empty());
    EXPECT_EQ(result.Topology.Components, plain.Topology.Components);
    EXPECT_EQ(result.Topology.Genus, plain.Topology.Genus);
    const double factor = std::abs(Dot(inclined[0], Cross(inclined[1], inclined[2])));
    EXPECT_NEAR(check.TotalVolume() / (factor * volume), 1.0, 0.01);
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructSorted, NormalsAreThoseOfTheMappedSurface)
{
  const PieceSets sets = SlicesOf(TiltedTorus(), { 12, 12, 12 });
  Matrix3 gantry = UnitMatrix();
  gantry[1][2] = -0.27;
  const Reconstruction result = RunCore(MapSlices(sets, gantry));
  ASSERT_FALSE(result.Normals.Normals.empty());
  // Of the triangles beside a node point, the mean normal is near that of the surface.
  const TriangleMesh mesh = MeshOf(result);
  std::vector<Point3> sums(mesh.Points.size(), Point3{ 0.0, 0.0, 0.0 });
  for (const auto& t : mesh.Triangles)
  {
    const Point3 normal =
      Cross(mesh.Points[t[1]] - mesh.Points[t[0]], mesh.Points[t[2]] - mesh.Points[t[0]]);
    for (const std::int64_t corner : t)
    {
      sums[corner] = sums[corner] + normal;
    }
  }
  double mean = 0.0;
  for (Index node = 0; node < result.Graph.Nodes; ++node)
  {
    const float* n = result.Normals.Normals.data() + 3 * node;
    mean += Dot(Unit(sums[node]), Point3{ n[0], n[1], n[2] }) / result.Graph.Nodes;
  }
  EXPECT_GT(mean, 0.99);
}

//----------------------------------------------------------------------------
TEST(ReconstructSorted, NamesPortsAndCells)
{
  const PieceSets sets = SlicesOf(TiltedTorus(), { 5, 6, 7 });
  const Polylines lines = MapSlices(sets, UnitMatrix(), { 2, 3, 2 });
  const Reconstruction result = RunCore(lines);
  ASSERT_EQ(result.Members.Cell.size(), result.Members.Port.size());
  for (std::size_t i = 0; i < result.Members.Cell.size(); ++i)
  {
    EXPECT_EQ(result.Members.Port[i], result.Members.Axis[i] == 1 ? 3 : 2);
    // The z-slices follow the x-slices in port 2.
    const std::int64_t first = result.Members.Axis[i] == 2 ? sets[0].Count() : 0;
    EXPECT_GE(result.Members.Cell[i], first);
    EXPECT_LT(result.Members.Cell[i], first + sets[result.Members.Axis[i]].Count());
  }
  Polylines open = lines;
  open.Closed[1] = 0;
  open.X[open.Offsets[1]] = std::nan("");
  Options strict;
  strict.Invalid = InvalidContours::Refuse;
  const Reconstruction refused = RunCore(open, strict);
  ASSERT_FALSE(refused.Invalid.empty());
  EXPECT_EQ(refused.Invalid[0].Port, 2);
  EXPECT_EQ(refused.Invalid[0].Cell, 1);
}

namespace
{
/// A rotation, an exchange of axes, or a map that inclines them by up to some 20 degrees.
Matrix3 RandomFrame(Random& random)
{
  switch (random.Below(3))
  {
    case 0:
      return RandomRotation(random.Bits());
    case 1:
      return AxisOrder(static_cast<int>(random.Below(48)));
    default:
      return RandomInclination(0.2, random);
  }
}

Input RandomInput(std::uint64_t seed)
{
  return seed % 3 == 0 ? RandomConsistentInput(seed)
    : seed % 3 == 1    ? RandomContradictoryInput(seed)
                       : RandomSparseInput(seed);
}

/// A coordinate as the input and the result have it.
double RoundedTo(const Options& settings, double x)
{
  volatile float rounded = static_cast<float>(x);
  return settings.SinglePrecision ? rounded : x;
}

/// Random slices in a random frame, through random ports, rounded or in loose segments or not.
Polylines RandomLines(const Input& input, Random& random)
{
  std::array<int, 3> ports;
  for (int& port : ports)
  {
    port = static_cast<int>(random.Below(4));
  }
  // Turned back, coordinates are no values of float: what is embedded then is so in double.
  const Matrix3 frame = input.Settings.SinglePrecision
    ? AxisOrder(static_cast<int>(random.Below(48)))
    : RandomFrame(random);
  const double step = random.Chance(0.3) ? 1e-4 : 0.0;
  const Polylines lines = MapSlices(input.Sets, frame, ports, step);
  return random.Chance(0.2) ? CutToSegments(lines, random.Bits()) : lines;
}
}

//----------------------------------------------------------------------------
TEST(ReconstructSorted, AnySlicesInAnyFrameGiveAnEmbeddedSurface)
{
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(30); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    Input input = RandomInput(seed);
    input.Settings.Invalid = InvalidContours::Mend;
    input.Settings.SinglePrecision = random.Chance(0.3);
    Polylines lines = RandomLines(input, random);
    for (std::vector<double>* values : { &lines.X, &lines.Y, &lines.Z })
    {
      for (double& x : *values)
      {
        x = RoundedTo(input.Settings, x);
      }
    }
    TriangleMesh mesh = MeshOf(RunCore(lines, input.Settings));
    for (Point3& p : mesh.Points)
    {
      for (double& x : p)
      {
        x = RoundedTo(input.Settings, x);
      }
    }
    const std::string flaws = DescribeFlaws(mesh);
    EXPECT_TRUE(flaws.empty()) << flaws;
  }
}
