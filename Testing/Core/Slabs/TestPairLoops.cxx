// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/PairLoops.h"

#include "Support/LoopStack.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(PairLoops, PairsByOverlapAcrossASlabOnly)
{
  const LoopStack stack("z=0: 0,0 2,0 2,2 0,2; z=1: 1,1 3,1 3,3 1,3; z=2: 0,0 2,0 2,2 0,2;"
                        "z=1: 7,7 8,7 8,8");
  const CycleGeometry geometry = stack.Geometry();
  const auto pairs = PairLoops(geometry, CorrespondenceCriterion::Overlap, PriorKnowledge());
  ASSERT_EQ(pairs.size(), 2u);
  for (const LoopPair& pair : pairs)
  {
    EXPECT_LT(pair.First, pair.Second);
    EXPECT_EQ(geometry.Cycles.Cell[pair.First], geometry.Cycles.Cell[pair.Second]);
    const Index a = geometry.Graph.Loops[geometry.LoopOf(pair.First)].Plane;
    const Index b = geometry.Graph.Loops[geometry.LoopOf(pair.Second)].Plane;
    EXPECT_EQ(std::abs(a - b), 1);
  }
}
