// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/SlabPatch.h"

#include "Core/Cells/CheckPatchMeshes.h"
#include "Support/LoopStack.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(SlabPatch, CoversItsBordersWithPointsInsideItsSlab)
{
  LoopStack stack(TwoSquares);
  auto groups = FormSlabGroups(stack.Geometry(), CorrespondenceCriterion::Overlap, {});
  for (SlabGroup& group : groups)
  {
    OverlayGroup(false, group);
  }
  const StitchedLoops stitched = InsertVertices(stack.Geometry(), 2, Execution(), groups);
  std::vector<PatchMesh> patches;
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    for (Index piece = 0; piece < CountPieces(groups[g].Overlay); ++piece)
    {
      patches.push_back(BuildSlabPatch({ stack.Geometry(), 2, groups, stitched }, g, piece));
      EXPECT_GE(patches.back().Points.size(), patches.back().Cycles.size());
      for (const Point3& p : patches.back().Points)
      {
        EXPECT_TRUE(stack.Result.Grid.IsInside(2, groups[g].Slab, p[2]));
      }
    }
  }
  EXPECT_EQ(patches.size(), 3u);
  SetLoops(stitched.Loops, stack.Result.Graph);
  for (const PatchMesh& patch : patches)
  {
    EXPECT_EQ(CheckPatchCoversBorders(stack.Geometry(), patch.Cycles, patch.Triangles), "");
  }
}
