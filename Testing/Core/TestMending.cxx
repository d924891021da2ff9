// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Reconstruct.h"

#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/Damage.h"
#include "Support/Perturbations.h"
#include "Support/Random.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SliceSolid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// An ellipsoid with axes of 1.5, 1.2 and 1 and a centre off zero.
Solid Ellipsoid()
{
  Solid solid;
  solid.Low = { -1.7, -1.3, -1.1 };
  solid.High = { 1.7, 1.4, 1.2 };
  solid.Function = [](const Point3& p)
  {
    return std::sqrt(p[0] * p[0] / 2.25 + (p[1] - 0.05) * (p[1] - 0.05) / 1.44 +
             (p[2] - 0.03) * (p[2] - 0.03)) -
      1.0;
  };
  return solid;
}

PieceSets ContoursOf(const Solid& solid, const std::array<int, 3>& counts)
{
  return SliceSolid(solid, EqualPlanes(solid, counts), 12, InPlaneGrid::Free);
}

PieceSets Slices(const std::array<int, 3>& counts) { return ContoursOf(Ellipsoid(), counts); }

/// The surface of what needs mending is closed and does not cross itself. Returns its volume.
double VolumeOf(const PieceSets& sets, const Options& options = Options())
{
  const Reconstruction result = Reconstruct(PieceSets(sets), options, Execution());
  EXPECT_FALSE(result.Refused);
  EXPECT_TRUE(result.Invalid.empty());
  const TriangleMesh mesh = MeshOf(result);
  EXPECT_EQ(DescribeFlaws(mesh), "");
  return CheckSurface(mesh).TotalVolume();
}

std::size_t CountMended(const PieceSets& sets, ProblemKind kind)
{
  const Reconstruction result = Reconstruct(PieceSets(sets), Options(), Execution());
  return std::count_if(result.Mended.begin(), result.Mended.end(),
    [&](const Problem& problem) { return problem.Kind == kind; });
}

const std::array<int, 3> AllCounts[] = { { 7, 6, 6 }, { 0, 0, 8 }, { 8, 0, 0 }, { 0, 6, 5 } };
}

//----------------------------------------------------------------------------
namespace
{
/// Slices of the ellipsoid, damaged in four ways: the volume of the surface is that of whole ones,
/// but for a share.
template <typename Damage>
std::vector<PieceSets> TryDamage(const std::array<int, 3>& counts, double share, Damage&& damage)
{
  const PieceSets whole = Slices(counts);
  const double volume = VolumeOf(whole);
  std::vector<PieceSets> damaged;
  for (std::uint64_t seed = 0; seed < 4; ++seed)
  {
    SCOPED_TRACE(seed);
    damaged.push_back(whole);
    damage(damaged.back(), seed);
    EXPECT_NEAR(VolumeOf(damaged.back()), volume, share * volume);
  }
  return damaged;
}
}

TEST(Mending, ContoursThatLackTheirLastPoints)
{
  for (const auto& counts : AllCounts)
  {
    std::size_t gaps = 0;
    for (const PieceSets& sets : TryDamage(counts, 0.02,
           [](PieceSets&whole, std::uint64_t seed) { LoseEnds(whole, 1.0, 0.1, seed); }))
    {
      gaps += CountMended(sets, ProblemKind::GapClosed);
    }
    EXPECT_GT(gaps, 2u) << "shorter ones need no mending";
  }
}

//----------------------------------------------------------------------------
TEST(Mending, ContoursThatRunPastTheirStart)
{
  for (const auto& counts : AllCounts)
  {
    for (const PieceSets& sets : TryDamage(counts, 0.01,
           [](PieceSets&whole, std::uint64_t seed)
           { RunPastStart(whole, 1.0, 0.15, seed % 2 == 0 ? 0.0 : 0.01, seed); }))
    {
      EXPECT_GT(CountMended(sets, ProblemKind::OverrunTrimmed), 0u);
    }
  }
}

//----------------------------------------------------------------------------
TEST(Mending, ContoursInPiecesWithGaps)
{
  for (const auto& counts : AllCounts)
  {
    TryDamage(counts, 0.02,
      [](PieceSets& whole, std::uint64_t seed) { BreakApart(whole, 0.7, 0.03, seed); });
  }
}

//----------------------------------------------------------------------------
TEST(Mending, VerticesBesideTheirPlane)
{
  for (const auto& counts : AllCounts)
  {
    for (const PieceSets& sets : TryDamage(counts, 0.02,
           [](PieceSets&whole, std::uint64_t seed)
           { LeavePlane(whole, seed == 0 ? 1.0 : 0.5, 0.01, seed); }))
    {
      EXPECT_GT(CountMended(sets, ProblemKind::MovedOntoPlane), 0u);
    }
  }
}

//----------------------------------------------------------------------------
TEST(Mending, WhatJoinsNothingDoesNotMatter)
{
  for (const auto& counts : AllCounts)
  {
    const PieceSets whole = Slices(counts);
    PieceSets sets = whole;
    AddJunk(sets, 3, 1);
    EXPECT_EQ(VolumeOf(sets), VolumeOf(whole));
    const std::size_t axes = 3 - std::count(counts.begin(), counts.end(), 0);
    EXPECT_EQ(CountMended(sets, ProblemKind::TooShort), 3 * axes);
    EXPECT_EQ(CountMended(sets, ProblemKind::Flat), 3 * axes);
    EXPECT_EQ(CountMended(sets, ProblemKind::NotFinite), 3 * axes);
  }
}

