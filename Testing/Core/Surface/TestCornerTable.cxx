// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/CornerTable.h"

#include "Support/CheckSurface.h"
#include "Support/ClosedMeshes.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
CornerTable TableOf(const PlainMesh& mesh)
{
  return CornerTable(static_cast<Index>(mesh.Points.size()), mesh.Triangles);
}

/// Combinatorial: all points lie at the origin. Those that are not used any more are left out.
SurfaceCheck Check(const CornerTable& table)
{
  std::map<Index, std::int64_t> number;
  TriangleMesh mesh;
  for (const auto& triangle : table.ListTriangles())
  {
    std::array<std::int64_t, 3> ids;
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = number.emplace(triangle[i], static_cast<std::int64_t>(number.size())).first->second;
    }
    mesh.Triangles.push_back(ids);
  }
  mesh.Points.assign(number.size(), Point3{ 0.0, 0.0, 0.0 });
  return CheckSurface(mesh);
}

/// What the links between corners say, against the list of the triangles.
void ExpectConsistent(const CornerTable& table)
{
  std::set<Index> used;
  for (Index corner = 0; corner < table.CornerCount(); ++corner)
  {
    if (!table.IsAlive(corner))
    {
      continue;
    }
    const Index across = table.OppositeOf(corner);
    ASSERT_TRUE(table.IsAlive(across));
    ASSERT_EQ(table.OppositeOf(across), corner);
    ASSERT_EQ(table.StartOf(across), table.EndOf(corner));
    ASSERT_EQ(table.EndOf(across), table.StartOf(corner));
    ASSERT_EQ(table.IsCurve(across), table.IsCurve(corner));
    ASSERT_EQ(table.FindEdge(table.StartOf(corner), table.EndOf(corner)), corner);
    used.insert(table.VertexOf(corner));
  }
  for (Index vertex = 0; vertex < table.PointCount(); ++vertex)
  {
    ASSERT_EQ(table.IsUsed(vertex), used.count(vertex) > 0);
    if (table.IsUsed(vertex))
    {
      ASSERT_TRUE(table.IsAlive(table.CornerAt(vertex)));
      ASSERT_EQ(table.VertexOf(table.CornerAt(vertex)), vertex);
    }
  }
}

/// Curves as a graph: how many vertices have which number of curves, without those with two, and
/// the number of connected pieces. It stays, whatever edges collapse or are split.
struct CurveTopology
{
  std::multiset<std::size_t> Ends;
  std::size_t Pieces = 0;

  bool operator==(const CurveTopology& other) const
  {
    return this->Ends == other.Ends && this->Pieces == other.Pieces;
  }
};

CurveTopology CurvesOf(const CornerTable& table)
{
  std::map<Index, std::vector<Index>> neighbors;
  for (Index corner = 0; corner < table.CornerCount(); ++corner)
  {
    if (table.IsAlive(corner) && table.IsCurve(corner))
    {
      neighbors[table.StartOf(corner)].push_back(table.EndOf(corner)); // once from each side
    }
  }
  CurveTopology result;
  std::set<Index> seen;
  for (const auto& [vertex, others] : neighbors)
  {
    if (others.size() != 2)
    {
      result.Ends.insert(others.size());
    }
    result.Pieces += seen.insert(vertex).second ? 1 : 0;
    for (std::vector<Index> stack{ vertex }; !stack.empty();)
    {
      const Index at = stack.back();
      stack.pop_back();
      for (const Index other : neighbors[at])
      {
        if (seen.insert(other).second)
        {
          stack.push_back(other);
        }
      }
    }
  }
  return result;
}

/// One random operation, if the table permits it; whether it was made.
bool ChangeAtRandom(Random& random, double splits, CornerTable& table)
{
  const Index corner = static_cast<Index>(random.Below(table.CornerCount()));
  if (!table.IsAlive(corner))
  {
    return false;
  }
  if (random.Chance(splits))
  {
    table.Split(corner);
    return true;
  }
  if (random.Chance(0.4))
  {
    const bool may = table.CanFlip(corner);
    may ? table.Flip(corner) : static_cast<void>(0);
    return may;
  }
  const bool may = table.CanCollapse(corner);
  may ? table.Collapse(corner) : static_cast<void>(0);
  return may;
}

/// Grows and shrinks a mesh by random operations.
void ChangeAndCheck(std::uint64_t seed, CornerTable table)
{
  const SurfaceCheck before = Check(table);
  ASSERT_TRUE(before.IsClosedManifold()) << before;
  const CurveTopology curves = CurvesOf(table);
  Random random(seed);
  int made = 0;
  for (int step = 0; step < 1200; ++step)
  {
    // Grows at first; in the end hardly anything is left.
    made += ChangeAtRandom(random, step < 400 ? 0.4 : 0.05, table) ? 1 : 0;
    if (step % 40 == 0)
    {
      const SurfaceCheck after = Check(table);
      ASSERT_TRUE(after.IsClosedManifold()) << after << " step " << step;
      ASSERT_EQ(after.Components, before.Components);
      ASSERT_EQ(after.Euler, before.Euler);
      ASSERT_TRUE(CurvesOf(table) == curves) << "step " << step;
      ExpectConsistent(table);
    }
  }
  EXPECT_GT(made, 200);
}
}

//----------------------------------------------------------------------------
TEST(CornerTable, RandomOperationsKeepTheTopology)
{
  PlainMesh both = OctahedronMesh();
  both.Append(TorusMesh(5, 4));
  for (std::uint64_t seed = 0; seed < 8; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ChangeAndCheck(seed, TableOf(OctahedronMesh()));
    ChangeAndCheck(seed, TableOf(TorusMesh(4, 3)));
    ChangeAndCheck(seed, TableOf(both));
  }
}

