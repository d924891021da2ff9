// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/ContourStack.h"

#include "Support/ContourStacks.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(ContourStack, FirstContoursOfSlicesThatMayBeEmpty)
{
  ContourStack stack = EmptyStack(4);
  AddEllipse(stack, 1, { 0, 0 }, 1, 1);
  AddEllipse(stack, 1, { 3, 0 }, 1, 1);
  AddEllipse(stack, 3, { 0, 0 }, 1, 1);
  EXPECT_EQ(FirstContourOfSlices(stack), (std::vector<Index>{ 0, 0, 2, 2, 3 }));
}

//----------------------------------------------------------------------------
TEST(ContourStack, AreasOfHolesAreNegative)
{
  EXPECT_EQ(SignedAreas(ParseStack("z=0: 0,0 9,0 9,9 0,9; z=0: 1,1 1,2 2,2 2,1")),
    (std::vector<double>{ 81, -1 }));
}
