// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/InnerPatches.h"

#include "Core/Base/Vectors.h"
#include "Support/CheckPatch.h"
#include "Support/Stages.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
PatchOptions With(PatchMethod method, double edgeLength = 0.25)
{
  PatchOptions options;
  options.Method = method;
  options.EdgeLength = edgeLength;
  return options;
}

/// Everything that patches are made of.
struct Borders
{
  explicit Borders(const Stages& stages)
    : Geometry(stages.Geometry())
    , Cells(GroupByCell(stages.Grid, stages.Cycles, Execution()))
    , Normals(EstimateNormals(Geometry, 1.05, {}, Execution()))
    , CentralPoints(LocateCentralPoints(CentralPointMethod::Centroid, Geometry,
        std::vector<double>(3 * static_cast<std::size_t>(stages.Nodes.Count()), 0.0), Execution()))
  {
  }

  InnerPatches Build(const PatchOptions& options, const std::vector<PatchMesh>& meshes = {},
    const Execution& execution = Execution()) const
  {
    return BuildInnerPatches(
      { Geometry, Cells, Normals, CentralPoints, meshes }, options, execution);
  }

  CycleGeometry Geometry;
  CellGroups Cells;
  SurfaceNormals Normals;
  std::vector<double> CentralPoints;
};

bool Has(const InnerPatches& patches, Index cycle)
{
  return std::binary_search(patches.Cycle.begin(), patches.Cycle.end(), cycle);
}

PatchMesh MeshOf(const InnerPatches& patches, Index i)
{
  PatchMesh mesh{ PatchKind::Joined, { patches.Cycle[i] }, {}, {} };
  for (std::int64_t p = patches.PointOffsets[i]; p < patches.PointOffsets[i + 1]; ++p)
  {
    mesh.Points.push_back(patches.PointAt(p));
  }
  for (std::int64_t t = patches.TriangleOffsets[i]; t < patches.TriangleOffsets[i + 1]; ++t)
  {
    mesh.Triangles.push_back(
      { patches.Corners[3 * t], patches.Corners[3 * t + 1], patches.Corners[3 * t + 2] });
  }
  return mesh;
}

void ExpectSame(const InnerPatches& a, const InnerPatches& b)
{
  EXPECT_EQ(a.Cycle, b.Cycle);
  EXPECT_EQ(a.PointOffsets, b.PointOffsets);
  EXPECT_EQ(a.TriangleOffsets, b.TriangleOffsets);
  EXPECT_EQ(a.Points, b.Points);
  EXPECT_EQ(a.Normals, b.Normals);
  EXPECT_EQ(a.Corners, b.Corners);
}

/// A thin plate: two sheets 0.1 apart in every cell, and no slice between them.
Stages Plate()
{
  return Stages(
    "x=1: 0.5,1.45 2.5,1.45 2.5,1.55 0.5,1.55; x=2: 0.5,1.45 2.5,1.45 2.5,1.55 0.5,1.55;"
    "y=1: 1.45,0.5 1.55,0.5 1.55,2.5 1.45,2.5; y=2: 1.45,0.5 1.55,0.5 1.55,2.5 1.45,2.5");
}

std::vector<Index> CyclesIn(const Stages& stages, const std::array<Index, 3>& cell)
{
  std::vector<Index> cycles;
  for (Index cycle = 0; cycle < stages.Cycles.Count(); ++cycle)
  {
    if (stages.Cycles.Cell[cycle] == cell)
    {
      cycles.push_back(cycle);
    }
  }
  return cycles;
}

/// Both sheets of the middle cell are said to bend towards each other, or away from each other.
void Bend(const Stages& stages, double slope, SurfaceNormals& normals)
{
  normals.Corners.clear();
  for (Index i = 0; i < stages.Graph.Count(); ++i)
  {
    const Point3 p = stages.Graph.PointAt(i);
    const double side = p[2] < 1.5 ? -1.0 : 1.0;
    const Point3 normal = Unit({ slope * (p[0] - 1.5), slope * (p[1] - 1.5), side });
    std::copy(normal.begin(), normal.end(), normals.Normals.begin() + 3 * i);
  }
}
}

//----------------------------------------------------------------------------
TEST(InnerPatches, AreDiscsOneForEachCycle)
{
  for (const PatchMethod method : { PatchMethod::Smooth, PatchMethod::Coons })
  {
    Index built = 0, cycles = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed)
    {
      const Stages stages(RandomContradictoryInput(seed));
      const Borders borders(stages);
      const InnerPatches patches = borders.Build(With(method));
      cycles += stages.Cycles.Count();
      built += patches.Count();
      EXPECT_TRUE(std::adjacent_find(patches.Cycle.begin(), patches.Cycle.end(),
                    std::greater_equal<Index>()) == patches.Cycle.end());
      EXPECT_EQ(patches.Points.size(), patches.Normals.size());
      EXPECT_EQ(static_cast<std::size_t>(3 * patches.PointOffsets.back()), patches.Points.size());
      EXPECT_EQ(
        static_cast<std::size_t>(3 * patches.TriangleOffsets.back()), patches.Corners.size());
      for (Index i = 0; i < patches.Count(); ++i)
      {
        ASSERT_GT(patches.PointOffsets[i + 1], patches.PointOffsets[i]);
        ASSERT_EQ(DescribePatchFlaws(borders.Geometry, MeshOf(patches, i)), "") << seed;
      }
    }
    EXPECT_GT(built, 0.5 * cycles);
  }
}

