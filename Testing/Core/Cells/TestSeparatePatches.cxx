// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/SeparatePatches.h"
#include "Core/Planar/TriangulatePolygon.h"

#include "Core/Base/Predicates.h"
#include "Core/Reconstruct.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckPatch.h"
#include "Support/Random.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
double TwiceArea(const Point2& a, const Point2& b, const Point2& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

/// n - 2 triangles, all counter-clockwise, which together have the polygon's area.
void ExpectTriangulated(const std::vector<Point2>& polygon)
{
  const auto triangles = TriangulatePolygon(polygon);
  EXPECT_EQ(triangles.size(), polygon.size() - 2);
  double area = 0.0, expected = 0.0;
  std::set<Index> used;
  for (const auto& t : triangles)
  {
    EXPECT_GT(SideOf(polygon[t[0]], polygon[t[1]], polygon[t[2]]), 0);
    area += TwiceArea(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    used.insert(t.begin(), t.end());
  }
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    expected += TwiceArea(polygon[0], polygon[i], polygon[i + 1]);
  }
  EXPECT_NEAR(area, expected, 1e-9 * std::abs(expected));
  EXPECT_EQ(used.size(), polygon.size());
}
}

//----------------------------------------------------------------------------
TEST(TriangulatePolygon, ConvexAndNotConvex)
{
  ExpectTriangulated({ { 0, 0 }, { 1, 0 }, { 0, 1 } });
  ExpectTriangulated({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  ExpectTriangulated({ { 0, 0 }, { 4, 0 }, { 1, 1 }, { 0, 4 } });
  // A U, a comb and a spiral.
  ExpectTriangulated(
    { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } });
  std::vector<Point2> comb{ { 20, -1 } };
  for (int i = 20; i >= 0; --i)
  {
    comb.push_back({ static_cast<double>(i), i % 2 == 0 ? 5.0 : 0.0 });
  }
  comb.push_back({ 0, -1 });
  ExpectTriangulated(comb);
  ExpectTriangulated({ { 0, 0 }, { 9, 0 }, { 9, 9 }, { 2, 9 }, { 2, 3 }, { 5, 3 }, { 5, 6 },
    { 4, 6 }, { 4, 4 }, { 3, 4 }, { 3, 8 }, { 8, 8 }, { 8, 1 }, { 1, 1 }, { 1, 9 }, { 0, 9 } });
}

//----------------------------------------------------------------------------
TEST(TriangulatePolygon, VerticesOnOneLine)
{
  ExpectTriangulated({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 3, 1 }, { 3, 2 }, { 1, 2 } });
  ExpectTriangulated(
    { { 0, 0 }, { 2, 0 }, { 4, 0 }, { 4, 2 }, { 4, 4 }, { 2, 4 }, { 0, 4 }, { 0, 2 } });
}

//----------------------------------------------------------------------------
TEST(TriangulatePolygon, RandomStars)
{
  Random random(1);
  for (int run = 0; run < 300; ++run)
  {
    const std::size_t count = 3 + random.Below(40);
    std::vector<Point2> star;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double angle = 2.0 * 3.14159265358979323846 * (i + 0.5) / count;
      const double radius = random.Uniform(0.1, 1.0);
      star.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
    }
    ExpectTriangulated(star);
  }
}

//----------------------------------------------------------------------------
namespace
{
Reconstruction RunCore(const std::string& text)
{
  Options options;
  options.Orient = Orientation::AsDrawn;
  options.Several = SeveralCycles::Discs;
  return Reconstruct(ParsePieces(text), options, Execution());
}

/// The open sides of a shell are the border of its polygon, and the shell is a disc.
void ExpectDisc(const Reconstruction& result, const PatchMesh& shell)
{
  std::vector<Index> border, places;
  GeometryOf(result).GetBoundary(shell.Cycles.front(), border, places);
  std::map<std::pair<Index, Index>, int> sides;
  std::set<Index> corners;
  for (const auto& t : shell.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      ++sides[{ t[i], t[(i + 1) % 3] }];
      corners.insert(t[i]);
    }
  }
  const auto size = static_cast<Index>(border.size());
  std::size_t open = 0;
  for (const auto& side : sides)
  {
    EXPECT_EQ(side.second, 1);
    if (sides.count({ side.first.second, side.first.first }) == 0)
    {
      EXPECT_GE(side.first.first, 0);
      EXPECT_EQ(side.first.second, (side.first.first + 1) % size);
      ++open;
    }
  }
  EXPECT_EQ(open, border.size());
  const std::size_t edges = (sides.size() + open) / 2;
  EXPECT_EQ(corners.size() + shell.Triangles.size(), edges + 1);
  EXPECT_EQ(corners.size(), border.size() + shell.Points.size());
}

