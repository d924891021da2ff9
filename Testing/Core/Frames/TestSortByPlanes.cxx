// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/SortByPlanes.h"

#include "Support/Random.h"
#include "Support/SliceSolid.h"
#include "Support/TurnedSlices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
std::size_t CountPlanes(const Pieces& pieces)
{
  return std::set<double>(pieces.W.begin(), pieces.W.end()).size();
}

std::array<Index, 3> CountPieces(const SortedSlices& sorted)
{
  return { sorted.Slices[0].Count(), sorted.Slices[1].Count(), sorted.Slices[2].Count() };
}

std::array<Index, 3> CountPieces(const PieceSets& sets)
{
  return { sets[0].Count(), sets[1].Count(), sets[2].Count() };
}

/// The angle between two directions, whichever way they point, in radians.
double AngleBetween(const Point3& a, const Point3& b)
{
  return std::atan2(Length(Cross(a, b)), std::abs(Dot(a, b)));
}

/// The greatest angle of a frame's normals from the rows of a matrix.
double GreatestAngle(const AxisFrame& frame, const Matrix3& rows)
{
  double greatest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    greatest = std::max(greatest, AngleBetween(frame.Normal(axis), Unit(rows[axis])));
  }
  return greatest;
}

/// Moves all points off their planes: by up to `size` in any direction.
void AddNoise(double size, Polylines& lines)
{
  Random random(1);
  for (std::vector<double>* values : { &lines.X, &lines.Y, &lines.Z })
  {
    for (double& value : *values)
    {
      value += random.Uniform(-size, size);
    }
  }
}

/// Coordinate of the plane that a planar polyline lies on, for given normals.
Polylines Circle(const Point3& center, const Point3& normal, double radius, int points = 40)
{
  const std::array<Point3, 3> frame = CompleteFrame(Unit(normal));
  Polylines lines;
  for (int i = 0; i < points; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / points;
    const Point3 p =
      center + (radius * std::cos(angle)) * frame[0] + (0.8 * radius * std::sin(angle)) * frame[1];
    lines.X.push_back(p[0]);
    lines.Y.push_back(p[1]);
    lines.Z.push_back(p[2]);
  }
  lines.Offsets.push_back(points);
  lines.Closed.push_back(1);
  lines.From = { { 3 }, { 0 }, { 0 } };
  return lines;
}

