// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/ContourNesting.h"

#include "Support/ContourStacks.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(ContourNesting, ParentIsTheSmallestContourAround)
{
  const ContourStack stack = ParseStack("z=0: 0,0 9,0 9,9 0,9;" // outer
                                        "z=0: 1,1 1,8 8,8 8,1;" // hole
                                        "z=0: 2,2 4,2 4,4 2,4;" // two islands in it
                                        "z=0: 5,5 7,5 7,7 5,7;"
                                        "z=0: 10,0 11,0 11,1;"   // beside
                                        "z=1: 3,3 3.5,3 3.5,4"); // on another slice
  EXPECT_EQ(FindParents(stack), (std::vector<Index>{ -1, 0, 1, 1, -1, -1 }));
}

//----------------------------------------------------------------------------
TEST(ContourNesting, ContoursThatTouchAreNested)
{
  // The hole's corners lie on the outer boundary, but one; the third contour touches from outside.
  const ContourStack stack = ParseStack("z=0: 0,0 4,0 4,4 0,4;"
                                        "z=0: 0,2 2,4 3,2 2,0;"
                                        "z=0: 4,0 8,0 8,4 4,4");
  EXPECT_EQ(FindParents(stack), (std::vector<Index>{ -1, 0, -1 }));
}

//----------------------------------------------------------------------------
TEST(ContourNesting, NudgedPointsAreNeverOnAContour)
{
  const ContourStack square = ParseStack("z=0: 0,0 2,0 2,2 0,2");
  const auto within = [&](const Point2& p, Nudge nudge, bool expectTied)
  {
    bool tied = false;
    const bool result = IsWithin(square, 0, p, nudge, tied);
    EXPECT_EQ(tied, expectTied);
    return result;
  };
  EXPECT_TRUE(within({ 1, 1 }, { 1, 1 }, false));
  EXPECT_FALSE(within({ 3, 1 }, { 1, 1 }, false));
  // A corner, to all four sides.
  EXPECT_TRUE(within({ 0, 0 }, { 1, 1 }, true));
  EXPECT_FALSE(within({ 0, 0 }, { -1, 1 }, true));
  EXPECT_FALSE(within({ 0, 0 }, { 1, -1 }, true));
  EXPECT_FALSE(within({ 0, 0 }, { -1, -1 }, true));
  // The middle of the right side and of the upper side.
  EXPECT_TRUE(within({ 2, 1 }, { -1, 1 }, true));
  EXPECT_FALSE(within({ 2, 1 }, { 1, 1 }, true));
  EXPECT_TRUE(within({ 1, 2 }, { 1, -1 }, true));
  EXPECT_FALSE(within({ 1, 2 }, { -1, 1 }, true));
}

//----------------------------------------------------------------------------
// Places are multiples of 4: a nudge of (1e-3, 1e-6) is as good as an infinitely small one.
TEST(ContourNesting, NudgedSideIsThatOfAPointMovedALittle)
{
  Random random(3);
  const auto place = [&]() -> Point2 { return { 4.0 * random.Below(5), 4.0 * random.Below(5) }; };
  for (int i = 0; i < 5000; ++i)
  {
    const Point2 p = place(), q = place(), r = place();
    const Nudge nudge{ random.Chance(0.5) ? 1 : -1, random.Chance(0.5) ? 1 : -1 };
    bool tied = false;
    if (p != q)
    {
      EXPECT_EQ(NudgedSideOf(p, q, r, nudge, tied),
        SideOf(p, q, { r[0] + 1e-3 * nudge.U, r[1] + 1e-6 * nudge.V }));
      EXPECT_EQ(tied, SideOf(p, q, r) == 0);
    }
  }
}
