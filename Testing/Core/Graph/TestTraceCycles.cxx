// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/TraceCycles.h"

#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Cell = std::array<Index, 3>;
using ArcSet = std::set<Index>;

Point3 PointOf(const NodeGraph& graph, Index i)
{
  return { graph.Points[3 * i], graph.Points[3 * i + 1], graph.Points[3 * i + 2] };
}

/// Cycles as sets of arcs, by cell.
std::map<Cell, std::set<ArcSet>> TracedCycles(const Stages& stages)
{
  std::map<Cell, std::set<ArcSet>> cycles;
  for (Index i = 0; i < stages.Cycles.Count(); ++i)
  {
    ArcSet arcs;
    for (Index a = stages.Cycles.Offsets[i]; a < stages.Cycles.Offsets[i + 1]; ++a)
    {
      arcs.insert(stages.Cycles.Arcs[a].Arc);
    }
    cycles[stages.Cycles.Cell[i]].insert(arcs);
  }
  return cycles;
}

/**
 * The two cells beside an arc by geometry alone: a place in the middle of its first segment lies
 * within the slabs of its face, and the slice is the upper plane of one cell and the lower of the
 * other.
 */
std::array<Cell, 2> CellsBeside(const Stages& stages, Index arc)
{
  const Point3 a = PointOf(stages.Graph, stages.Nodes.NodeOf[arc]);
  const Point3 b = stages.Graph.PointCount(arc) > 0
    ? PointOf(stages.Graph, stages.Graph.FirstPoint(arc))
    : PointOf(stages.Graph, stages.Nodes.NodeOf[stages.Crossings.Next[arc]]);
  const GridEdge edge = stages.EdgeOf(arc);
  const bool first = stages.Crossings.Family[arc] == 0;
  const int axis = first ? FirstAxis(edge.Direction) : SecondAxis(edge.Direction);
  const Index plane = first ? edge.First : edge.Second;
  Cell cell;
  for (int i = 0; i < 3; ++i)
  {
    cell[i] = i == axis ? plane : stages.Grid.Slab(i, 0.5 * (a[i] + b[i]));
  }
  Cell above = cell;
  ++above[axis];
  return { cell, above };
}

/// In each cell: the sets of arcs that are connected through its nodes.
std::map<Cell, std::set<ArcSet>> CyclesByBruteForce(const Stages& stages)
{
  std::map<Cell, ArcSet> arcs;
  for (Index arc = 0; arc < stages.Crossings.Count(); ++arc)
  {
    if (!stages.Crossings.IsRemoved(arc))
    {
      for (const Cell& cell : CellsBeside(stages, arc))
      {
        arcs[cell].insert(arc);
      }
    }
  }
  std::map<Cell, std::set<ArcSet>> cycles;
  for (auto& entry : arcs)
  {
    while (!entry.second.empty())
    {
      ArcSet cycle{ *entry.second.begin() };
      std::set<Index> nodes;
      for (std::size_t before = 0; before != cycle.size();)
      {
        before = cycle.size();
        for (const Index arc : cycle)
        {
          nodes.insert(stages.Nodes.NodeOf[arc]);
          nodes.insert(stages.Nodes.NodeOf[stages.Crossings.Next[arc]]);
        }
        for (const Index arc : entry.second)
        {
          if (nodes.count(stages.Nodes.NodeOf[arc]) ||
            nodes.count(stages.Nodes.NodeOf[stages.Crossings.Next[arc]]))
          {
            cycle.insert(arc);
          }
        }
      }
      EXPECT_EQ(nodes.size(), cycle.size()); // every node has two arcs: it is one cycle
      for (const Index arc : cycle)
      {
        entry.second.erase(arc);
      }
      cycles[entry.first].insert(cycle);
    }
  }
  return cycles;
}
}

//----------------------------------------------------------------------------
TEST(TraceCycles, OctahedronHasATriangleInEveryOctant)
{
  const Stages stages{ Octahedron() };
  ASSERT_EQ(stages.Cycles.Count(), 8);
  for (Index i = 0; i < 8; ++i)
  {
    EXPECT_EQ(stages.Cycles.Size(i), 3);
  }
  std::set<Cell> cells(stages.Cycles.Cell.begin(), stages.Cycles.Cell.end());
  EXPECT_EQ(cells.size(), 8u);
  EXPECT_EQ(cells.count({ 0, 1, 0 }), 1u);
}

//----------------------------------------------------------------------------
TEST(TraceCycles, CubeHasOneInEveryCellButTheMiddle)
{
  const Stages stages{ Cube() };
  ASSERT_EQ(stages.Cycles.Count(), 26);
  EXPECT_EQ(CountPolygonSizes(stages.Cycles, stages.Graph), (std::vector<Index>{ 0, 0, 0, 8, 18 }));
  EXPECT_EQ(GroupByCell(stages.Grid, stages.Cycles, Execution()).Several.size(), 0u);
  for (Index i = 0; i < 26; ++i)
  {
    const Cell& cell = stages.Cycles.Cell[i];
    const auto middles = std::count(cell.begin(), cell.end(), 1);
    EXPECT_EQ(stages.Cycles.Size(i), middles == 0 ? 3 : 4);
    EXPECT_LT(middles, 3);
  }
}

