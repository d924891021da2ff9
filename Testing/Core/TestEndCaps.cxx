// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how one stack ends: in domes, flat at its last slices, or half a slice farther
 *
 * Phantoms of known volume, with slices 3 mm apart, by the rule that suits the places of the
 * slices. ORTHOGONAL_SLICES_RUNS and ORTHOGONAL_SLICES_SEED set the number of random stacks and the
 * first of them.
 */

#include "Core/Reconstruct.h"
#include "Support/CheckBounds.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/Stages.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Spacing = 3.0;
constexpr int Corners = 120;

/// What a polygon with corners on a circle encloses.
double AreaOf(double radius)
{
  return 0.5 * Corners * radius * radius * std::sin(2.0 * Pi / Corners);
}

void AddCircle(double radius, double z, PieceSets& sets, double x = 0.0)
{
  std::vector<std::array<double, 2>> vertices;
  for (int i = 0; i < Corners; ++i)
  {
    const double angle = 2.0 * Pi * (i + 0.3) / Corners;
    vertices.push_back({ x + radius * std::cos(angle), radius * std::sin(angle) });
  }
  AddPiece(sets[2], vertices, z);
}

/// So many slices from z = `first` on, with circles of the radii that a function gives.
PieceSets StackOf(int count, double first, const std::function<double(double)>& radius)
{
  PieceSets sets = EmptySets();
  for (int i = 0; i < count; ++i)
  {
    const double z = first + Spacing * i;
    AddCircle(radius(z), z, sets);
  }
  return sets;
}

double Twenty(double /*z*/) { return 20.0; }

Reconstruction RunWith(
  const PieceSets& sets, EndCaps ends, VirtualSlices mode = VirtualSlices::Automatic)
{
  Options options;
  options.Ends = ends;
  options.Virtual = mode;
  return Reconstruct(PieceSets(sets), options, Execution());
}

/// The volume; -1 if the surface is not closed, embedded and within its bounds.
double VolumeOf(const PieceSets& sets, EndCaps ends, VirtualSlices mode = VirtualSlices::Automatic)
{
  const TriangleMesh mesh = MeshOf(RunWith(sets, ends, mode));
  SpatialGrid grid;
  const Contours contours = UsableContours(sets, Options(), grid);
  EXPECT_EQ(DescribeFlaws(mesh), "");
  EXPECT_EQ(DescribeExcess(mesh, contours, false), "");
  return CheckSurface(mesh).TotalVolume();
}

/// Calls a function with the stacks among random inputs.
template <typename Visit>
void VisitRandomStacks(std::uint64_t usual, Visit&& visit)
{
  std::uint64_t found = 0;
  for (std::uint64_t seed = FirstSeed(); found < RandomRuns(usual); ++seed)
  {
    Input input = RandomSparseInput(seed);
    int families = 0;
    for (const Pieces& pieces : input.Sets)
    {
      families += pieces.Count() > 0 ? 1 : 0;
    }
    if (families == 1)
    {
      SCOPED_TRACE(input.Name);
      input.Settings.Virtual = found % 3 == 0 ? VirtualSlices::Off : VirtualSlices::Automatic;
      visit(input);
      ++found;
    }
  }
}
}

//----------------------------------------------------------------------------
TEST(EndCaps, CylindersAreAreaTimesLength)
{
  for (const VirtualSlices mode : { VirtualSlices::Off, VirtualSlices::Automatic })
  {
    for (const int count : { 2, 3, 5, 20 })
    {
      SCOPED_TRACE(count);
      const PieceSets sets = StackOf(count, 1.5, Twenty);
      // In plates of one spacing. Beside edges the surface bends as it likes, and a tube is a
      // little too narrow there, however long it is.
      const double plate = AreaOf(20.0) * Spacing;
      const double half = VolumeOf(sets, EndCaps::HalfSlice, mode) / plate;
      EXPECT_NEAR(half, count, 5e-3);
      EXPECT_NEAR(VolumeOf(sets, EndCaps::Flat, mode) / plate, count - 1, 7.5e-3);
    }
  }
}

