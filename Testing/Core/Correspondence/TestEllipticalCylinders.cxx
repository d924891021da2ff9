// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/EllipticalCylinders.h"

#include "Support/ContourStacks.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
ContourPairs Cylinders(const ContourStack& stack)
{
  return FindPairs(CorrespondenceCriterion::EllipticalCylinders, stack);
}
}

//----------------------------------------------------------------------------
// Two columns so inclined that nothing overlaps: the prediction finds the next contour.
TEST(EllipticalCylinders, FollowInclinedAxes)
{
  ContourStack stack = EmptyStack(4);
  for (Index slice = 0; slice < 4; ++slice)
  {
    AddEllipse(stack, slice, { 3.0 * slice, 0.0 }, 1.0, 0.8);
    AddEllipse(stack, slice, { 3.0 * slice, 5.0 }, 1.0, 0.8);
  }
  EXPECT_EQ(
    Cylinders(stack), (ContourPairs{ { 0, 2 }, { 1, 3 }, { 2, 4 }, { 3, 5 }, { 4, 6 }, { 5, 7 } }));
}

//----------------------------------------------------------------------------
// Columns 2.5 apart that move by 1.4 per slice: what lies straight above is the neighbour's (1.1
// away), and the row of contours also lies on the lines of other axes, without any error.
TEST(EllipticalCylinders, PreferTheSteepestOfExactAxes)
{
  ContourStack stack = EmptyStack(4);
  for (Index slice = 0; slice < 4; ++slice)
  {
    for (int column = 0; column < 2; ++column)
    {
      AddEllipse(stack, slice, { 1.4 * slice, 2.5 * column }, 0.6, 0.6);
    }
  }
  EXPECT_EQ(
    Cylinders(stack), (ContourPairs{ { 0, 2 }, { 1, 3 }, { 2, 4 }, { 3, 5 }, { 4, 6 }, { 5, 7 } }));
}

//----------------------------------------------------------------------------
TEST(EllipticalCylinders, SlicesMayLieUnevenly)
{
  ContourStack stack = EmptyStack(4);
  stack.Coordinate = { 0.0, 1.0, 3.0, 3.5 };
  for (Index slice = 0; slice < 4; ++slice)
  {
    AddEllipse(stack, slice, { 4.0 * stack.Coordinate[slice], 0.0 }, 1.0, 1.0);
  }
  EXPECT_EQ(Cylinders(stack), (ContourPairs{ { 0, 1 }, { 1, 2 }, { 2, 3 } }));
}

//----------------------------------------------------------------------------
TEST(EllipticalCylinders, ComplexContoursAreLeftOut)
{
  const std::string letterC = " 0,0 3,0 3,3 0,3 0,2 2,2 2,1 0,1;";
  EXPECT_EQ(
    Cylinders(ParseStack("z=0:" + letterC + "z=1:" + letterC + "z=2:" + letterC)), ContourPairs());
}

//----------------------------------------------------------------------------
// Two columns of three slices on a plate, and a plate on top of them: a handle.
TEST(EllipticalCylinders, JoinAtBranchings)
{
  ContourStack stack = EmptyStack(5);
  AddEllipse(stack, 0, { 0.0, 0.0 }, 0.5, 3.0);
  for (Index slice = 1; slice < 4; ++slice)
  {
    AddEllipse(stack, slice, { 1.5 * slice, -2.0 }, 0.4, 0.4);
    AddEllipse(stack, slice, { 1.5 * slice, 2.0 }, 0.4, 0.4);
  }
  AddEllipse(stack, 4, { 6.0, 0.0 }, 0.5, 3.0);
  EXPECT_EQ(Cylinders(stack),
    (ContourPairs{
      { 0, 1 }, { 0, 2 }, { 1, 3 }, { 2, 4 }, { 3, 5 }, { 4, 6 }, { 5, 7 }, { 6, 7 } }));
}

//----------------------------------------------------------------------------
// On two slices there is nothing to predict from: similar ones that are closest to each other.
TEST(EllipticalCylinders, TwoSlices)
{
  ContourStack stack = EmptyStack(2);
  AddEllipse(stack, 0, { 0.0, 0.0 }, 1.0, 1.0);
  AddEllipse(stack, 0, { 5.0, 0.0 }, 1.0, 1.0);
  AddEllipse(stack, 1, { 0.6, 0.0 }, 1.1, 0.9);
  AddEllipse(stack, 1, { 9.0, 0.0 }, 1.0, 1.0);
  EXPECT_EQ(Cylinders(stack), (ContourPairs{ { 0, 2 } }));
}

//----------------------------------------------------------------------------
TEST(EllipticalCylinders, HolesGoWithHoles)
{
  const std::string outer = " 0,0 4,-2 8,0 8,4 4,6 0,4;";
  const std::string hole = " 3,1 2,2 3,3 5,3 6,2 5,1;";
  std::string text;
  for (const char* plane : { "z=0:", "z=1:", "z=2:" })
  {
    text += plane + outer + plane + hole;
  }
  EXPECT_EQ(Cylinders(ParseStack(text)), (ContourPairs{ { 0, 2 }, { 1, 3 }, { 2, 4 }, { 3, 5 } }));
}