/// The points of a shell lie strictly inside the cell.
void ExpectInside(const Reconstruction& result, const PatchMesh& shell)
{
  for (const Point3& p : shell.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_TRUE(
        result.Grid.IsInside(axis, result.Cycles.Cell[shell.Cycles.front()][axis], p[axis]));
    }
  }
}

void ExpectSoundShells(const Reconstruction& result)
{
  for (std::size_t i = 0; i < result.Surface.Meshes.size(); ++i)
  {
    const PatchMesh& shell = result.Surface.Meshes[i];
    EXPECT_TRUE(i == 0 || result.Surface.Meshes[i - 1].Cycles < shell.Cycles);
    ExpectDisc(result, shell);
    ExpectInside(result, shell);
  }
}
}

//----------------------------------------------------------------------------
TEST(SeparatePatches, LeavesFansThatAreApart)
{
  EXPECT_TRUE(RunCore(Octahedron()).Surface.Meshes.empty());
  EXPECT_TRUE(RunCore(Cube()).Surface.Meshes.empty());
}

//----------------------------------------------------------------------------
TEST(SeparatePatches, MakesShellsOfFansThatCross)
{
  // Inner and outer boundary swap their places within each face, without touching.
  const char* inner = "0,-2 2,0 0,2 -2,0";
  const char* outer = "0,-2.2 5,-5 2.2,0 5,5 0,2.2 -5,5 -2.2,0 -5,-5";
  std::string text;
  for (const char* plane : { "x=0: ", "y=0: ", "z=0: " })
  {
    text += std::string(plane) + inner + "\n" + plane + outer + "\n";
  }
  text += "x=0: 0,-1.9 -0.1,-0.1 -1.9,0 -0.1,0.1 0,1.9 0.1,0.1 1.9,0 0.1,-0.1\n";
  const Reconstruction result = RunCore(text);
  ExpectSoundShells(result);
  EXPECT_EQ(DescribeFlaws(MeshOf(result)), "");
}

//----------------------------------------------------------------------------
namespace
{
/// Stars around the vertex (u, v) of M on the plane, one within another, `rings` of them. They
/// cross the grid lines close to each other; from one ring on, which is another one in every
/// quadrant, they have a long spike there, so that the central points lie far apart.
void AddNestedStars(Pieces& pieces, double plane, double u, double v, int rings, double size)
{
  for (int ring = 0; ring < rings; ++ring)
  {
    const double radius = (0.3 + 0.02 * ring) * size;
    std::vector<std::array<double, 2>> star;
    for (int quadrant = 0; quadrant < 4; ++quadrant)
    {
      const double cosine[4] = { 1, 0, -1, 0 }, sine[4] = { 0, 1, 0, -1 };
      const int next = (quadrant + 1) % 4;
      const bool spike = ring > (pieces.Axis + quadrant) % rings;
      const double diagonal = (spike ? 0.8 : 0.1) * size + 0.02 * ring * size;
      star.push_back({ u + radius * cosine[quadrant], v + radius * sine[quadrant] });
      star.push_back({ u + diagonal * (cosine[quadrant] + cosine[next]),
        v + diagonal * (sine[quadrant] + sine[next]) });
    }
    AddPiece(pieces, star, plane);
  }
}

/// In both precisions; the number of shells in each cell that has any.
std::map<std::array<Index, 3>, int> CountShells(const PieceSets& sets, bool single)
{
  Options options;
  options.SinglePrecision = single;
  options.Several = SeveralCycles::Discs;
  const Reconstruction result = Reconstruct(PieceSets(sets), options, Execution());
  ExpectSoundShells(result);
  EXPECT_EQ(DescribeFlaws(MeshOf(result)), "");
  EXPECT_EQ(result.Reconciled.Vertices + result.Reconciled.Edges, 0);
  std::map<std::array<Index, 3>, int> count;
  for (const PatchMesh& shell : result.Surface.Meshes)
  {
    ++count[result.Cycles.Cell[shell.Cycles.front()]];
  }
  return count;
}
}

/// Cycles around one vertex of a cell lie within each other.
TEST(SeparatePatches, ManyNestedShellsInOneCell)
{
  for (const int rings : { 3, 5, 8 })
  {
    SCOPED_TRACE(rings);
    PieceSets sets = EmptySets();
    for (Pieces& pieces : sets)
    {
      AddNestedStars(pieces, 0.0, 0.0, 0.0, rings, 1.0);
    }
    for (const bool single : { false, true })
    {
      const auto count = CountShells(sets, single);
      EXPECT_EQ(count.size(), 8u);
      for (const auto& cell : count)
      {
        // Those that cross none stay fans.
        EXPECT_TRUE(cell.second >= 2 && cell.second <= rings) << cell.second;
      }
    }
  }
}

