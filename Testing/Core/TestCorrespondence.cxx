// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence.h"

#include "Support/ContourStacks.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr CorrespondenceCriterion All[] = { CorrespondenceCriterion::Overlap,
  CorrespondenceCriterion::EllipticalCylinders, CorrespondenceCriterion::SpanningTree,
  CorrespondenceCriterion::ReebGraph };
}

//----------------------------------------------------------------------------
TEST(Correspondence, NothingComesOfNothing)
{
  for (const CorrespondenceCriterion criterion : All)
  {
    EXPECT_TRUE(FindCorrespondences(criterion, ContourStack(), { 1, 1 }).empty());
    EXPECT_TRUE(FindCorrespondences(criterion, EmptyStack(3), { 1, 1 }).empty());
    EXPECT_TRUE(FindCorrespondences(criterion, ParseStack("z=0: 0,0 1,0 0,1"), { 1, 1 }).empty());
  }
}

//----------------------------------------------------------------------------
// Where all methods agree: an upright column. Beyond an empty slice another one begins.
TEST(Correspondence, UprightColumnAndEmptySlice)
{
  ContourStack stack = EmptyStack(6);
  for (const Index slice : { 0, 1, 2, 4, 5 })
  {
    AddEllipse(stack, slice, { 0.1 * slice, 0.0 }, 1.0, 0.9);
  }
  for (const CorrespondenceCriterion criterion : All)
  {
    EXPECT_EQ(FindPairs(criterion, stack, { 2, 0 }), (ContourPairs{ { 0, 1 }, { 1, 2 }, { 3, 4 } }))
      << "criterion " << static_cast<int>(criterion);
  }
}

//----------------------------------------------------------------------------
TEST(Correspondence, PairsAscendAndOccurOnce)
{
  ContourStack stack = EmptyStack(5);
  for (Index slice = 0; slice < 5; ++slice)
  {
    for (Index i = 0; i < 1 + slice % 3; ++i)
    {
      AddEllipse(stack, slice, { 0.7 * slice + 2.5 * i, 0.3 * i }, 1.0, 0.8);
    }
  }
  for (const CorrespondenceCriterion criterion : All)
  {
    const auto pairs = FindCorrespondences(criterion, stack, { 1, 3 });
    EXPECT_FALSE(pairs.empty());
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      EXPECT_TRUE(i == 0 || pairs[i - 1] < pairs[i]);
      EXPECT_LT(pairs[i].First, pairs[i].Second);
      EXPECT_EQ(stack.Slice[pairs[i].Second] - stack.Slice[pairs[i].First],
        pairs[i].Where == Passage::Across ? 1 : 0);
    }
  }
}