void Append(const Polylines& more, Polylines& lines)
{
  for (Index line = 0; line < more.Count(); ++line)
  {
    AppendLine(more, line, lines);
  }
}
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, LeavesSlicesAcrossTheWorldsAxesAsTheyAre)
{
  const PieceSets& sets = TorusSlices();
  const SortedSlices sorted = SortByPlanes(MapSlices(sets, UnitMatrix()), FrameOptions());
  EXPECT_TRUE(sorted.Frame.IsWorld());
  EXPECT_EQ(sorted.Others.Count(), 0);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(sorted.Slices[axis].U, sets[axis].U);
    EXPECT_EQ(sorted.Slices[axis].V, sets[axis].V);
    EXPECT_EQ(sorted.Slices[axis].W, sets[axis].W);
    EXPECT_EQ(sorted.Slices[axis].Offsets, sets[axis].Offsets);
  }
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, PortsDoNotMatter)
{
  const PieceSets& sets = TorusSlices();
  for (const std::array<int, 3>& ports :
    { std::array<int, 3>{ 3, 3, 3 }, { 0, 0, 0 }, { 1, 2, 0 }, { 2, 2, 3 }, { 2, 1, 0 } })
  {
    const SortedSlices sorted = SortByPlanes(MapSlices(sets, UnitMatrix(), ports), FrameOptions());
    EXPECT_TRUE(sorted.Frame.IsWorld());
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(sorted.Slices[axis].U, sets[axis].U);
      EXPECT_EQ(sorted.Slices[axis].W, sets[axis].W);
      for (const std::int64_t line : sorted.Slices[axis].Cell)
      {
        EXPECT_EQ(sorted.From.Port[line], ports[axis]);
      }
    }
  }
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, AxisOrdersAreNoOtherFrames)
{
  const PieceSets& sets = TorusSlices();
  for (int number = 0; number < 48; ++number)
  {
    SCOPED_TRACE(number);
    const Matrix3 order = AxisOrder(number);
    const SortedSlices sorted = SortByPlanes(MapSlices(sets, order), FrameOptions());
    EXPECT_TRUE(sorted.Frame.IsWorld());
    for (int axis = 0; axis < 3; ++axis)
    {
      const int from = static_cast<int>(
        std::find_if(order[axis].begin(), order[axis].end(), [](double x) { return x != 0.0; }) -
        order[axis].begin());
      EXPECT_EQ(sorted.Slices[axis].Count(), sets[from].Count());
    }
  }
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, FindsRotations)
{
  const PieceSets& sets = TorusSlices();
  for (std::uint64_t seed = 0; seed < 30; ++seed)
  {
    SCOPED_TRACE(seed);
    const Matrix3 rotation = RandomRotation(seed);
    const SortedSlices sorted = SortByPlanes(MapSlices(sets, rotation), FrameOptions());
    EXPECT_FALSE(sorted.Frame.IsWorld());
    EXPECT_TRUE(sorted.Frame.IsRotation());
    EXPECT_EQ(sorted.Others.Count(), 0);
    std::multiset<std::size_t> planes, expected;
    for (int axis = 0; axis < 3; ++axis)
    {
      planes.insert(CountPlanes(sorted.Slices[axis]));
      expected.insert(CountPlanes(sets[axis]));
    }
    EXPECT_EQ(planes, expected);
  }
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, AxesAreTheNearestOnesOfTheWorldOrThoseOfThePorts)
{
  const PieceSets& sets = TorusSlices();
  const double degree = 3.14159265358979323846 / 180.0;
  // Near the world's, whatever the ports are.
  const Matrix3 tilted = RotationAround({ 1.0, 2.0, -1.0 }, 20.0 * degree);
  for (const std::array<int, 3>& ports : { std::array<int, 3>{ 0, 1, 2 }, { 2, 0, 1 } })
  {
    const SortedSlices sorted = SortByPlanes(MapSlices(sets, tilted, ports), FrameOptions());
    EXPECT_LT(GreatestAngle(sorted.Frame, Transpose(tilted)), 1e-7);
    EXPECT_EQ(CountPieces(sorted), CountPieces(sets));
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_GT(sorted.Frame.Normal(axis)[axis], 0.9);
    }
  }
  // Between the world's axes the ports decide.
  const Matrix3 turned = RotationAround({ 1.0, 2.0, -1.0 }, 66.0 * degree);
  EXPECT_EQ(CountPieces(SortByPlanes(MapSlices(sets, turned), FrameOptions())), CountPieces(sets));
  const SortedSlices other = SortByPlanes(MapSlices(sets, turned, { 2, 0, 1 }), FrameOptions());
  EXPECT_EQ(CountPieces(other),
    (std::array<Index, 3>{ sets[1].Count(), sets[2].Count(), sets[0].Count() }));
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, FindsInclinedFamilies)
{
  const PieceSets& sets = TorusSlices();
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(seed);
    // Columns at 60 degrees and more from each other: what the axes become.
    Random random(seed);
    Matrix3 inclined = UnitMatrix();
    for (Point3& row : inclined)
    {
      for (double& x : row)
      {
        x += random.Uniform(-0.25, 0.25);
      }
    }
    const SortedSlices sorted = SortByPlanes(MapSlices(sets, inclined), FrameOptions());
    EXPECT_FALSE(sorted.Frame.IsRotation());
    EXPECT_EQ(CountPieces(sorted), CountPieces(sets));
    EXPECT_EQ(sorted.Others.Count(), 0);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(CountPlanes(sorted.Slices[axis]), CountPlanes(sets[axis]));
    }
  }
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, OneAndTwoFamiliesWillDo)
{
  for (int families = 1; families < 7; ++families)
  {
    SCOPED_TRACE(families);
    PieceSets sets = EmptySets();
    for (int axis = 0; axis < 3; ++axis)
    {
      sets[axis] = ((families >> axis) & 1) != 0 ? TorusSlices()[axis] : sets[axis];
    }
    const Matrix3 rotation = RotationAround({ -2.0, 1.0, 3.0 }, 0.5);
    const SortedSlices sorted = SortByPlanes(MapSlices(sets, rotation), FrameOptions());
    EXPECT_TRUE(sorted.Frame.IsRotation());
    EXPECT_EQ(CountPieces(sorted), CountPieces(sets));
    EXPECT_EQ(sorted.Others.Count(), 0);
    EXPECT_GT(
      Dot(sorted.Frame.Normal(0), Cross(sorted.Frame.Normal(1), sorted.Frame.Normal(2))), 0.999);
    EXPECT_TRUE(SortByPlanes(MapSlices(sets, UnitMatrix()), FrameOptions()).Frame.IsWorld());
  }
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, RoundedCoordinatesHideNoFrame)
{
  const PieceSets& sets = TorusSlices();
  const double step = 2e-4 * DiagonalOf(MapSlices(sets, UnitMatrix()));
  for (std::uint64_t seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(seed);
    const Matrix3 rotation = RotationAround({ 1.0, 0.3 * seed, -1.0 }, 0.1 + 0.04 * seed);
    const SortedSlices sorted =
      SortByPlanes(MapSlices(sets, rotation, { 0, 1, 2 }, step), FrameOptions());
    EXPECT_TRUE(sorted.Frame.IsRotation());
    EXPECT_LT(GreatestAngle(sorted.Frame, Transpose(rotation)), 1e-3);
    EXPECT_EQ(CountPieces(sorted), CountPieces(sets));
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(CountPlanes(sorted.Slices[axis]), CountPlanes(sets[axis]));
    }
  }
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, NoiseMakesNoFrame)
{
  for (const int families : { 1, 2, 4, 3, 5, 7 })
  {
    for (const double share : { 1e-4, 1e-3, 5e-3 })
    {
      SCOPED_TRACE(std::to_string(families) + " " + std::to_string(share));
      PieceSets sets = EmptySets();
      for (int axis = 0; axis < 3; ++axis)
      {
        sets[axis] = ((families >> axis) & 1) != 0 ? TorusSlices()[axis] : sets[axis];
      }
      Polylines lines = MapSlices(sets, UnitMatrix());
      AddNoise(share * DiagonalOf(lines), lines);
      const SortedSlices sorted = SortByPlanes(lines, FrameOptions());
      EXPECT_TRUE(sorted.Frame.IsWorld());
      EXPECT_EQ(CountPieces(sorted), CountPieces(sets));
    }
  }
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, TrianglesBesideTheirPlanesMakeNoFrame)
{
  // Any three points lie on a plane of their own.
  const PieceSets sets =
    ParsePieces("z=0: 0,0 10,0,0.02 5,8; z=1: 0,0,1.01 10,0 5,8; z=2: 1,1 9,1 5,7,1.98");
  const SortedSlices sorted = SortByPlanes(MapSlices(sets, UnitMatrix()), FrameOptions());
  EXPECT_TRUE(sorted.Frame.IsWorld());
  EXPECT_EQ(CountPieces(sorted), (std::array<Index, 3>{ 0, 0, 3 }));
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, ContoursSmallerThanTheNoiseStayWithTheirPort)
{
  for (const double angle : { 0.0, 0.4 })
  {
    Polylines lines = MapSlices(TorusSlices(), RotationAround({ 1.0, 2.0, -1.0 }, angle));
    AddNoise(2e-3 * DiagonalOf(lines), lines);
    // A tip, seen edge on for all that the noise says.
    Polylines tip = Circle({ 0.1, 0.2, 0.3 }, { 1.0, 0.1, 0.0 }, 1e-3 * DiagonalOf(lines), 8);
    tip.From.Port[0] = 2;
    Append(tip, lines);
    const SortedSlices sorted = SortByPlanes(lines, FrameOptions());
    EXPECT_EQ(sorted.Frame.IsWorld(), angle == 0.0);
    EXPECT_EQ(sorted.Slices[2].Count(), TorusSlices()[2].Count() + 1);
  }
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, OneBadContourStaysInItsPort)
{
  PieceSets sets = TorusSlices();
  sets[2].W[sets[2].Offsets[3] + 2] += 0.3; // one vertex far off its plane
  const SortedSlices sorted = SortByPlanes(MapSlices(sets, UnitMatrix()), FrameOptions());
  EXPECT_TRUE(sorted.Frame.IsWorld());
  EXPECT_EQ(CountPieces(sorted), CountPieces(sets));
  sets[2].W[sets[2].Offsets[5] + 1] = std::nan("");
  EXPECT_TRUE(SortByPlanes(MapSlices(sets, UnitMatrix()), FrameOptions()).Frame.IsWorld());
  const Matrix3 rotation = RotationAround({ 1.0, 2.0, -1.0 }, 0.3);
  const SortedSlices turned = SortByPlanes(MapSlices(sets, rotation), FrameOptions());
  EXPECT_LT(GreatestAngle(turned.Frame, Transpose(rotation)), 0.02);
  EXPECT_EQ(CountPieces(turned), CountPieces(sets));
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, LooseSegmentsOfOneInputAreSorted)
{
  const PieceSets& sets = TorusSlices();
  for (const double angle : { 0.0, 0.4 })
  {
    const Matrix3 rotation = RotationAround({ 1.0, 2.0, -1.0 }, angle);
    const Polylines segments = CutToSegments(MapSlices(sets, rotation, { 3, 3, 3 }), 5);
    const SortedSlices sorted = SortByPlanes(segments, FrameOptions());
    EXPECT_EQ(sorted.Frame.IsWorld(), angle == 0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(sorted.Slices[axis].Count(), static_cast<Index>(sets[axis].U.size()));
    }
  }
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, PlanesOfAFourthFamilyAreNoSlices)
{
  for (const double angle : { 0.0, 0.4 })
  {
    const Matrix3 rotation = RotationAround({ 1.0, 2.0, -1.0 }, angle);
    Polylines lines = MapSlices(TorusSlices(), rotation);
    Append(Circle({ 0.1, 0.2, 0.0 }, Apply(rotation, { 1.0, 1.0, 0.3 }), 0.5), lines);
    const SortedSlices sorted = SortByPlanes(lines, FrameOptions());
    EXPECT_EQ(sorted.Frame.IsWorld(), angle == 0.0);
    EXPECT_EQ(CountPieces(sorted), CountPieces(TorusSlices()));
    ASSERT_EQ(sorted.Others.Count(), 1);
    EXPECT_EQ(sorted.Others.From.Port[0], 3);
  }
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, LongAxesAtAnAngleAreFamilies)
{
  // A short axis with two long axes at 60 degrees, and one more at 20 degrees to the second.
  const double degree = 3.14159265358979323846 / 180.0;
  const Matrix3 rotation = RandomRotation(3);
  const auto longAxis = [&](double angle)
  {
    return Circle({ 0.0, 0.0, 0.0 },
      Apply(rotation, { std::cos(angle * degree), std::sin(angle * degree), 0.0 }), 4.0);
  };
  Polylines lines;
  for (int i = 0; i < 5; ++i)
  {
    Append(Circle(Apply(rotation, { 0.0, 0.0, i - 2.0 }), Apply(rotation, { 0.0, 0.0, 1.0 }), 3.0),
      lines);
  }
  Append(longAxis(0.0), lines);
  Append(longAxis(60.0), lines);
  const SortedSlices two = SortByPlanes(lines, FrameOptions());
  EXPECT_EQ(two.Others.Count(), 0);
  EXPECT_FALSE(two.Frame.IsRotation());
  Append(longAxis(80.0), lines);
  // The long axes at right angles, nearly, are the families.
  const SortedSlices three = SortByPlanes(lines, FrameOptions());
  ASSERT_EQ(three.Others.Count(), 1);
  EXPECT_EQ(three.Others.X[0], lines.X[lines.Offsets[6]]);
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, TakesTheFrameThatIsGiven)
{
  const Matrix3 rotation = RandomRotation(8);
  FrameOptions options;
  options.Choice = FrameChoice::Given;
  options.Given = Transpose(rotation);
  for (Point3& normal : options.Given)
  {
    normal = 2.0 * normal;
  }
  const SortedSlices sorted =
    SortByPlanes(MapSlices(TorusSlices(), rotation, { 3, 3, 3 }), options);
  EXPECT_EQ(CountPieces(sorted), CountPieces(TorusSlices()));
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_LT(Length(sorted.Frame.Normal(axis) - Transpose(rotation)[axis]), 1e-14);
  }
  AxisFrame frame;
  EXPECT_FALSE(
    MakeGivenFrame({ { { 1.0, 0.0, 0.0 }, { 1.0, 0.01, 0.0 }, { 0.0, 0.0, 1.0 } } }, frame));
  EXPECT_FALSE(
    MakeGivenFrame({ { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } } }, frame));
  ASSERT_TRUE(
    MakeGivenFrame({ { { 0.0, 1.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } } }, frame));
  EXPECT_EQ(frame.Normal(2)[2], -1.0);
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, TheWorldsAxesCanBeInsistedOn)
{
  FrameOptions options;
  options.Choice = FrameChoice::World;
  const SortedSlices sorted = SortByPlanes(MapSlices(TorusSlices(), RandomRotation(8)), options);
  EXPECT_TRUE(sorted.Frame.IsWorld());
  EXPECT_EQ(CountPieces(sorted), CountPieces(TorusSlices()));
}

//----------------------------------------------------------------------------
TEST(SortByPlanes, NothingIsNoFault)
{
  EXPECT_TRUE(SortByPlanes(Polylines(), FrameOptions()).Frame.IsWorld());
}
