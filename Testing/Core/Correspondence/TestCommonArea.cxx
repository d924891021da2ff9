// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/CommonArea.h"

#include "Support/ContourStacks.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// The first contour against all others together.
bool Common(const std::string& first, const std::string& others)
{
  const ContourStack stack = ParseStack("z=0: " + first + "; " + others);
  std::vector<Index> other;
  for (Index i = 1; i < stack.Count(); ++i)
  {
    other.push_back(i);
  }
  const bool common = HaveCommonArea(stack, { 0 }, other);
  EXPECT_EQ(HaveCommonArea(stack, other, { 0 }), common);
  return common;
}

const char* const Square = "0,0 4,0 4,4 0,4";
}

//----------------------------------------------------------------------------
TEST(CommonArea, CrossingAndContainment)
{
  EXPECT_TRUE(Common(Square, "z=1: 1,1 9,1 9,9"));
  EXPECT_TRUE(Common(Square, "z=1: 1,1 2,1 2,2"));
  EXPECT_FALSE(Common(Square, "z=1: 5,1 9,1 9,9"));
}

//----------------------------------------------------------------------------
TEST(CommonArea, CoincidentBoundaries)
{
  EXPECT_TRUE(Common(Square, "z=1: 0,0 4,0 4,4 0,4"));
  EXPECT_TRUE(Common(Square, "z=1: 1,0 3,0 3,4 1,4"));       // a bar in it
  EXPECT_TRUE(Common(Square, "z=1: 4,0 4,4 0,0"));           // a half of it
  EXPECT_TRUE(Common(Square, "z=1: 0,0 4,0 4,4 -4,4 -4,0")); // more than it
  EXPECT_FALSE(Common(Square, "z=1: 4,1 6,1 6,3 4,3"));      // a step beside it
  EXPECT_FALSE(Common(Square, "z=1: 4,0 4,-1 5,-1 5,5 -1,5 -1,-1 0,-1 0,4 4,4")); // a clamp
}

//----------------------------------------------------------------------------
// The corner at (2, 0) lies in a side; the segments pass vertices without crossing edges inside.
TEST(CommonArea, VerticesOnEdges)
{
  EXPECT_FALSE(Common(Square, "z=1: 2,0 1,-1 3,-1"));
  EXPECT_TRUE(Common(Square, "z=1: 2,0 4,2 2,4 0,2"));
  EXPECT_TRUE(Common(Square, "z=1: -4,4 0,0 4,-4 8,0 4,4 0,8")); // through two corners
  EXPECT_FALSE(Common("0,0 2,0 1,1", "z=1: 1,1 2,2 0,2"));       // an hourglass
}

//----------------------------------------------------------------------------
TEST(CommonArea, PlugInAHole)
{
  const std::string ring = "z=1: -2,-2 6,-2 6,6 -2,6; z=1: 0,0 0,4 4,4 4,0";
  EXPECT_FALSE(Common(Square, ring));
  EXPECT_TRUE(Common("0,0 4,0 4,4.000000000000001 0,4", ring));
}

//----------------------------------------------------------------------------
// One third is no number: a point on the line is not to be told from those beside it by rounding.
TEST(CommonArea, SlantedBoundariesThatNearlyTouch)
{
  EXPECT_FALSE(Common("0,0 3,1 0,1", "z=1: 0,0 6,-3 6,2 3,1"));
  EXPECT_FALSE(Common("0,0 3,1 0,1", "z=1: 0,0 6,-3 6,1.9999999999999998 3,1"));
  EXPECT_TRUE(Common("0,0 3,1 0,1", "z=1: 0,0 6,-3 6,2.0000000000000004"));
  EXPECT_FALSE(Common("0,0 3,1 0,1", "z=1: 0,0 6,-3 6,2"));
}