//----------------------------------------------------------------------------
namespace
{
/// Volume of the ellipsoid below a part of its axis: x of -1 to 1.
double ShareBelow(double x) { return 0.5 + 0.75 * x - 0.25 * x * x * x; }
}

TEST(Mending, ContoursThatEndAtTheBorderOfTheImage)
{
  const double whole = 4.0 / 3.0 * 3.14159265 * 1.5 * 1.2;
  const double center[] = { 0.0, 0.05, 0.03 }, radius[] = { 1.5, 1.2, 1.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool below : { true, false })
    {
      SCOPED_TRACE(std::to_string(axis) + (below ? " below" : " above"));
      PieceSets sets = Slices({ 13, 12, 11 });
      const double border = center[axis] + (below ? 0.4 : -0.4) * radius[axis];
      CutOff(sets, axis, border, below);
      EXPECT_NEAR(VolumeOf(sets), ShareBelow(0.4) * whole, 0.02 * whole);
      EXPECT_GT(CountMended(sets, ProblemKind::ClosedAlongBorder), 10u);
      const Reconstruction result = Reconstruct(PieceSets(sets), Options(), Execution());
      for (const Point3& point : MeshOf(result).Points)
      {
        const double beyond = (below ? 1.0 : -1.0) * (point[axis] - border);
        EXPECT_LE(beyond, 0.0201 * result.Grid.SpacingAtEnds[axis]);
      }
      Options options;
      options.AtBorder = BorderContours::Refuse;
      const Reconstruction refused = Reconstruct(PieceSets(sets), options, Execution());
      EXPECT_TRUE(refused.Refused);
      EXPECT_GT(refused.Invalid.size(), 10u);
    }
  }
}

//----------------------------------------------------------------------------
TEST(Mending, BordersOnSeveralSidesAndTheCornerBetweenThem)
{
  const double whole = 4.0 / 3.0 * 3.14159265 * 1.5 * 1.2;
  PieceSets sets = Slices({ 13, 12, 11 });
  CutOff(sets, 0, 0.6, true);
  CutOff(sets, 0, -0.6, false);
  EXPECT_NEAR(VolumeOf(sets), (2.0 * ShareBelow(0.4) - 1.0) * whole, 0.02 * whole);
  // Of an eighth of the ellipsoid three sides are borders.
  sets = Slices({ 13, 12, 11 });
  CutOff(sets, 0, 0.0, true);
  CutOff(sets, 1, 0.05, true);
  CutOff(sets, 2, 0.03, true);
  EXPECT_NEAR(VolumeOf(sets), whole / 8.0, 0.01 * whole);
}

//----------------------------------------------------------------------------
TEST(Mending, StacksAreClosedAlongTheBorder)
{
  PieceSets sets = Slices({ 0, 0, 12 });
  const double volume = VolumeOf(sets);
  CutOff(sets, 0, 0.0, true);
  EXPECT_NEAR(VolumeOf(sets), 0.5 * volume, 0.02 * volume);
}

//----------------------------------------------------------------------------
TEST(Mending, ErrorOnlyIfNothingIsLeft)
{
  const char* junk = "z=0 open: 0,0 1,0; z=1: 0,0 1,1 2,2; x=0: 0,0 nan,1 1,1";
  const Reconstruction refused = Reconstruct(ParsePieces(junk), Options(), Execution());
  EXPECT_TRUE(refused.Refused);
  EXPECT_EQ(refused.Invalid.size(), 3u);
  const Reconstruction kept =
    Reconstruct(ParsePieces(std::string(junk) + "; z=2: 0,0 1,0 1,1 0,1; z=3: 0,0 1,0 1,1 0,1"),
      Options(), Execution());
  EXPECT_FALSE(kept.Refused);
  EXPECT_EQ(kept.Mended.size(), 3u);
  EXPECT_GT(kept.Surface.TriangleCount(), 0);
}

//----------------------------------------------------------------------------
/// Everything at once, on solids of any topology.
TEST(Mending, RandomDamageLeavesASurfaceNearTheUndamagedOne)
{
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Solid solid = RandomSolid(seed);
    PieceSets sets = ContoursOf(solid, { 9, 9, 9 });
    if (seed % 3 == 0)
    {
      sets[0] = EmptySets()[0];
      sets[1] = EmptySets()[1];
    }
    const Reconstruction undamaged = Reconstruct(PieceSets(sets), Options(), Execution());
    const SurfaceCheck expected = CheckSurface(MeshOf(undamaged));
    LeavePlane(sets, 0.3, 1e-3, seed);
    AddJunk(sets, random.Below(3), seed);
    LoseEnds(sets, 0.2, 0.05, seed);
    RunPastStart(sets, 0.25, 0.1, random.Uniform(0.0, 0.003), seed);
    BreakApart(sets, 0.3, 0.02, seed);
    ReverseContours(sets, 0.5, seed);
    const double volume = VolumeOf(sets);
    if (expected.Components > 0)
    {
      EXPECT_NEAR(volume, expected.TotalVolume(), 0.04 * expected.TotalVolume());
      ++compared;
    }
  }
  EXPECT_GT(compared, 15);
}