//----------------------------------------------------------------------------
TEST(EndCaps, PhantomsHaveTheirVolumeByTheRuleThatSuits)
{
  const auto expect = [](const PieceSets& sets, EndCaps ends, double volume)
  { EXPECT_NEAR(VolumeOf(sets, ends) / volume, 1.0, 0.005); };
  // The first and the last slice at the ends of a cylinder; at the centres of voxels.
  expect(StackOf(21, 0.0, Twenty), EndCaps::Dome, Pi * 400.0 * 60.0);
  expect(StackOf(21, 0.0, Twenty), EndCaps::Flat, Pi * 400.0 * 60.0);
  expect(StackOf(20, 1.5, Twenty), EndCaps::HalfSlice, Pi * 400.0 * 60.0);
  // A cone that begins in its first slice and has its tip beyond the last one; at centres of
  // voxels.
  const auto cone = [](double z) { return 20.0 - z / 3.0; };
  expect(StackOf(20, 0.0, cone), EndCaps::Dome, Pi * 400.0 * 20.0);
  expect(StackOf(20, 0.0, cone), EndCaps::Flat, Pi * 400.0 * 20.0);
  expect(StackOf(20, 1.5, cone), EndCaps::HalfSlice, Pi * 400.0 * 20.0);
  // A ball ends beyond its last slices: in domes, which plates come near to.
  const auto ball = [](double z) { return std::sqrt(900.0 - z * z); };
  expect(StackOf(20, -28.5, ball), EndCaps::Dome, Pi * 36000.0);
  expect(StackOf(20, -28.5, ball), EndCaps::HalfSlice, Pi * 36000.0);
}

//----------------------------------------------------------------------------
/// Whatever the surface is between the slices, walls and lids add half a plate at each end.
TEST(EndCaps, HalfSlicesAddHalfPlates)
{
  const auto radius = [](double z) { return 20.0 + 5.0 * std::sin(0.15 * z) - 0.1 * z; };
  const PieceSets sets = StackOf(13, 0.0, radius);
  const double plates = 0.5 * Spacing * (AreaOf(radius(0.0)) + AreaOf(radius(36.0)));
  for (const VirtualSlices mode : { VirtualSlices::Off, VirtualSlices::Automatic })
  {
    const double sum = VolumeOf(sets, EndCaps::Flat, mode) + plates;
    // Virtual slices round the edges between walls and what is between the slices.
    const double tolerance = mode == VirtualSlices::Off ? 5e-4 : 2e-3;
    EXPECT_NEAR(VolumeOf(sets, EndCaps::HalfSlice, mode) / sum, 1.0, tolerance);
  }
}

//----------------------------------------------------------------------------
/// Smooth patches between virtual slices do not bulge beyond an end that is flat.
TEST(EndCaps, FlatEndsAreFlat)
{
  const auto ball = [](double z) { return std::sqrt(900.0 - z * z); };
  for (const PieceSets& sets : { StackOf(20, -28.5, ball), StackOf(20, -28.5, Twenty) })
  {
    double low = 0.0, high = 0.0;
    for (const Point3& point : MeshOf(RunWith(sets, EndCaps::Flat)).Points)
    {
      low = std::min(low, point[2]);
      high = std::max(high, point[2]);
    }
    EXPECT_GE(low, -28.5 - 2.5e-3 * Spacing);
    EXPECT_LE(high, 28.5 + 2.5e-3 * Spacing);
  }
}

//----------------------------------------------------------------------------
TEST(EndCaps, PipesKeepTheirHole)
{
  PieceSets sets = StackOf(9, 0.0, Twenty);
  for (int i = 0; i < 9; ++i)
  {
    AddCircle(12.0, Spacing * i, sets, 2.0);
  }
  const double area = AreaOf(20.0) - AreaOf(12.0);
  for (const EndCaps ends : { EndCaps::Flat, EndCaps::HalfSlice })
  {
    const Reconstruction result = RunWith(sets, ends);
    EXPECT_EQ(result.Topology.Components, 1);
    EXPECT_EQ(result.Topology.Genus, 1);
    const double length = (ends == EndCaps::Flat ? 8 : 9) * Spacing;
    EXPECT_NEAR(VolumeOf(sets, ends) / (area * length), 1.0, 2e-3);
  }
}