//----------------------------------------------------------------------------
TEST(TraceCycles, TwoSheetsThroughACellAreTwoCycles)
{
  // A thin plate between the planes z = 0 and z = 1, which it does not meet.
  std::string text = "z=0: 8,8 9,8 9,9 8,9; z=1: 8,8 9,8 9,9 8,9\n";
  for (const char* plane : { "0", "1" })
  {
    text += std::string("x=") + plane + ": -1,0.2 2,0.2 2,0.8 -1,0.8\n";
    text += std::string("y=") + plane + ": 0.2,-1 0.8,-1 0.8,2 0.2,2\n";
  }
  const Stages stages(text);
  const CellGroups groups = GroupByCell(stages.Grid, stages.Cycles, Execution());
  ASSERT_EQ(groups.Several.size(), 1u);
  ASSERT_EQ(groups.Several[0].second - groups.Several[0].first, 2);
  for (Index i = groups.Several[0].first; i < groups.Several[0].second; ++i)
  {
    EXPECT_EQ(stages.Cycles.Cell[groups.Cycles[i]], (Cell{ 1, 1, 1 }));
    EXPECT_EQ(stages.Cycles.Size(groups.Cycles[i]), 4);
  }
}

//----------------------------------------------------------------------------
TEST(TraceCycles, CellsWithSeveralCyclesAsBruteForceHasThem)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    SCOPED_TRACE(seed);
    const CellGroups groups = GroupByCell(stages.Grid, stages.Cycles, Execution());
    const std::set<Index> all(groups.Cycles.begin(), groups.Cycles.end());
    EXPECT_EQ(all.size(), static_cast<std::size_t>(stages.Cycles.Count()));
    std::size_t several = 0;
    for (const auto& entry : TracedCycles(stages))
    {
      several += entry.second.size() > 1 ? 1 : 0;
    }
    EXPECT_EQ(groups.Several.size(), several);
  }
}

//----------------------------------------------------------------------------
TEST(TraceCycles, AsASearchInEveryCellFindsThem)
{
  std::size_t cells = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed)
  {
    const Input input = RandomConsistentInput(seed);
    SCOPED_TRACE(input.Name);
    const Stages stages(input);
    const auto traced = TracedCycles(stages);
    EXPECT_EQ(traced, CyclesByBruteForce(stages));
    cells += traced.size();
  }
  EXPECT_GT(cells, 1000u);
}

//----------------------------------------------------------------------------
TEST(TraceCycles, EveryArcIsPassedOnceAboveAndOnceBelowItsSlice)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    SCOPED_TRACE(seed);
    std::vector<int> passed(2 * stages.Crossings.Count(), 0);
    for (const HalfArc& half : stages.Cycles.Arcs)
    {
      ++passed[2 * half.Arc + (half.Above ? 1 : 0)];
    }
    for (Index arc = 0; arc < stages.Crossings.Count(); ++arc)
    {
      const int expected = stages.Crossings.IsRemoved(arc) ? 0 : 1;
      EXPECT_EQ(passed[2 * arc], expected);
      EXPECT_EQ(passed[2 * arc + 1], expected);
    }
  }
}

//----------------------------------------------------------------------------
TEST(TraceCycles, SeveralCyclesAndSizesAreCountedAsByHand)
{
  SpatialGrid grid;
  grid.Planes = { std::vector<double>{ 0, 1 }, std::vector<double>{ 0, 1 },
    std::vector<double>{ 0, 1 } };
  CellCycles cycles;
  cycles.Cell = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, { 2, 2, 2 }, { 1, 0, 0 }, { 1, 0, 0 } };
  cycles.Offsets = { 0, 3, 7, 10, 15, 17, 21 };
  cycles.Arcs.resize(21);
  EXPECT_EQ(GroupByCell(grid, cycles, Execution()).Several.size(), 2u);
  EXPECT_EQ(CountPolygonSizes(cycles, NodeGraph()), (std::vector<Index>{ 0, 0, 1, 2, 2, 1 }));
}

//----------------------------------------------------------------------------
TEST(GetBoundary, GoesAroundTheCycleOverNodesAndArcVertices)
{
  const Stages stages{ Cube() };
  const auto at = std::find(stages.Cycles.Cell.begin(), stages.Cycles.Cell.end(), Cell{ 0, 0, 0 });
  const auto cycle = static_cast<Index>(at - stages.Cycles.Cell.begin());
  std::vector<Index> points{ 99, 99 }, nodes{ 99 };
  stages.Geometry().GetBoundary(cycle, points, nodes);
  ASSERT_EQ(points.size(), 6u);
  EXPECT_EQ(nodes, (std::vector<Index>{ 0, 2, 4 }));
  // Counter-clockwise seen from outside, that is from the corner (0, 0, 0).
  std::vector<Point3> found;
  for (const Index point : points)
  {
    found.push_back(PointOf(stages.Graph, point));
  }
  const std::vector<Point3> expected{ { 0.5, 1, 1 }, { 0.5, 1, 0.5 }, { 1, 1, 0.5 },
    { 1, 0.5, 0.5 }, { 1, 0.5, 1 }, { 0.5, 0.5, 1 } };
  const auto start = std::find(expected.begin(), expected.end(), found[0]);
  ASSERT_NE(start, expected.end());
  for (std::size_t i = 0; i < 6; ++i)
  {
    EXPECT_EQ(found[i], expected[(i + (start - expected.begin())) % 6]) << i;
  }
}
