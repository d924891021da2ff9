// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellShells.h"
#include "Core/Cells/JoinPatch.h"

#include "Core/Reconstruct.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckPatch.h"
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

Reconstruction RunDiscs(const PieceSets& sets)
{
  Options options;
  options.Orient = Orientation::AsDrawn;
  options.Several = SeveralCycles::Discs;
  return Reconstruct(PieceSets(sets), options, Execution());
}

/// The cycles of each cell with two or more of them.
std::map<std::array<Index, 3>, std::vector<Index>> CyclesByCell(const Reconstruction& result)
{
  std::map<std::array<Index, 3>, std::vector<Index>> cells;
  for (Index cycle = 0; cycle < result.Cycles.Count(); ++cycle)
  {
    cells[result.Cycles.Cell[cycle]].push_back(cycle);
  }
  for (auto cell = cells.begin(); cell != cells.end();)
  {
    cell = cell->second.size() < 2 ? cells.erase(cell) : std::next(cell);
  }
  return cells;
}

/// The cycles in the slab above plane 0 of z, which must be those of one cell.
std::vector<Index> CyclesAbove(const Reconstruction& result)
{
  std::vector<Index> cycles;
  for (Index cycle = 0; cycle < result.Cycles.Count(); ++cycle)
  {
    if (result.Cycles.Cell[cycle][2] == 1)
    {
      cycles.push_back(cycle);
    }
  }
  return cycles;
}

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

//----------------------------------------------------------------------------
namespace
{
/// All shells are sound, and together they meet nowhere; how many groups could not be made.
int ExpectSoundShells(const CycleGeometry& geometry, const std::vector<Index>& cycles,
  const std::vector<std::vector<Index>>& groups)
{
  const std::vector<PatchMesh> shells =
    BuildShells(geometry, cycles.data(), cycles.data() + cycles.size(), groups);
  EXPECT_EQ(shells.size(), groups.size());
  TriangleMesh all;
  int impossible = 0;
  for (std::size_t i = 0; i < shells.size(); ++i)
  {
    if (shells[i].Triangles.empty())
    {
      EXPECT_GT(groups[i].size(), 1u);
      ++impossible;
      continue;
    }
    EXPECT_EQ(shells[i].Kind, PatchKind::Shell);
    EXPECT_EQ(shells[i].Cycles, groups[i]);
    EXPECT_EQ(DescribePatchFlaws(geometry, shells[i]), "");
    TriangleMesh mesh = MeshOf(geometry, shells[i]);
    const auto first = static_cast<std::int64_t>(all.Points.size());
    for (auto& t : mesh.Triangles)
    {
      all.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
    }
    all.Points.insert(all.Points.end(), mesh.Points.begin(), mesh.Points.end());
  }
  EXPECT_TRUE(FindMeetings(all, 1).empty());
  EXPECT_LE(CountSelfIntersections(all), 0);
  return impossible;
}
}

//----------------------------------------------------------------------------
TEST(CellShells, TubeBetweenTwoPlanes)
{
  const Reconstruction result = RunDiscs(ParsePieces("z=0: 0,0 1,0 1,1 0,1\nz=1: 0,0 1,0 1,1 0,1"));
  const std::vector<Index> c = CyclesAbove(result);
  ASSERT_EQ(c.size(), 2u);
  EXPECT_EQ(ExpectSoundShells(GeometryOf(result), c, { { c[0] }, { c[1] } }), 0);
  EXPECT_EQ(ExpectSoundShells(GeometryOf(result), c, { c }), 0);
}

//----------------------------------------------------------------------------
/// The wall between an outer tube and one within it.
TEST(CellShells, TubeWithinATube)
{
  const Reconstruction result = RunDiscs(ParsePieces("z=0: 0,0 3,0 3,3 0,3\n"
                                                     "z=0: 1,1 1,2 2,2 2,1\n"
                                                     "z=1: 0,0 3,0 3,3 0,3\n"
                                                     "z=1: 1,1 1,2 2,2 2,1\n"));
  const std::vector<Index> c = CyclesAbove(result);
  ASSERT_EQ(c.size(), 4u);
  const auto sizeOf = [&](Index cycle)
  {
    Point3 low{ 9, 9, 9 }, high{ -9, -9, -9 };
    for (const Index p : GeometryOf(result).GetBorders({ cycle }))
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], result.Graph.PointAt(p)[axis]);
        high[axis] = std::max(high[axis], result.Graph.PointAt(p)[axis]);
      }
    }
    return high[0] - low[0];
  };
  std::vector<Index> outer, inner;
  for (const Index cycle : c)
  {
    (sizeOf(cycle) > 2.0 ? outer : inner).push_back(cycle);
  }
  ASSERT_EQ(outer.size(), 2u);
  const CycleGeometry geometry = GeometryOf(result);
  // Both tubes, one of them and two discs, and a wall that turns back on one plane.
  EXPECT_EQ(ExpectSoundShells(geometry, c, { outer, inner }), 0);
  EXPECT_EQ(ExpectSoundShells(geometry, c, { outer, { inner[0] }, { inner[1] } }), 0);
  EXPECT_EQ(ExpectSoundShells(geometry, c, { { outer[0] }, { outer[1] }, inner }), 1);
  EXPECT_EQ(ExpectSoundShells(geometry, c, { { c[0] }, { c[1] }, { c[2] }, { c[3] } }), 0);
}

//----------------------------------------------------------------------------
/// Random groups of the cycles of random cells: what BuildShells makes is sound.
TEST(CellShells, RandomGroups)
{
  Random random(8);
  int made = 0, several = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(60); ++seed)
  {
    Input input = seed % 2 == 0 ? RandomSparseInput(seed) : RandomConsistentInput(seed);
    SCOPED_TRACE(input.Name);
    input.Settings.Several = SeveralCycles::Discs;
    const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
    for (const auto& cell : CyclesByCell(result))
    {
      std::vector<std::vector<Index>> groups;
      for (const Index cycle : cell.second)
      {
        if (groups.empty() || random.Chance(0.6))
        {
          groups.emplace_back();
        }
        groups[random.Below(groups.size())].push_back(cycle);
      }
      groups.erase(std::remove_if(groups.begin(), groups.end(),
                     [](const std::vector<Index>& group) { return group.empty(); }),
        groups.end());
      const int impossible = ExpectSoundShells(GeometryOf(result), cell.second, groups);
      const auto joined = std::count_if(groups.begin(), groups.end(),
        [](const std::vector<Index>& group) { return group.size() > 1; });
      several += static_cast<int>(joined);
      made += static_cast<int>(joined) - impossible;
    }
  }
  EXPECT_GT(made, 50);
  EXPECT_GT(several, made);
}