//----------------------------------------------------------------------------
/// Uneven slices: half the distance of the last two, half of the mean distance at most.
TEST(EndCaps, HalfSlicesAreThoseOfTheSlicesThere)
{
  PieceSets sets = EmptySets();
  for (const double z : { 0.0, 2.0, 5.0, 8.0, 13.0 }) // 3.25 apart in the mean
  {
    AddCircle(20.0, z, sets);
  }
  double low = 0.0, high = 0.0;
  for (const Point3& point : MeshOf(RunWith(sets, EndCaps::HalfSlice)).Points)
  {
    low = std::min(low, point[2]);
    high = std::max(high, point[2]);
  }
  EXPECT_NEAR(low, -1.0, 0.004);
  EXPECT_NEAR(high, 14.625, 0.004);
}

//----------------------------------------------------------------------------
/// A branch that ends between two slices ends flat there, and what is on one slice alone is not
/// lost.
TEST(EndCaps, FlatEndsBetweenSlices)
{
  PieceSets sets = StackOf(9, 0.0, Twenty);
  for (int i = 2; i < 6; ++i)
  {
    AddCircle(8.0, Spacing * i, sets, 60.0);
  }
  const double both = (8 * AreaOf(20.0) + 3 * AreaOf(8.0)) * Spacing;
  EXPECT_NEAR(VolumeOf(sets, EndCaps::Flat) / both, 1.0, 2e-3);
  EXPECT_GT(VolumeOf(StackOf(1, 0.0, Twenty), EndCaps::Flat), 100.0);
}

//----------------------------------------------------------------------------
/// Each slice stands for a plate, also where a branch, a cavity or what is on one slice alone ends
/// between two slices.
TEST(EndCaps, HalfSlicesEndBetweenSlices)
{
  const double plate = AreaOf(20.0) * Spacing, small = AreaOf(8.0) * Spacing;
  const auto expect = [](const PieceSets& sets, double volume)
  { EXPECT_NEAR(VolumeOf(sets, EndCaps::HalfSlice) / volume, 1.0, 0.005); };
  PieceSets sets = StackOf(9, 0.0, Twenty);
  for (int i = 2; i < 6; ++i)
  {
    AddCircle(8.0, Spacing * i, sets, 60.0); // apart
  }
  expect(sets, 9 * plate + 4 * small);
  AddCircle(8.0, Spacing * 4, sets, -60.0); // on one slice
  expect(sets, 9 * plate + 5 * small);
  for (int i = 3; i < 6; ++i)
  {
    AddCircle(10.0, Spacing * i, sets, 2.0); // a cavity
  }
  expect(sets, 9 * plate + 5 * small - 3 * AreaOf(10.0) * Spacing);
}