//----------------------------------------------------------------------------
/// Two circles that meet each other, and one for itself on another component.
TEST(CornerTable, RandomOperationsKeepTheCurves)
{
  PlainMesh both = OctahedronMesh();
  both.Append(TorusMesh(5, 4));
  for (std::uint64_t seed = 0; seed < 8; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    CornerTable table = TableOf(both);
    for (const auto& edge : { std::pair<Index, Index>(0, 1), { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 },
           { 4, 2 }, { 2, 5 }, { 5, 0 }, { 6, 7 }, { 7, 8 }, { 8, 9 }, { 9, 6 } })
    {
      table.MarkCurve(table.FindEdge(edge.first, edge.second));
    }
    const CurveTopology curves = CurvesOf(table);
    ASSERT_EQ(curves.Pieces, 2u);
    ASSERT_EQ(curves.Ends.size(), 2u); // where the circles meet
    ChangeAndCheck(seed, table);
  }
}

//----------------------------------------------------------------------------
TEST(CornerTable, TetrahedronStays)
{
  const CornerTable table = TableOf(TetrahedronMesh());
  for (Index corner = 0; corner < table.CornerCount(); ++corner)
  {
    EXPECT_FALSE(table.CanCollapse(corner));
    EXPECT_FALSE(table.CanFlip(corner)); // the other diagonal is an edge already
  }
}

//----------------------------------------------------------------------------
/// Rings of three around a tube: an edge of the inner ring is part of a triangle of edges that is
/// no triangle of the surface. Its collapse would pinch the tube.
TEST(CornerTable, TubeOfTrianglesIsNotPinched)
{
  const PlainMesh prism = RingMesh(3, { 1, 1, 1 }, { 0, 1, 2 }, -1, 3);
  CornerTable table = TableOf(prism);
  for (Index i = 0; i < 3; ++i)
  {
    const Index from = 3 + i, to = 3 + (i + 1) % 3;
    EXPECT_FALSE(table.CanCollapse(table.FindEdge(from, to)));
    EXPECT_FALSE(table.CanCollapse(table.FindEdge(to, from)));
  }
  const Index along = table.FindEdge(3, 0);
  ASSERT_TRUE(table.CanCollapse(along));
  table.Collapse(along);
  EXPECT_FALSE(table.IsUsed(3));
  const SurfaceCheck check = Check(table);
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.Euler, 2);
  ExpectConsistent(table);
}

//----------------------------------------------------------------------------
/// A point beside a curve may move onto it; one on the curve moves along it only.
TEST(CornerTable, PointsLeaveNoCurve)
{
  CornerTable table = TableOf(RingMesh(5, { 1, 1, 1 }, { 0, 1, 2 }, -1, 3));
  for (Index i = 0; i < 5; ++i)
  {
    table.MarkCurve(table.FindEdge(5 + i, 5 + (i + 1) % 5));
  }
  EXPECT_FALSE(table.CanCollapse(table.FindEdge(5, 0)));
  EXPECT_TRUE(table.CanCollapse(table.FindEdge(0, 5)));
  EXPECT_TRUE(table.CanCollapse(table.FindEdge(5, 6)));
  EXPECT_FALSE(table.CanFlip(table.FindEdge(5, 6)));
  EXPECT_TRUE(table.CanFlip(table.FindEdge(0, 1)));
}

//----------------------------------------------------------------------------
/// Curves on neighbouring rings: what joins them must not collapse from either side.
TEST(CornerTable, TwoCurvesStayApart)
{
  CornerTable table = TableOf(RingMesh(5, { 1, 1 }, { 0, 1 }, -1, 3));
  for (Index i = 0; i < 10; ++i)
  {
    table.MarkCurve(table.FindEdge(i, i / 5 * 5 + (i + 1) % 5));
  }
  for (Index i = 0; i < 5; ++i)
  {
    EXPECT_FALSE(table.CanCollapse(table.FindEdge(i, i + 5)));
    EXPECT_FALSE(table.CanCollapse(table.FindEdge(i + 5, i)));
  }
}

//----------------------------------------------------------------------------
/// A curve of three edges around a triangle would become one with itself.
TEST(CornerTable, ShortestCurveStays)
{
  CornerTable table = TableOf(RingMesh(3, { 1, 1, 1 }, { 0, 1, 2 }, -1, 3));
  const Index apex = 10; // the upper end
  for (const auto& edge : { std::pair<Index, Index>(6, 7), { 7, apex }, { apex, 6 } })
  {
    table.MarkCurve(table.FindEdge(edge.first, edge.second));
  }
  for (const auto& edge : { std::pair<Index, Index>(6, 7), { 7, apex }, { apex, 6 } })
  {
    EXPECT_FALSE(table.CanCollapse(table.FindEdge(edge.first, edge.second)));
    EXPECT_FALSE(table.CanCollapse(table.FindEdge(edge.second, edge.first)));
  }
}

//----------------------------------------------------------------------------
TEST(CornerTable, SplitCurveIsACurveInBothParts)
{
  CornerTable table = TableOf(OctahedronMesh());
  table.MarkCurve(table.FindEdge(0, 1));
  const Index middle = table.Split(table.FindEdge(0, 1));
  EXPECT_EQ(middle, 6);
  EXPECT_EQ(table.Valence(middle), 4);
  EXPECT_EQ(table.FindEdge(0, 1), -1);
  EXPECT_TRUE(table.IsCurve(table.FindEdge(0, middle)));
  EXPECT_TRUE(table.IsCurve(table.FindEdge(middle, 1)));
  EXPECT_FALSE(table.IsCurve(table.FindEdge(middle, 4)));
  EXPECT_FALSE(table.IsCurve(table.FindEdge(middle, 5)));
  ExpectConsistent(table);
}
