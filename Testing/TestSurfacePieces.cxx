// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/SurfacePieces.h"

#include "Support/ContourStacks.h"
#include "Support/SliceSolid.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
struct Sliced
{
  Solid Shape;
  ContourStack Stack;
};

/// z-slices at the given heights.
Sliced Slice(const Solid& solid, const std::vector<double>& heights)
{
  PlaneSets planes;
  planes[2] = heights;
  planes[0] = planes[1] = { 0.0 };
  return { solid, StackOf(SliceSolid(solid, planes, 60, InPlaneGrid::Aligned)[2], heights) };
}

Solid UprightRing()
{
  Solid solid;
  solid.Tubes = { Torus({ 0, 0, 0 }, { 1, 0, 0 }, 0.6, 0.2) };
  solid.Low = { -1, -1, -1 };
  solid.High = { 1, 1, 1 };
  return solid;
}
}

//----------------------------------------------------------------------------
// A ring that stands: its top and its bottom lie beyond the slices and turn back there.
TEST(SurfacePieces, RingThatTurnsBackBeyondTheSlices)
{
  const Sliced ring = Slice(UprightRing(), { -0.2, 0.2 });
  ASSERT_EQ(ring.Stack.Count(), 4);
  const auto pieces = TruePieces(ring.Shape, ring.Stack, 10, 0.04);
  ASSERT_TRUE(pieces.has_value());
  // Above and below each: the bottom turn, two arms, the top turn.
  EXPECT_EQ(*pieces, (SurfacePieces{ 0, 1, 2, 1, 4, 0, 4, 2 }));
  EXPECT_EQ(TopologyOf(*pieces).Components, 1);
  EXPECT_EQ(TopologyOf(*pieces).Genus, 1);
  EXPECT_EQ(CountTurns(*pieces, ring.Stack), 2);

  const std::vector<Correspondence> right{ { 0, 2 }, { 1, 3 }, { 0, 1, 0.0, Passage::Below },
    { 2, 3, 0.0, Passage::Above } };
  EXPECT_EQ(PiecesOf(right, 4), *pieces);
  EXPECT_EQ(CountMistakes(right, *pieces).Wrong, 0);
  EXPECT_EQ(CountMistakes(right, *pieces).Missing, 0);

  const std::vector<Correspondence> crossed{ { 0, 3 }, { 1, 3 } };
  EXPECT_EQ(CountMistakes(crossed, *pieces).Wrong, 1);
  EXPECT_EQ(CountMistakes(crossed, *pieces).Missing, 3);
  EXPECT_EQ(TopologyOf(PiecesOf(crossed, 4)).Components, 2);
}

//----------------------------------------------------------------------------
TEST(SurfacePieces, RingWithSlicesThroughTopAndBottom)
{
  const Sliced ring = Slice(UprightRing(), { -0.7, 0.05, 0.7 });
  ASSERT_EQ(ring.Stack.Count(), 4);
  const auto pieces = TruePieces(ring.Shape, ring.Stack, 20, 0.04);
  ASSERT_TRUE(pieces.has_value());
  EXPECT_EQ(*pieces, PiecesOf({ { 0, 1 }, { 0, 2 }, { 1, 3 }, { 2, 3 } }, 4));
  EXPECT_EQ(TopologyOf(*pieces).Genus, 1);
  EXPECT_EQ(CountTurns(*pieces, ring.Stack), 0);
}

//----------------------------------------------------------------------------
// Pairs that connect the same piece several times make no handle.
TEST(SurfacePieces, PieceOfFourContoursIsNoHandle)
{
  const SurfacePieces pieces = PiecesOf({ { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 } }, 4);
  EXPECT_EQ(TopologyOf(pieces).Components, 1);
  EXPECT_EQ(TopologyOf(pieces).Genus, 0);
}

//----------------------------------------------------------------------------
TEST(SurfacePieces, AlsoOfSolidsWithoutHandles)
{
  const Sliced balls = Slice(TwoDistantBalls(), { -0.7, -0.5, 0.1, 0.5, 0.7 });
  const auto pieces = TruePieces(balls.Shape, balls.Stack, 10, 0.05);
  ASSERT_TRUE(pieces.has_value());
  EXPECT_EQ(*pieces, PiecesOf({ { 0, 1 }, { 2, 3 } }, 4));
  EXPECT_EQ(TopologyOf(*pieces).Components, 2);
  EXPECT_EQ(TopologyOf(*pieces).Genus, 0);
}

//----------------------------------------------------------------------------
TEST(SurfacePieces, CoarseGridsAreRefused)
{
  const Sliced ring = Slice(UprightRing(), { -0.2, 0.2 });
  EXPECT_FALSE(TruePieces(ring.Shape, ring.Stack, 10, 0.9).has_value());
}
