// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/JoinPatch.h"

#include "Core/Reconstruct.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckPatch.h"
#include "Support/CyclesByCell.h"
#include "Support/Random.h"
#include "Support/RandomInput.h"
#include "Support/SelfIntersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;

using Joins = std::vector<std::pair<Index, Index>>;

void AddStar(Random& random, double u, double v, double z, double radius, Pieces& pieces)
{
  const std::size_t count = 3 + random.Below(12);
  const double turn = random.Uniform(0.0, 2.0 * Pi);
  std::vector<std::array<double, 2>> star;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double angle = turn + 2.0 * Pi * static_cast<double>(i) / static_cast<double>(count);
    const double r = random.Uniform(0.5, 1.0) * radius;
    star.push_back({ u + r * std::cos(angle), v + r * std::sin(angle) });
  }
  AddPiece(pieces, star, z);
}
}

//----------------------------------------------------------------------------
TEST(JoinPatch, TubeBetweenTwoSquares)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    SCOPED_TRACE(axis);
    PieceSets sets = EmptySets();
    for (const double plane : { 0.0, 1.0 })
    {
      AddPiece(sets[axis], { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, plane);
    }
    const Reconstruction result = RunDiscs(sets);
    const auto cells = CyclesByCell(result);
    ASSERT_EQ(cells.size(), 1u);
    const std::vector<Index> cycles = cells.begin()->second;
    ASSERT_EQ(cycles.size(), 2u);
    for (const double share : { 0.5, 0.3, 0.7 })
    {
      const PatchMesh patch =
        BuildJoinedPatch(GeometryOf(result), cycles, { { cycles[0], cycles[1] } }, share);
      EXPECT_EQ(patch.Kind, PatchKind::Joined);
      EXPECT_EQ(patch.Cycles, cycles);
      EXPECT_EQ(DescribePatchFlaws(GeometryOf(result), patch), "");
      // Four sides each way, and a ring of four that lies at its share of the height.
      EXPECT_EQ(patch.Triangles.size(), 16u);
      ASSERT_EQ(patch.Points.size(), 4u);
      const Point3 first = result.Graph.PointAt(GeometryOf(result).GetBorders({ cycles[0] })[0]);
      const double height = first[axis] == 0.0 ? share : 1.0 - share;
      for (const Point3& p : patch.Points)
      {
        EXPECT_NEAR(p[axis], height, 1e-12);
      }
      EXPECT_LE(CountSelfIntersections(MeshOf(GeometryOf(result), patch)), 0);
    }
  }
}

//----------------------------------------------------------------------------
/// Triangles face away from the axis of the tube.
TEST(JoinPatch, TubeIsOrientedOutwards)
{
  PieceSets sets = EmptySets();
  for (const double plane : { 0.0, 1.0 })
  {
    AddPiece(sets[2], { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } }, plane);
  }
  const Reconstruction result = RunDiscs(sets);
  const std::vector<Index> cycles = CyclesAbove(result);
  ASSERT_EQ(cycles.size(), 2u);
  const TriangleMesh mesh = MeshOf(GeometryOf(result),
    BuildJoinedPatch(GeometryOf(result), cycles, { { cycles[0], cycles[1] } }, 0.5));
  for (const auto& t : mesh.Triangles)
  {
    const Point3 &a = mesh.Points[t[0]], &b = mesh.Points[t[1]], &c = mesh.Points[t[2]];
    EXPECT_GT(ExactOrientation(a, b, c, { 0.0, 0.0, 0.5 }) *
        ExactOrientation({ 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 0 }),
      0);
  }
}

//----------------------------------------------------------------------------
namespace
{
const char* const OneBelowTwoAbove = "z=0: 0,0 4,0 4,2 0,2\n"
                                     "z=1: 0,0 1,0 1,2 0,2\n"
                                     "z=1: 3,0 4,0 4,2 3,2\n";
}

TEST(JoinPatch, BranchingOfThree)
{
  const Reconstruction result = RunDiscs(ParsePieces(OneBelowTwoAbove));
  const std::vector<Index> c = CyclesAbove(result);
  ASSERT_EQ(c.size(), 3u);
  // Whatever the tree, the three are one patch; the star around the lower one has no crossings.
  for (const Joins& joins :
    { Joins{ { c[0], c[1] }, { c[0], c[2] } }, Joins{ { c[0], c[1] }, { c[1], c[2] } },
      Joins{ { c[0], c[2] }, { c[1], c[2] } }, Joins{ { c[1], c[2] }, { c[0], c[2] } } })
  {
    for (const double share : { 0.5, 0.3, 0.7 })
    {
      const PatchMesh patch = BuildJoinedPatch(GeometryOf(result), c, joins, share);
      EXPECT_EQ(DescribePatchFlaws(GeometryOf(result), patch), "");
    }
  }
  const PatchMesh patch =
    BuildJoinedPatch(GeometryOf(result), c, { { c[0], c[1] }, { c[0], c[2] } }, 0.5);
  EXPECT_LE(CountSelfIntersections(MeshOf(GeometryOf(result), patch)), 0);
}

//----------------------------------------------------------------------------
/// Random loops on two planes, up to five in one patch, with random trees.
TEST(JoinPatch, RandomLoopsAndTrees)
{
  Random random(7);
  for (int run = 0; run < 150; ++run)
  {
    SCOPED_TRACE(run);
    PieceSets sets = EmptySets();
    for (int plane = 0; plane < 2; ++plane)
    {
      const std::size_t count = 1 + random.Below(4);
      for (std::size_t i = 0; i < count; ++i)
      {
        AddStar(random, 2.0 * static_cast<double>(i), random.Uniform(-1.0, 1.0), plane,
          random.Uniform(0.2, 0.99), sets[2]);
      }
    }
    const Reconstruction result = RunDiscs(sets);
    std::vector<Index> cycles = CyclesAbove(result);
    random.Shuffle(cycles);
    cycles.resize(std::min<std::size_t>(cycles.size(), 2 + random.Below(4)));
    Joins joins;
    for (std::size_t i = 1; i < cycles.size(); ++i)
    {
      joins.emplace_back(std::minmax(cycles[i], cycles[random.Below(i)]));
    }
    random.Shuffle(joins);
    std::sort(cycles.begin(), cycles.end());
    const PatchMesh patch =
      BuildJoinedPatch(GeometryOf(result), cycles, joins, random.Uniform(0.2, 0.8));
    EXPECT_EQ(DescribePatchFlaws(GeometryOf(result), patch), "");
  }
}

//----------------------------------------------------------------------------
/// All pairs of cycles of one cell, with and without node points, whether or not they should be
/// joined.
TEST(JoinPatch, AllPairsOfCyclesOfRandomInputs)
{
  int pairs = 0, withLoops = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(40); ++seed)
  {
    Input input = RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    input.Settings.Several = SeveralCycles::Discs;
    const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
    const CycleGeometry geometry = GeometryOf(result);
    for (const auto& cell : CyclesByCell(result))
    {
      const std::vector<Index>& c = cell.second;
      for (std::size_t i = 1; i < c.size(); ++i)
      {
        const PatchMesh patch =
          BuildJoinedPatch(geometry, { c[i - 1], c[i] }, { { c[i - 1], c[i] } }, 0.5);
        EXPECT_EQ(DescribePatchFlaws(geometry, patch), "");
        ++pairs;
        withLoops += geometry.IsLoop(c[i]) != geometry.IsLoop(c[i - 1]) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(pairs, 100);
  EXPECT_GT(withLoops, 20);
}
