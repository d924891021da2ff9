// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/CheckCrossings.h"

#include "Support/Stages.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(CheckCrossings, HoldsForTheCube)
{
  const Stages stages{ Cube() };
  EXPECT_EQ(CheckCrossingOrder(stages.Crossings), "");
  EXPECT_EQ(CheckSlicesAgree(stages.Crossings, stages.Edges), "");
  EXPECT_EQ(CheckNodePoints(stages.Crossings, stages.Nodes), "");
}

//----------------------------------------------------------------------------
TEST(CheckCrossings, FindsSlicesThatContradictEachOther)
{
  // Without its z-slice, the octahedron's other two say nothing of it.
  const Stages stages("x=0: -1,-1 1,-1 1,1 -1,1; y=0: 4,4 5,4 5,5 4,5; z=0: -1,-1 1,-1 1,1 -1,1");
  EXPECT_NE(CheckSlicesAgree(stages.Registered, FileOnEdges(stages.Registered)), "");
  EXPECT_EQ(CheckSlicesAgree(stages.Crossings, stages.Edges), "");
}

//----------------------------------------------------------------------------
TEST(CheckCrossings, FindsWrongTables)
{
  Stages order{ Cube() };
  order.Crossings.Previous[order.Crossings.Next[0]] = 7;
  EXPECT_NE(CheckCrossingOrder(order.Crossings), "");
  Stages nodes{ Cube() };
  std::swap(nodes.Nodes.First[0], nodes.Nodes.First[1]);
  EXPECT_NE(CheckNodePoints(nodes.Crossings, nodes.Nodes), "");
  Stages removed{ Cube() };
  removed.Crossings.Next[0] = GridCrossings::Removed;
  EXPECT_NE(CheckNodePoints(removed.Crossings, removed.Nodes), "");
}
