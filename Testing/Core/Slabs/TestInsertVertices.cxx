// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/InsertVertices.h"

#include "Support/LoopStack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
std::vector<SlabGroup> Overlaid(const LoopStack& stack)
{
  auto groups = FormSlabGroups(stack.Geometry(), CorrespondenceCriterion::Overlap, {});
  for (SlabGroup& group : groups)
  {
    OverlayGroup(false, group);
  }
  return groups;
}
}

//----------------------------------------------------------------------------
TEST(InsertVertices, PutsEachCrossingOnBothLoopsAndKeepsTheOldVertices)
{
  const LoopStack stack(TwoSquares);
  auto groups = Overlaid(stack);
  const StitchedLoops stitched = InsertVertices(stack.Geometry(), 2, Execution(), groups);
  const NodeGraph& graph = stack.Result.Graph;
  ASSERT_EQ(stitched.Loops.size(), 2u);
  for (Index loop = 0; loop < 2; ++loop)
  {
    ASSERT_EQ(stitched.VertexAt[loop].size(), 4u);
    for (Index i = 0; i < 4; ++i)
    {
      EXPECT_EQ(stitched.Loops[loop].Points[stitched.VertexAt[loop][i]],
        graph.PointAt(graph.FirstPoint(graph.Arcs + loop) + i));
    }
    // The sides cross at (1, 2) and (2, 1), but for the small shift by which OverlaySlab makes sure
    // that no two sides coincide.
    for (const Point2& crossing : { Point2{ 1, 2 }, Point2{ 2, 1 } })
    {
      const auto& points = stitched.Loops[loop].Points;
      EXPECT_EQ(std::count_if(points.begin(), points.end(),
                  [&](const Point3& p)
                  { return std::hypot(p[0] - crossing[0], p[1] - crossing[1]) < 1e-6; }),
        1);
    }
  }
}

//----------------------------------------------------------------------------
TEST(InsertVertices, SaysWhereTheInsertionsOfEachGroupAre)
{
  const LoopStack stack(TwoSquares);
  auto groups = Overlaid(stack);
  const StitchedLoops stitched = InsertVertices(stack.Geometry(), 2, Execution(), groups);
  int inserted = 0;
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    const auto& insertions = groups[g].Overlay.Insertions;
    ASSERT_EQ(stitched.InsertionAt[g].size(), insertions.size());
    for (std::size_t i = 0; i < insertions.size(); ++i)
    {
      const Index loop = groups[g].Loops[insertions[i].Loop];
      const Index place = stitched.InsertionAt[g][i];
      const auto& old = stitched.VertexAt[loop];
      ASSERT_LT(place, stitched.Count(loop));
      EXPECT_EQ(std::count(old.begin(), old.end(), place), 0); // no old vertex lies there
      ++inserted;
    }
  }
  EXPECT_EQ(inserted, 4);
}

//----------------------------------------------------------------------------
TEST(InsertVertices, OfInvalidOverlaysInsertsNothing)
{
  const LoopStack stack(TwoSquares);
  auto groups = Overlaid(stack);
  for (SlabGroup& group : groups)
  {
    group.Overlay.Valid = false;
  }
  const StitchedLoops stitched = InsertVertices(stack.Geometry(), 2, Execution(), groups);
  EXPECT_EQ(stitched.Count(0), 4);
  EXPECT_EQ(stitched.Count(1), 4);
}