//----------------------------------------------------------------------------
/// A body of four slices with two prongs that end at different heights, the longer one at the end
/// of the stack.
TEST(EndCaps, ProngsEndHalfASliceFarther)
{
  PieceSets sets = EmptySets();
  for (int i = 0; i < 12; ++i)
  {
    const double z = Spacing * i;
    if (i < 4)
    {
      AddPiece(sets[2], { { -40.0, -20.0 }, { 40.0, -20.0 }, { 40.0, 20.0 }, { -40.0, 20.0 } }, z);
      continue;
    }
    for (const double x : { -20.0, 20.0 })
    {
      if (x < 0.0 || i < 9)
      {
        AddPiece(sets[2],
          { { x - 10.0, -10.0 }, { x + 10.0, -10.0 }, { x + 10.0, 10.0 }, { x - 10.0, 10.0 } }, z);
      }
    }
  }
  const TriangleMesh mesh = MeshOf(RunWith(sets, EndCaps::HalfSlice));
  EXPECT_EQ(DescribeFlaws(mesh), "");
  double shorter = 0.0, longer = 0.0;
  for (const Point3& p : mesh.Points)
  {
    shorter = p[0] > 0.0 ? std::max(shorter, p[2]) : shorter;
    longer = p[0] < 0.0 ? std::max(longer, p[2]) : longer;
  }
  EXPECT_NEAR(shorter, 8.5 * Spacing, 1e-3 * Spacing);
  EXPECT_NEAR(longer, 11.5 * Spacing, 1e-3 * Spacing);
  const double flat = VolumeOf(sets, EndCaps::Flat);
  const double added = 0.5 * Spacing * (3200.0 + 2.0 * 400.0);
  EXPECT_NEAR((VolumeOf(sets, EndCaps::HalfSlice) - flat) / added, 1.0, 0.03);
}

//----------------------------------------------------------------------------
TEST(EndCaps, SingleSliceBecomesAPlate)
{
  const double thickness = 20.0; // half of its extent
  const double volume = VolumeOf(StackOf(1, 0.0, Twenty), EndCaps::HalfSlice);
  EXPECT_NEAR(volume / (AreaOf(20.0) * thickness), 1.0, 0.01);
}

//----------------------------------------------------------------------------
/// The report is that of the slices of the input.
TEST(EndCaps, CopiesAreNotReported)
{
  PieceSets sets = StackOf(9, 0.0, Twenty);
  AddCircle(5.0, 0.0, sets, 40.0);
  AddCircle(5.0, 3.0, sets, 45.0);
  for (const VirtualSlices mode : { VirtualSlices::Off, VirtualSlices::Automatic })
  {
    const Reconstruction dome = RunWith(sets, EndCaps::Dome, mode);
    const Reconstruction half = RunWith(sets, EndCaps::HalfSlice, mode);
    EXPECT_TRUE(half.Grid.HasVirtual());
    EXPECT_EQ(half.ContourCount, dome.ContourCount);
    EXPECT_EQ(half.Repairs.size(), dome.Repairs.size());
    EXPECT_EQ(half.Undecided.Places.size(), dome.Undecided.Places.size());
    EXPECT_EQ(half.Doubtful.Places.size(), dome.Doubtful.Places.size());
    EXPECT_EQ(CountLeftOut(half), CountLeftOut(dome));
    EXPECT_EQ(half.Topology.Components, dome.Topology.Components);
  }
}

//----------------------------------------------------------------------------
TEST(EndCaps, SlicesAcrossShowTheEndsThemselves)
{
  const PieceSets sets = ParsePieces(Octahedron());
  const TriangleMesh dome = MeshOf(RunWith(sets, EndCaps::Dome));
  for (const EndCaps ends : { EndCaps::Flat, EndCaps::HalfSlice })
  {
    const TriangleMesh mesh = MeshOf(RunWith(sets, ends));
    EXPECT_EQ(mesh.Points, dome.Points);
    EXPECT_EQ(mesh.Triangles, dome.Triangles);
  }
}

//----------------------------------------------------------------------------
/// G1, G2, G3, G6 and G7.
TEST(EndCaps, RandomStacksAreClosedEmbeddedAndBounded)
{
  VisitRandomStacks(40,
    [](Input& input)
    {
      SpatialGrid grid;
      const Contours contours = UsableContours(input.Sets, input.Settings, grid);
      for (const EndCaps ends : { EndCaps::Flat, EndCaps::HalfSlice })
      {
        input.Settings.Ends = ends;
        const TriangleMesh mesh =
          MeshOf(Reconstruct(PieceSets(input.Sets), input.Settings, Execution()));
        EXPECT_EQ(DescribeFlaws(mesh), "") << static_cast<int>(ends);
        EXPECT_EQ(DescribeExcess(mesh, contours, input.Settings.SinglePrecision), "");
      }
    });
}
