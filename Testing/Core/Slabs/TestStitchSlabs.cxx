// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/StitchSlabs.h"

#include "Core/Cells/CheckPatchMeshes.h"
#include "Core/Graph/CheckGraph.h"
#include "Core/Slabs/PairLoops.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// The tables of slices of one family, whose contours are all loops of G.
struct Stack
{
  explicit Stack(const std::string& text)
  {
    Options options;
    options.Orient = Orientation::AsDrawn;
    Reconstruct(ParsePieces(text), options, Execution(),
      [this](Stage stage, const StageTables&, const Reconstruction& result)
      {
        if (stage == Stage::TraceCycles)
        {
          this->Result = result;
        }
      });
  }

  CycleGeometry Geometry() const { return GeometryOf(this->Result); }
  StitchedSlabs Stitch(CorrespondenceCriterion criterion) const
  {
    return StitchSlabs(this->Geometry(), criterion,
      PairLoops(this->Geometry(), criterion, PriorKnowledge()), Execution());
  }

  Reconstruction Result;
};

constexpr char TwoSquares[] = "z=0: 0,0 2,0 2,2 0,2; z=1: 1,1 3,1 3,3 1,3";
}

//----------------------------------------------------------------------------
TEST(StitchSlabs, SquaresThatOverlapBoundOnePatch)
{
  const Stack stack(TwoSquares);
  const StitchedSlabs stitched = stack.Stitch(CorrespondenceCriterion::ByEvidence);
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
  Stack stack(TwoSquares);
  const NodeGraph before = stack.Result.Graph;
  const StitchedSlabs stitched = stack.Stitch(CorrespondenceCriterion::ByEvidence);
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
  const Stack stack(std::string(TwoSquares) + "; x=9: 0,0 1,0 1,1");
  const StitchedSlabs stitched = stack.Stitch(CorrespondenceCriterion::ByEvidence);
  EXPECT_TRUE(stitched.Patches.empty());
  EXPECT_TRUE(stitched.Loops.empty());
}

//----------------------------------------------------------------------------
TEST(PairLoops, PairsByOverlapAcrossASlabOnly)
{
  const Stack stack("z=0: 0,0 2,0 2,2 0,2; z=1: 1,1 3,1 3,3 1,3; z=2: 0,0 2,0 2,2 0,2;"
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

//----------------------------------------------------------------------------
TEST(SlabGroup, TheCyclesOfALoopLieInTheCellsBelowAndAboveIt)
{
  const Stack stack(TwoSquares);
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
  const Stack stack("z=0: 0,0 1,0 1,1 0,1; z=0: 5,0 6,0 6,1 5,1; z=1: 0,0 1,0 1,1 0,1;"
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
  const Stack stack("z=0: 0,0 1,0 1,1 0,1; z=1: 5,2 6,2 6,3 5,3");
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
