// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/CheckGraph.h"

#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(CheckGraph, HoldsForTheCube)
{
  const Stages stages{ Cube(3) };
  EXPECT_EQ(CheckFourArcs(stages.Crossings, stages.Nodes, stages.Graph), "");
  EXPECT_EQ(CheckEmbedding(stages.Grid, stages.Crossings, stages.Nodes, stages.Graph), "");
  EXPECT_EQ(CheckCycles(stages.Geometry()), "");
}

//----------------------------------------------------------------------------
TEST(CheckGraph, FindsTablesThatDoNotFit)
{
  Stages stages{ Cube() };
  stages.Graph.Points.pop_back();
  EXPECT_NE(CheckFourArcs(stages.Crossings, stages.Nodes, stages.Graph), "");
}

//----------------------------------------------------------------------------
TEST(CheckGraph, FindsAnArcThatLeadsElsewhere)
{
  Stages stages{ Cube() };
  stages.Crossings.Next[0] = stages.Crossings.Next[1];
  EXPECT_NE(CheckFourArcs(stages.Crossings, stages.Nodes, stages.Graph), "");
}

//----------------------------------------------------------------------------
TEST(CheckGraph, FindsArcsThatTouch)
{
  Stages stages{ Cube(3) };
  // Two vertices of one arc exchange their places: its segments overlap.
  for (Index arc = 0; arc < stages.Graph.Arcs; ++arc)
  {
    if (stages.Graph.PointCount(arc) >= 2)
    {
      double* p = stages.Graph.Points.data() + 3 * stages.Graph.FirstPoint(arc);
      std::swap_ranges(p, p + 3, p + 3);
      break;
    }
  }
  EXPECT_NE(CheckEmbedding(stages.Grid, stages.Crossings, stages.Nodes, stages.Graph), "");
}

//----------------------------------------------------------------------------
TEST(CheckGraph, FindsAVertexOffItsPlane)
{
  Stages stages{ Cube(3) };
  const Index point = stages.Graph.Nodes;
  for (int axis = 0; axis < 3; ++axis)
  {
    stages.Graph.Points[3 * point + axis] += 0.01;
  }
  EXPECT_NE(CheckEmbedding(stages.Grid, stages.Crossings, stages.Nodes, stages.Graph), "");
}

//----------------------------------------------------------------------------
TEST(CheckGraph, FindsATornCycleAndAnArcUsedTwice)
{
  Stages torn{ Cube() };
  std::swap(torn.Cycles.Arcs[0], torn.Cycles.Arcs[2]);
  EXPECT_NE(CheckCycles(torn.Geometry()), "");
  Stages twice{ Cube() };
  twice.Cycles.Arcs[0] = twice.Cycles.Arcs[1];
  EXPECT_NE(CheckCycles(twice.Geometry()), "");
}
