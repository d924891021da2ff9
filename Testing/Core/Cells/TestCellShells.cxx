// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellShells.h"

#include "Support/CheckEmbedding.h"
#include "Support/CheckPatch.h"
#include "Support/CyclesByCell.h"
#include "Support/Random.h"
#include "Support/RandomInput.h"
#include "Support/SelfIntersections.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

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
