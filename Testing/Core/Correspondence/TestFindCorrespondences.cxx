// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/FindCorrespondences.h"

#include "Support/ContourStacks.h"
#include "Support/Random.h"
#include "Support/SurfacePieces.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr CorrespondenceCriterion All[] = { CorrespondenceCriterion::Overlap,
  CorrespondenceCriterion::EllipticalCylinders, CorrespondenceCriterion::SpanningTree,
  CorrespondenceCriterion::ReebGraph };

/// Up to five ellipses on each of six slices, in columns of their own; some have a hole.
ContourStack RandomStack(Random& random)
{
  ContourStack stack = EmptyStack(6);
  for (Index slice = 0; slice < 6; ++slice)
  {
    for (int column = 0; column < 5; ++column)
    {
      if (random.Chance(0.4))
      {
        continue;
      }
      const Point2 center{ 2.5 * column + random.Uniform(-0.2, 0.2), random.Uniform(-2, 2) };
      const double a = random.Uniform(0.3, 1), b = random.Uniform(0.3, 1);
      AddEllipse(stack, slice, center, a, b);
      if (random.Chance(0.3))
      {
        AddEllipse(stack, slice, center, -0.5 * a, 0.5 * b); // clockwise
      }
    }
  }
  return stack;
}

/// The slices from the last one to the first; contours of a slice keep their order.
ContourStack UpsideDown(const ContourStack& stack, std::vector<Index>& numbers)
{
  ContourStack result = EmptyStack(stack.SliceCount());
  numbers.resize(stack.Slice.size());
  const std::vector<Index> first = FirstContourOfSlices(stack);
  for (Index slice = stack.SliceCount() - 1; slice >= 0; --slice)
  {
    for (Index i = first[slice]; i < first[slice + 1]; ++i)
    {
      std::vector<Point2> vertices;
      for (Index k = stack.Offsets[i]; k < stack.Offsets[i + 1]; ++k)
      {
        vertices.push_back(stack.At(k));
      }
      numbers[i] = AddContour(result, stack.SliceCount() - 1 - slice, vertices);
    }
  }
  return result;
}
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

//----------------------------------------------------------------------------
TEST(Correspondence, DoesNotDependOnUnits)
{
  Random random(21);
  for (int round = 0; round < 50; ++round)
  {
    const ContourStack stack = RandomStack(random);
    ContourStack scaled = stack;
    for (std::vector<double>* values : { &scaled.U, &scaled.V, &scaled.Coordinate })
    {
      std::for_each(values->begin(), values->end(), [](double& x) { x *= 0x1p-20; });
    }
    for (const CorrespondenceCriterion criterion : All)
    {
      EXPECT_EQ(FindPairs(criterion, stack, { 2, 1 }), FindPairs(criterion, scaled, { 2, 1 }));
    }
  }
}

//----------------------------------------------------------------------------
// Cylinders grow from seeds in the order of the slices; all others know no up and down.
TEST(Correspondence, UpsideDown)
{
  Random random(22);
  for (int round = 0; round < 50; ++round)
  {
    const ContourStack stack = RandomStack(random);
    std::vector<Index> numbers;
    const ContourStack reversed = UpsideDown(stack, numbers);
    for (const CorrespondenceCriterion criterion : { CorrespondenceCriterion::Overlap,
           CorrespondenceCriterion::SpanningTree, CorrespondenceCriterion::ReebGraph })
    {
      ContourPairs expected = FindPairs(criterion, stack, { 2, 1 });
      for (auto& pair : expected)
      {
        pair = { numbers[pair.second], numbers[pair.first] };
      }
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(FindPairs(criterion, reversed, { 2, 1 }), expected) << "round " << round;
    }
  }
}

//----------------------------------------------------------------------------
TEST(Correspondence, HandlesAreNoMoreThanTheMethodAllows)
{
  Random random(23);
  for (int round = 0; round < 100; ++round)
  {
    const ContourStack stack = RandomStack(random);
    const PriorKnowledge known{ static_cast<Index>(random.Below(4)),
      static_cast<Index>(random.Below(4)) };
    const auto genus = [&](CorrespondenceCriterion criterion)
    {
      const auto pairs = FindCorrespondences(criterion, stack, known);
      return TopologyOf(PiecesOf(pairs, stack.Count())).Genus;
    };
    EXPECT_EQ(genus(CorrespondenceCriterion::SpanningTree), 0);
    EXPECT_LE(genus(CorrespondenceCriterion::ReebGraph), known.Genus);
  }
}