//----------------------------------------------------------------------------
TEST(InnerPatches, FansHaveNone)
{
  const Stages stages{ Cube() };
  EXPECT_EQ(Borders(stages).Build(With(PatchMethod::Fan)).Count(), 0);
  EXPECT_EQ(Borders(stages).Build(With(PatchMethod::Smooth)).Count(), 26);
  EXPECT_EQ(Borders(stages).Build(With(PatchMethod::Coons)).Count(), 26);
}

//----------------------------------------------------------------------------
TEST(InnerPatches, CyclesWithAMeshGetNone)
{
  const Stages stages{ Cube() };
  const Borders borders(stages);
  PatchMesh mesh{ PatchKind::Joined, { 3, 7 }, {}, {} };
  const InnerPatches patches = borders.Build(With(PatchMethod::Smooth), { mesh });
  EXPECT_EQ(patches.Count(), 24);
  EXPECT_FALSE(Has(patches, 3));
  EXPECT_FALSE(Has(patches, 7));
  EXPECT_TRUE(Has(patches, 4));
}

//----------------------------------------------------------------------------
/// Two loops with domes on both sides: there, the surface is upright and has no mean normal.
TEST(InnerPatches, DomesThatMeetUprightStayFans)
{
  Options options;
  options.Several = SeveralCycles::Discs;
  const Reconstruction result =
    Reconstruct(ParsePieces("z=0: 0,0 2,0 2,2 0,2; z=9: 0,0 2,0 2,2 0,2"), options, Execution());
  EXPECT_EQ(result.Cycles.Count(), 4);
  EXPECT_EQ(result.Surface.Inner.Count(), 0);
}

//----------------------------------------------------------------------------
TEST(InnerPatches, SmallerSidesMakeMorePoints)
{
  const Stages stages{ Cube(12) };
  const Borders borders(stages);
  for (const PatchMethod method : { PatchMethod::Smooth, PatchMethod::Coons })
  {
    const auto coarse = borders.Build(With(method, 0.5)).PointOffsets.back();
    const auto fine = borders.Build(With(method, 0.1)).PointOffsets.back();
    EXPECT_GT(fine, 2 * coarse);
  }
  PatchOptions bent = With(PatchMethod::Smooth, 1.0);
  bent.ChordTolerance = 1e-3;
  const Stages octahedron(RandomConsistentInput(0));
  EXPECT_GT(Borders(octahedron).Build(bent).PointOffsets.back(),
    Borders(octahedron).Build(With(PatchMethod::Smooth, 1.0)).PointOffsets.back());
}

//----------------------------------------------------------------------------
/// Creases only at corners: the vertices and edges of a cube, one point each.
TEST(InnerPatches, BordersWithCornersGetCreases)
{
  const Stages stages{ Cube(12) };
  const InnerPatches patches = Borders(stages).Build(With(PatchMethod::Smooth));
  ASSERT_EQ(patches.Count(), 26);
  for (Index i = 0; i < patches.Count(); ++i)
  {
    const auto& cell = stages.Cycles.Cell[patches.Cycle[i]];
    const bool face = std::count(cell.begin(), cell.end(), 1) == 2;
    EXPECT_EQ(patches.PointOffsets[i + 1] - patches.PointOffsets[i] == 1, !face);
  }
}

//----------------------------------------------------------------------------
TEST(InnerPatches, ThatTouchGiveWayToFans)
{
  const Stages stages = Plate();
  Borders borders(stages);
  const std::vector<Index> sheets = CyclesIn(stages, { 1, 1, 0 });
  ASSERT_EQ(sheets.size(), 2u);
  // Flat, or bent away from each other: they do not touch.
  for (const double slope : { 0.0, 0.15 })
  {
    Bend(stages, slope, borders.Normals);
    const InnerPatches apart = borders.Build(With(PatchMethod::Smooth));
    EXPECT_TRUE(Has(apart, sheets[0]) && Has(apart, sheets[1])) << slope;
  }
  Bend(stages, -0.25, borders.Normals);
  const InnerPatches touching = borders.Build(With(PatchMethod::Smooth));
  EXPECT_FALSE(Has(touching, sheets[0]) || Has(touching, sheets[1]));
}

//----------------------------------------------------------------------------
/// What is left is the same as before, in the same order.
TEST(InnerPatches, OthersStayWhenSomeGiveWay)
{
  const Stages stages = Plate();
  Borders borders(stages);
  const std::vector<Index> sheets = CyclesIn(stages, { 1, 1, 0 });
  Bend(stages, -0.25, borders.Normals);
  const InnerPatches few = borders.Build(With(PatchMethod::Smooth));
  borders.Cells.Several.clear(); // nothing is compared
  const InnerPatches all = borders.Build(With(PatchMethod::Smooth));
  EXPECT_TRUE(Has(all, sheets[0]) && Has(all, sheets[1]));
  InnerPatches expected;
  for (Index i = 0; i < all.Count(); ++i)
  {
    if (Has(few, all.Cycle[i]))
    {
      expected.Add(all, i);
    }
  }
  EXPECT_LT(few.Count(), all.Count());
  ExpectSame(few, expected);
}

//----------------------------------------------------------------------------
TEST(InnerPatches, SameForAnyNumberOfThreads)
{
  for (std::uint64_t seed = 0; seed < 12; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    const Borders borders(stages);
    for (const PatchMethod method : { PatchMethod::Smooth, PatchMethod::Coons })
    {
      ExpectSame(borders.Build(With(method)), borders.Build(With(method), {}, ManyThreads()));
    }
  }
}
