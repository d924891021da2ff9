// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/SlabGroup.h"

#include "Core/Slabs/PairLoops.h"
#include "Support/LoopStack.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(SlabGroup, TheCyclesOfALoopLieInTheCellsBelowAndAboveIt)
{
  const LoopStack stack(TwoSquares);
  const CycleGeometry geometry = stack.Geometry();
  for (Index loop = 0; loop < 2; ++loop)
  {
    const Index plane = geometry.Graph.Loops[loop].Plane;
    EXPECT_EQ(geometry.Cycles.Cell[CycleOfLoop(geometry, loop, false)][2], plane);
    EXPECT_EQ(geometry.Cycles.Cell[CycleOfLoop(geometry, loop, true)][2], plane + 1);
  }
}

//----------------------------------------------------------------------------
TEST(SlabGroup, ACriterionFormsGroupsOfItsOwn)
{
  // Side by side on both slices: overlay takes them together, pairs take them apart.
  const LoopStack stack("z=0: 0,0 1,0 1,1 0,1; z=0: 5,0 6,0 6,1 5,1; z=1: 0,0 1,0 1,1 0,1;"
                        "z=1: 5,0 6,0 6,1 5,1");
  const CycleGeometry geometry = stack.Geometry();
  const auto pairs = PairLoops(geometry, CorrespondenceCriterion::Overlap, PriorKnowledge());
  const auto sizes = [&](CorrespondenceCriterion criterion)
  {
    std::vector<std::size_t> result;
    for (const SlabGroup& group : FormSlabGroups(geometry, criterion, pairs))
    {
      result.push_back(group.Loops.size());
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  EXPECT_EQ(sizes(CorrespondenceCriterion::Overlap), (std::vector<std::size_t>{ 2, 2, 4 }));
  EXPECT_EQ(
    sizes(CorrespondenceCriterion::SpanningTree), (std::vector<std::size_t>{ 1, 1, 1, 1, 2, 2 }));
}

//----------------------------------------------------------------------------
TEST(SlabGroup, WhatDoesNotOverlapIsShearedIfThatIsAllowed)
{
  const LoopStack stack("z=0: 0,0 1,0 1,1 0,1; z=1: 5,2 6,2 6,3 5,3");
  const CycleGeometry geometry = stack.Geometry();
  auto groups = FormSlabGroups(geometry, CorrespondenceCriterion::Overlap, {});
  const auto between = std::find_if(
    groups.begin(), groups.end(), [](const SlabGroup& group) { return group.Loops.size() == 2; });
  ASSERT_NE(between, groups.end());
  SlabGroup straight = *between;
  OverlayGroup(false, straight);
  EXPECT_TRUE(straight.Overlay.Valid);
  EXPECT_EQ(CountPieces(straight.Overlay), 2);
  EXPECT_EQ(straight.Shift, (Point2{ 0.0, 0.0 }));
  SlabGroup sheared = *between;
  OverlayGroup(true, sheared);
  EXPECT_TRUE(sheared.Overlay.Valid);
  EXPECT_EQ(CountPieces(sheared.Overlay), 1);
  EXPECT_NEAR(sheared.Shift[0], 5.0, 1e-12);
  EXPECT_NEAR(sheared.Shift[1], 2.0, 1e-12);
}