//----------------------------------------------------------------------------
/// Groups of nested cycles beside each other, at all corners of the cell in the middle.
TEST(SeparatePatches, NestedShellsAtEveryCornerOfACell)
{
  const int rings = 3;
  PieceSets sets = EmptySets();
  for (Pieces& pieces : sets)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      AddNestedStars(
        pieces, corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 1.0 : 0.0, rings, 0.5);
    }
  }
  for (const bool single : { false, true })
  {
    const auto count = CountShells(sets, single);
    EXPECT_GE(count.at({ 1, 1, 1 }), 8 * 2);
  }
}

//----------------------------------------------------------------------------
TEST(SeparatePatches, ShellsAreDiscsInsideTheirCells)
{
  std::size_t shells = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(80); ++seed)
  {
    const Input input = RandomContradictoryInput(seed);
    SCOPED_TRACE(input.Name);
    Options options = input.Settings;
    options.Several = SeveralCycles::Discs;
    const Reconstruction result = Reconstruct(PieceSets(input.Sets), options, Execution());
    ExpectSoundShells(result);
    shells += result.Surface.Meshes.size();
  }
  EXPECT_GT(shells, 30u);
}

//----------------------------------------------------------------------------
/// With joins that cross: what cannot be built is marked, and what is built is sound.
TEST(SeparatePatches, RandomJoinsAreBuiltOrUndone)
{
  Random random(13);
  int built = 0, impossible = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(150); ++seed)
  {
    const Input input = seed % 2 == 0 ? RandomContradictoryInput(seed) : RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
    const CycleGeometry geometry = GeometryOf(result);
    std::vector<CycleJoin> joins = result.Joins;
    DisjointSets sets(result.Cycles.Count());
    for (CycleJoin& join : joins)
    {
      join.Evidence = random.Uniform(-1.0, 1.0);
      join.Impossible = false;
      join.Chosen = random.Chance(0.4) && sets.Find(join.First) != sets.Find(join.Second);
      if (join.Chosen)
      {
        sets.Unite(join.First, join.Second);
      }
    }
    const std::vector<CycleJoin> before = joins;
    const CellGroups cells = GroupByCell(result.Grid, result.Cycles, Execution());
    const std::vector<PatchMesh> noneStitched;
    PatchSeparator separator(geometry, cells, result.Surface.CentralPoints, noneStitched, true);
    const bool done = separator.Run(Execution(), joins);
    SeparatedPatches separated = separator.Take();
    Index undone = 0;
    for (std::size_t i = 0; i < joins.size(); ++i)
    {
      // Nothing is chosen anew; what was undone is marked.
      EXPECT_TRUE(before[i].Chosen || !joins[i].Chosen);
      EXPECT_EQ(joins[i].Impossible, before[i].Chosen && !joins[i].Chosen);
      undone += joins[i].Impossible ? 1 : 0;
    }
    EXPECT_EQ(done, undone == 0);
    // Chosen joins, and no others, are in one mesh.
    std::map<Index, std::size_t> meshOf;
    std::size_t cyclesInMeshes = 0, joinsInMeshes = 0;
    for (std::size_t m = 0; m < separated.Meshes.size(); ++m)
    {
      EXPECT_EQ(DescribePatchFlaws(geometry, separated.Meshes[m]), "");
      for (const Index cycle : separated.Meshes[m].Cycles)
      {
        EXPECT_TRUE(meshOf.emplace(cycle, m).second);
      }
      cyclesInMeshes += separated.Meshes[m].Cycles.size() - 1;
    }
    for (const CycleJoin& join : joins)
    {
      if (join.Chosen)
      {
        ASSERT_EQ(meshOf.count(join.First), 1u);
        EXPECT_EQ(meshOf.at(join.First), meshOf.at(join.Second));
        ++joinsInMeshes;
      }
    }
    EXPECT_EQ(joinsInMeshes, cyclesInMeshes);
    if (separated.Unresolved.empty())
    {
      result.Surface.Meshes = std::move(separated.Meshes);
      result.Surface.Inner = {};
      LayOutTriangles(result.Graph, result.Cycles, result.Surface);
      EXPECT_EQ(DescribeFlaws(MeshOf(result)), "");
    }
    built += static_cast<int>(joinsInMeshes);
    impossible += undone;
  }
  EXPECT_GT(built, 100);
  EXPECT_GT(impossible, 5);
}
