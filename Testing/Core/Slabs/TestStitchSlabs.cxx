// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/StitchSlabs.h"

#include "Core/Cells/CheckPatchMeshes.h"
#include "Core/Graph/CheckGraph.h"
#include "Core/Slabs/PairLoops.h"
#include "Support/LoopStack.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
StitchedSlabs Stitch(const LoopStack& stack, CorrespondenceCriterion criterion)
{
  return StitchSlabs(stack.Geometry(), criterion,
    PairLoops(stack.Geometry(), criterion, PriorKnowledge()), Execution());
}
}

//----------------------------------------------------------------------------
TEST(StitchSlabs, SquaresThatOverlapBoundOnePatch)
{
  const LoopStack stack(TwoSquares);
  const StitchedSlabs stitched = Stitch(stack, CorrespondenceCriterion::ByEvidence);
  // The slab between them, and the two ends beyond.
  ASSERT_EQ(stitched.Patches.size(), 3u);
  std::vector<std::size_t> sizes;
  for (const PatchMesh& patch : stitched.Patches)
  {
    sizes.push_back(patch.Cycles.size());
  }
  std::sort(sizes.begin(), sizes.end());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{ 1, 1, 2 }));
  // Their sides cross in two points, which both squares get.
  ASSERT_EQ(stitched.Loops.size(), 2u);
  EXPECT_EQ(stitched.Loops[0].Points.size(), 6u);
  EXPECT_EQ(stitched.Loops[1].Points.size(), 6u);
}

//----------------------------------------------------------------------------
TEST(StitchSlabs, LeavesTheGraphAloneAndReturnsWhatItNeeds)
{
  LoopStack stack(TwoSquares);
  const NodeGraph before = stack.Result.Graph;
  const StitchedSlabs stitched = Stitch(stack, CorrespondenceCriterion::ByEvidence);
  EXPECT_EQ(stack.Result.Graph.Points, before.Points);
  EXPECT_EQ(stack.Result.Graph.Offsets, before.Offsets);
  SetLoops(stitched.Loops, stack.Result.Graph);
  EXPECT_EQ(CheckPatchMeshes(stack.Geometry(), stitched.Patches), "");
  EXPECT_EQ(CheckEmbedding(
              stack.Result.Grid, stack.Result.Crossings, stack.Result.Nodes, stack.Result.Graph),
    "");
  // All old vertices are there, in their order.
  for (Index loop = 0; loop < 2; ++loop)
  {
    const std::vector<Point3>& points = stitched.Loops[loop].Points;
    auto at = points.begin();
    for (Index i = 0; i < before.PointCount(before.Arcs + loop); ++i)
    {
      at = std::find(at, points.end(), before.PointAt(before.FirstPoint(before.Arcs + loop) + i));
      EXPECT_NE(at, points.end());
    }
  }
}

//----------------------------------------------------------------------------
TEST(StitchSlabs, OtherFamiliesLeaveNothingToStitch)
{
  const LoopStack stack(std::string(TwoSquares) + "; x=9: 0,0 1,0 1,1");
  const StitchedSlabs stitched = Stitch(stack, CorrespondenceCriterion::ByEvidence);
  EXPECT_TRUE(stitched.Patches.empty());
  EXPECT_TRUE(stitched.Loops.empty());
}
