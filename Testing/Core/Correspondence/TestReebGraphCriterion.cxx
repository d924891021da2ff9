// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/ReebGraphCriterion.h"

#include "Support/ContourStacks.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
std::vector<Correspondence> Connect(const ContourStack& stack, Index components, Index genus)
{
  return FindCorrespondences(
    CorrespondenceCriterion::ReebGraph, stack, PriorKnowledge{ components, genus });
}

/// One contour, two on two slices, one: where they are the ring's, all in a plane.
ContourStack Ring()
{
  ContourStack stack = EmptyStack(4);
  AddEllipse(stack, 0, { 0.0, 0.0 }, 0.3, 1.5);
  for (Index slice = 1; slice < 3; ++slice)
  {
    AddEllipse(stack, slice, { 0.0, -1.4 }, 0.3, 0.3);
    AddEllipse(stack, slice, { 0.0, 1.4 }, 0.3, 0.3);
  }
  AddEllipse(stack, 3, { 0.0, 0.2 }, 0.3, 1.5);
  return stack;
}
}

//----------------------------------------------------------------------------
// As many contours above as below: one to one. The closest pair first, so the others have to do
// with what is left.
TEST(ReebGraphCriterion, EqualNumbersAreConnectedOneToOne)
{
  ContourStack stack = EmptyStack(2);
  AddEllipse(stack, 0, { 0.0, 0.0 }, 0.5, 0.5);
  AddEllipse(stack, 0, { 4.0, 0.0 }, 0.5, 0.5);
  AddEllipse(stack, 1, { 3.0, 0.0 }, 0.5, 0.5);
  AddEllipse(stack, 1, { 9.0, 0.0 }, 0.5, 0.5);
  EXPECT_EQ(PairsOf(Connect(stack, 0, -1)), (ContourPairs{ { 0, 3 }, { 1, 2 } }));
}

//----------------------------------------------------------------------------
// The mean distance of concentric circles is the difference of their radii.
TEST(ReebGraphCriterion, CostIsTheMeanDistance)
{
  ContourStack stack = EmptyStack(2);
  AddEllipse(stack, 0, { 0.0, 0.0 }, 2.0, 2.0);
  AddEllipse(stack, 1, { 0.0, 0.0 }, 3.5, 3.5);
  EXPECT_NEAR(Connect(stack, 0, -1)[0].Cost, 1.5, 0.02);
}

//----------------------------------------------------------------------------
TEST(ReebGraphCriterion, RingHasAHandleIfItIsKnown)
{
  EXPECT_EQ(PairsOf(Connect(Ring(), 1, 1)),
    (ContourPairs{ { 0, 1 }, { 0, 2 }, { 1, 3 }, { 2, 4 }, { 3, 5 }, { 4, 5 } }));
  EXPECT_EQ(PairsOf(Connect(Ring(), 0, -1)).size(), 6u);
}

//----------------------------------------------------------------------------
// The top is closest to the contours at y = 1.4 as it is moved there: the last link is refused.
TEST(ReebGraphCriterion, CyclesBeyondTheGenusAreRefused)
{
  EXPECT_EQ(PairsOf(Connect(Ring(), 1, 0)),
    (ContourPairs{ { 0, 1 }, { 0, 2 }, { 1, 3 }, { 2, 4 }, { 4, 5 } }));
}

//----------------------------------------------------------------------------
// One contour below three; two components are known, so the farthest stays apart.
TEST(ReebGraphCriterion, ComponentsAreKeptApart)
{
  ContourStack stack = EmptyStack(2);
  AddEllipse(stack, 0, { 0.0, 0.0 }, 1.0, 1.0);
  AddEllipse(stack, 1, { -1.0, 0.0 }, 0.5, 0.5);
  AddEllipse(stack, 1, { 1.0, 0.0 }, 0.5, 0.5);
  AddEllipse(stack, 1, { 9.0, 0.0 }, 0.5, 0.5);
  EXPECT_EQ(PairsOf(Connect(stack, 2, 0)), (ContourPairs{ { 0, 1 }, { 0, 2 } }));
  EXPECT_EQ(PairsOf(Connect(stack, 0, -1)), (ContourPairs{ { 0, 1 }, { 0, 2 }, { 0, 3 } }));
}

//----------------------------------------------------------------------------
// Two legs that lean together: an arch, if one component is known.
TEST(ReebGraphCriterion, ArchIsClosedWithinItsLastSlice)
{
  ContourStack stack = EmptyStack(3);
  for (Index slice = 0; slice < 3; ++slice)
  {
    AddEllipse(stack, slice, { -3.0 + slice, 0.0 }, 0.5, 0.5);
    AddEllipse(stack, slice, { 3.0 - slice, 0.0 }, 0.5, 0.5);
  }
  const auto arch = Connect(stack, 1, 0);
  EXPECT_EQ(PairsOf(arch), (ContourPairs{ { 0, 2 }, { 1, 3 }, { 2, 4 }, { 3, 5 } }));
  EXPECT_EQ(PairsOf(arch, Passage::Above), (ContourPairs{ { 4, 5 } }));
  EXPECT_EQ(PairsOf(arch, Passage::Below), ContourPairs());
  EXPECT_EQ(Connect(stack, 2, 0).size(), 4u); // two columns

  // A closed ring: a handle is known as well.
  const auto ring = Connect(stack, 1, 1);
  EXPECT_EQ(PairsOf(ring, Passage::Above), (ContourPairs{ { 4, 5 } }));
  EXPECT_EQ(PairsOf(ring, Passage::Below), (ContourPairs{ { 0, 1 } }));
}

//----------------------------------------------------------------------------
// A tube that lies in the slices: outer boundary and hole are connected above and below.
TEST(ReebGraphCriterion, LyingRingConnectsOuterBoundaryAndHole)
{
  const ContourStack stack = ParseStack("z=0: 0,0 9,0 9,9 0,9; z=0: 2,2 2,7 7,7 7,2;"
                                        "z=1: 0,0 9,0 9,9 0,9; z=1: 2,2 2,7 7,7 7,2");
  const auto pairs = Connect(stack, 1, 1);
  EXPECT_EQ(PairsOf(pairs), (ContourPairs{ { 0, 2 }, { 1, 3 } }));
  EXPECT_EQ(PairsOf(pairs, Passage::Above), (ContourPairs{ { 2, 3 } }));
  EXPECT_EQ(PairsOf(pairs, Passage::Below), (ContourPairs{ { 0, 1 } }));
}

//----------------------------------------------------------------------------
// Two islands in different holes cannot be connected beyond the slice: the ring is in between.
TEST(ReebGraphCriterion, OnlyContoursOfOneAreaAreConnectedWithinASlice)
{
  const ContourStack stack = ParseStack("z=0: 0,0 20,0 20,10 0,10;"
                                        "z=0: 1,1 1,9 9,9 9,1; z=0: 11,1 11,9 19,9 19,1;"
                                        "z=0: 4,4 6,4 6,6 4,6; z=0: 14,4 16,4 16,6 14,6");
  for (const Correspondence& pair : Connect(stack, 1, 9))
  {
    EXPECT_FALSE(pair.First == 3 && pair.Second == 4);
    EXPECT_FALSE(pair.First == 1 && pair.Second == 4);
  }
}
