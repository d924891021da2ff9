// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/CycleGeometry.h"

#include "Support/LoopStack.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(CycleGeometry, TheBorderOfACycleGoesFromNodeToNodeAlongItsArcs)
{
  const Stages stages{ Cube(3) };
  const CycleGeometry geometry = stages.Geometry();
  std::vector<Index> points, nodes;
  for (Index cycle = 0; cycle < stages.Cycles.Count(); ++cycle)
  {
    geometry.GetBoundary(cycle, points, nodes);
    ASSERT_EQ(static_cast<Index>(nodes.size()), stages.Cycles.Size(cycle));
    Index expected = 0;
    for (Index i = 0; i < stages.Cycles.Size(cycle); ++i)
    {
      const HalfArc& half = stages.Cycles.Arcs[stages.Cycles.Offsets[cycle] + i];
      EXPECT_EQ(nodes[i], expected);
      EXPECT_EQ(points[nodes[i]], StartNode(stages.Crossings, stages.Nodes, half));
      EXPECT_LT(points[nodes[i]], stages.Graph.Nodes);
      expected += 1 + stages.Graph.PointCount(half.Arc);
    }
    EXPECT_EQ(static_cast<Index>(points.size()), expected);
    EXPECT_EQ(geometry.PartOf(cycle), points.front());
    EXPECT_FALSE(geometry.IsLoop(cycle));
  }
}

//----------------------------------------------------------------------------
TEST(CycleGeometry, ALoopIsPassedForwardAboveItsSliceAndBackwardBelow)
{
  const LoopStack stack("z=0: 0,0 2,0 2,2 0,2");
  const CycleGeometry geometry = stack.Geometry();
  ASSERT_EQ(geometry.Cycles.Count(), 2);
  std::vector<Index> below, above, nodes;
  geometry.GetBoundary(0, below, nodes);
  EXPECT_TRUE(nodes.empty());
  geometry.GetBoundary(1, above, nodes);
  EXPECT_EQ(above, (std::vector<Index>{ 0, 1, 2, 3 }));
  EXPECT_EQ(below, (std::vector<Index>{ 3, 2, 1, 0 }));
  EXPECT_TRUE(geometry.IsLoop(0));
  EXPECT_EQ(geometry.LoopOf(1), 0);
  EXPECT_EQ(geometry.GetBorders({ 0, 1 }), (std::vector<Index>{ 3, 2, 1, 0, 0, 1, 2, 3 }));
}
