// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/LayOutTriangles.h"

#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Fans only.
Patches LayOut(const Stages& stages)
{
  Patches patches;
  patches.CentralPoints.resize(3 * stages.Cycles.Count());
  LayOutTriangles(stages.Graph, stages.Cycles, patches);
  return patches;
}

template <typename Id>
std::vector<Id> Write(const Stages& stages, const Patches& patches, Index slack = 0)
{
  std::vector<Id> ids(3 * patches.TriangleCount() + slack, -7);
  WriteTriangles(patches, stages.Geometry(), Execution(), ids.data());
  return ids;
}
}

//----------------------------------------------------------------------------
TEST(Triangles, OneForEachSegmentOfEachBorder)
{
  const Stages stages{ Cube() };
  const Patches layout = LayOut(stages);
  // Corners: 3 nodes and 3 vertices. Edges: 4 nodes and 2 vertices. Faces: 4 nodes.
  EXPECT_EQ(layout.TriangleCount(), 8 * 6 + 12 * 6 + 6 * 4);
  for (Index i = 0; i < stages.Cycles.Count(); ++i)
  {
    const auto& cell = stages.Cycles.Cell[i];
    const bool face = std::count(cell.begin(), cell.end(), 1) == 2;
    EXPECT_EQ(layout.Offsets[i + 1] - layout.Offsets[i], face ? 4 : 6);
  }
}

//----------------------------------------------------------------------------
TEST(Triangles, FanAroundTheCentralPoint)
{
  const Stages stages{ Cube() };
  const Patches layout = LayOut(stages);
  const auto ids = Write<std::int32_t>(stages, layout);
  std::vector<Index> border, nodes;
  for (Index cycle = 0; cycle < stages.Cycles.Count(); ++cycle)
  {
    stages.Geometry().GetBoundary(cycle, border, nodes);
    std::set<std::pair<Index, Index>> segments, found;
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      segments.emplace(border[i], border[(i + 1) % border.size()]);
    }
    for (std::int64_t t = layout.Offsets[cycle]; t < layout.Offsets[cycle + 1]; ++t)
    {
      EXPECT_EQ(ids[3 * t], stages.Graph.Count() + cycle);
      found.emplace(ids[3 * t + 1], ids[3 * t + 2]);
    }
    EXPECT_EQ(found, segments);
  }
}

//----------------------------------------------------------------------------
TEST(Triangles, WritesItsPlacesAndNoMore)
{
  const Stages stages{ Octahedron() };
  const Patches layout = LayOut(stages);
  const auto ids = Write<std::int32_t>(stages, layout, 3);
  const auto end = ids.begin() + 3 * layout.TriangleCount();
  EXPECT_EQ(std::count(ids.begin(), end, -7), 0);
  EXPECT_EQ(std::count(end, ids.end(), -7), 3);
}

//----------------------------------------------------------------------------
TEST(Triangles, SameInBothIdTypes)
{
  const Stages stages(RandomConsistentInput(0));
  const Patches layout = LayOut(stages);
  const auto narrow = Write<std::int32_t>(stages, layout);
  const auto wide = Write<long long>(stages, layout);
  ASSERT_GT(narrow.size(), 0u);
  EXPECT_TRUE(std::equal(narrow.begin(), narrow.end(), wide.begin(), wide.end()));
}

//----------------------------------------------------------------------------
TEST(Triangles, OfNothing)
{
  NodeGraph graph;
  graph.Offsets = { 0 };
  Patches patches;
  LayOutTriangles(graph, CellCycles(), patches);
  EXPECT_EQ(patches.TriangleCount(), 0);
}
