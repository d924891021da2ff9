// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/RealizeSheets.h"

#include "Core/Slabs/LoopRoles.h"
#include "Core/Slabs/SlabPieces.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;

namespace
{
/// A square around a place; holes run clockwise.
SlabLoop Square(Point2 center, double half, bool upper, bool hole = false)
{
  const auto [u, v] = center;
  SlabLoop loop{ { { u - half, v - half }, { u + half, v - half }, { u + half, v + half },
                   { u - half, v + half } },
    upper };
  if (hole)
  {
    std::reverse(loop.Points.begin(), loop.Points.end());
  }
  return loop;
}

SlabGroup Overlaid(std::vector<SlabLoop> loops)
{
  SlabGroup group{ 1, {}, std::move(loops), { 0.0, 0.0 }, {} };
  for (Index i = 0; i < static_cast<Index>(group.Outlines.size()); ++i)
  {
    group.Loops.push_back(10 + i);
  }
  group.Overlay = OverlaySlab(group.Outlines, group.Shift);
  EXPECT_TRUE(group.Overlay.Valid);
  return group;
}

/// A thin square ring below, and one that has moved above.
SlabGroup MovedRing(Point2 by)
{
  return Overlaid({ Square({ 0, 0 }, 5.0, false), Square({ 0, 0 }, 4.5, false, true),
    Square(by, 5.0, true), Square(by, 4.5, true, true) });
}
}

//----------------------------------------------------------------------------
TEST(SlabPieces, WhatAnOverlayJoins)
{
  const SlabGroup group = MovedRing({ 2.0, 0.0 });
  const std::vector<SlabPiece> pieces = DescribePieces(group);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].Loops, (std::vector<Index>{ 0, 1, 2, 3 }));
  EXPECT_TRUE(pieces[0].Across);
  EXPECT_TRUE(pieces[0].Mixed);
  // Common are the two bars along the motion, 8 long and 0.5 wide, of 19 in all.
  EXPECT_NEAR(CommonShare(group, { 0, 1, 2, 3 }), 8.0 / 19.0, 0.01);
}

//----------------------------------------------------------------------------
TEST(SlabPieces, HandlesOfAPlateThatBends)
{
  // A bar below, and above a U whose arms cross it: two places in common, with a hole between.
  const SlabGroup group = Overlaid({ { { { -5, 0 }, { 5, 0 }, { 5, 1 }, { -5, 1 } }, false },
    { { { -4, -2 }, { 4, -2 }, { 4, 3 }, { 3, 3 }, { 3, -1 }, { -3, -1 }, { -3, 3 }, { -4, 3 } },
      true } });
  const std::vector<SlabPiece> pieces = DescribePieces(group);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].Handles, 1);
}

//----------------------------------------------------------------------------
TEST(LoopRoles, NestingAndPairs)
{
  const std::vector<SlabLoop> loops{ Square({ 0, 0 }, 5, false), Square({ -2, 0 }, 1, false, true),
    Square({ 2, 0 }, 1, false, true), Square({ 9, 0 }, 5, true), Square({ 11, 0 }, 1, true, true),
    Square({ 7, 0 }, 1, true, true), Square({ 2, 0 }, 0.5, true) };
  const LoopRoles roles(loops);
  EXPECT_FALSE(roles.IsHole(0));
  EXPECT_TRUE(roles.IsHole(1));
  EXPECT_EQ(roles.ParentOf(2), 0);
  EXPECT_EQ(roles.ParentOf(4), 3);
  EXPECT_EQ(roles.FindAround(6), 2);
  const LoopRoles::Members all{ 0, 1, 2, 3, 4, 5, 6 };
  EXPECT_EQ(roles.ChildrenOf(-1, all, true), (LoopRoles::Members{ 3, 6 }));
  EXPECT_EQ(roles.ChildrenOf(0, all, false), (LoopRoles::Members{ 1, 2 }));
  EXPECT_EQ(roles.DepthOf(5, all), 1);
  EXPECT_EQ(roles.FindNearest(2, all), 5);
  // The holes move with the contour around them.
  std::vector<LoopRoles::Members> pairs;
  EXPECT_TRUE(roles.PairOff({ 1, 2 }, { 4, 5 }, { 9, 0 }, pairs));
  EXPECT_EQ(pairs, (std::vector<LoopRoles::Members>{ { 1, 5 }, { 2, 4 } }));
  EXPECT_FALSE(roles.PairOff({ 1, 2 }, { 4 }, { 9, 0 }, pairs));
}

//----------------------------------------------------------------------------
TEST(SlabSheets, NothingIsPlannedWhereOverlayWillDo)
{
  EXPECT_TRUE(PlanSheets(MovedRing({ 0.1, 0.07 }), 1.0).empty());
}

//----------------------------------------------------------------------------
TEST(SlabSheets, AWallThatMovesByMoreThanItsThicknessStaysAWall)
{
  SlabGroup group = MovedRing({ 2.0, 0.7 });
  const std::vector<SheetPlan> plans = PlanSheets(group, 1.0);
  ASSERT_EQ(plans.size(), 1u);
  EXPECT_TRUE(plans[0].InPairs);
  EXPECT_EQ(plans[0].Sheets, (std::vector<std::vector<Index>>{ { 0, 2 }, { 1, 3 } }));
  EXPECT_EQ(plans[0].Depth, (std::vector<Index>{ 0, 1 }));
  // Two sheets, or both together in a slab that is sheared.
  std::vector<std::vector<Index>> pairs;
  for (const SlabGroup& sheets : RealizeSheets(std::move(group), plans, 1.0))
  {
    for (const SlabPiece& piece : DescribePieces(sheets))
    {
      EXPECT_EQ(piece.Handles, 0);
      pairs.emplace_back();
      for (const Index member : piece.Loops)
      {
        pairs.back().push_back(sheets.Loops[member]);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(pairs, (std::vector<std::vector<Index>>{ { 10, 12 }, { 11, 13 } }));
}

//----------------------------------------------------------------------------
TEST(SlabSheets, ARingThatClosesToADisc)
{
  SlabGroup group = Overlaid({ Square({ 0, 0 }, 5.0, false), Square({ 0, 0 }, 4.5, false, true),
    Square({ 0, 0 }, 3.0, true) });
  const std::vector<SheetPlan> plans = PlanSheets(group, 1.0);
  ASSERT_EQ(plans.size(), 1u);
  EXPECT_FALSE(plans[0].InPairs);
  const std::vector<SlabGroup> groups = RealizeSheets(std::move(group), plans, 1.0);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].Loops, (std::vector<Index>{ 10, 12 }));
  EXPECT_EQ(groups[1].Loops, (std::vector<Index>{ 11 }));
}

//----------------------------------------------------------------------------
TEST(SlabSheets, AHoleThatOpensToTheOutsideStaysOpen)
{
  // A thick ring, and above it the same with a gap.
  const SlabGroup group =
    Overlaid({ Square({ 0, 0 }, 5.0, false), Square({ 0, 0 }, 2.0, false, true),
      { { { -5, -5 }, { 5, -5 }, { 5, -1 }, { 2, -1 }, { 2, -2 }, { -2, -2 }, { -2, 2 }, { 2, 2 },
          { 2, 1 }, { 5, 1 }, { 5, 5 }, { -5, 5 } },
        true } });
  for (const SheetPlan& plan : PlanSheets(group, 1.0))
  {
    EXPECT_FALSE(plan.MayPart);
  }
}

//----------------------------------------------------------------------------
TEST(SlabSheets, LidsThatAreCloseTogetherBecomeATube)
{
  SlabGroup near = Overlaid({ Square({ 0, 0 }, 1.0, false), Square({ 3, 0 }, 1.0, true) });
  const std::vector<SheetPlan> plans = PlanSheets(near, 1.0);
  ASSERT_EQ(plans.size(), 1u);
  const std::vector<SlabGroup> groups = RealizeSheets(std::move(near), plans, 1.0);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(CountPieces(groups[0].Overlay), 1);
  EXPECT_EQ(groups[0].Shift, (Point2{ 3.0, 0.0 }));
  // Farther than they are wide, more aslant than four to one, or of other size.
  const auto plan = [](Point2 to, double half, double width) {
    return PlanSheets(Overlaid({ Square({ 0, 0 }, 1.0, false), Square(to, half, true) }), width);
  };
  EXPECT_TRUE(plan({ 5, 0 }, 1.0, 9.0).empty());
  EXPECT_TRUE(plan({ 3, 0 }, 1.0, 0.5).empty());
  EXPECT_TRUE(plan({ 3.5, 0 }, 2.1, 1.0).empty());
}

//----------------------------------------------------------------------------
TEST(OverlayHoles, IsTheOverlayOfTheReversedLoopsTurnedInsideOut)
{
  const std::vector<SlabLoop> holes{ Square({ 0, 0 }, 1.0, false, true),
    Square({ 0.5, 0.25 }, 1.0, true, true) };
  const SlabOverlay overlay = OverlayHoles(holes, { 0.0, 0.0 });
  ASSERT_TRUE(overlay.Valid);
  ASSERT_EQ(overlay.Insertions.size(), 4u);
  // The vertices inserted into both loops at one crossing are at one place.
  std::vector<Point2> places;
  for (std::size_t i = 0; i < overlay.Insertions.size(); ++i)
  {
    const SlabOverlay::Insertion& at = overlay.Insertions[i];
    const std::vector<Point2>& points = holes[at.Loop].Points;
    const Point2 p = points[at.After], q = points[(at.After + 1) % points.size()];
    places.push_back({ p[0] + at.Share * (q[0] - p[0]), p[1] + at.Share * (q[1] - p[1]) });
    EXPECT_EQ(at.Loop, i < 2 ? 0 : 1);
  }
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < 4; i += 2)
  {
    EXPECT_NEAR(places[i][0], places[i + 1][0], 1e-6);
    EXPECT_NEAR(places[i][1], places[i + 1][1], 1e-6);
  }
}
