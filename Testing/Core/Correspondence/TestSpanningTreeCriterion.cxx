// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/SpanningTreeCriterion.h"

#include "Core/Base/DisjointSets.h"
#include "Support/ContourStacks.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
ContourPairs TreeEdges(const ContourStack& stack)
{
  return FindPairs(CorrespondenceCriterion::SpanningTree, stack);
}
}

//----------------------------------------------------------------------------
// Centres 3 and 4 apart along the axes, semi-axes that differ by 2 and 1.
TEST(SpanningTreeCriterion, CostIsSkinners)
{
  ContourStack stack = EmptyStack(2);
  for (Index slice = 0; slice < 2; ++slice)
  {
    std::vector<Point2> vertices;
    const double a = slice == 0 ? 5.0 : 7.0, b = slice == 0 ? 2.0 : 3.0;
    // Rectangles have moments of ellipses: sides of sqrt(3) a and sqrt(3) b.
    const double w = std::sqrt(3.0) * a / 2.0, h = std::sqrt(3.0) * b / 2.0;
    const double u = 3.0 * slice, v = 4.0 * slice;
    AddContour(
      stack, slice, { { u - w, v - h }, { u + w, v - h }, { u + w, v + h }, { u - w, v + h } });
  }
  const auto pairs = FindCorrespondences(CorrespondenceCriterion::SpanningTree, stack);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_NEAR(pairs[0].Cost, 9.0 + 16.0 + 4.0 + 1.0, 1e-9);
}

//----------------------------------------------------------------------------
// The trunk (0, 1) divides into two branches; 1.5 apart from each other at first, then 3.
TEST(SpanningTreeCriterion, FollowsBranches)
{
  ContourStack stack = EmptyStack(4);
  AddEllipse(stack, 0, { 0.0, 0.0 }, 1.0, 0.5);
  AddEllipse(stack, 1, { 2.5, 0.0 }, 1.0, 0.5);
  AddEllipse(stack, 2, { 5.0, -0.75 }, 0.6, 0.5);
  AddEllipse(stack, 2, { 5.0, 0.75 }, 0.6, 0.5);
  AddEllipse(stack, 3, { 7.5, -1.5 }, 0.6, 0.5);
  AddEllipse(stack, 3, { 7.5, 1.5 }, 0.6, 0.5);
  EXPECT_EQ(TreeEdges(stack), (ContourPairs{ { 0, 1 }, { 1, 2 }, { 1, 3 }, { 2, 4 }, { 3, 5 } }));
}

//----------------------------------------------------------------------------
// A ring: one contour, two on two slices each, one. Its six edges are a cycle, so one is missing.
TEST(SpanningTreeCriterion, CannotExpressAHandle)
{
  ContourStack stack = EmptyStack(4);
  AddEllipse(stack, 0, { 0.0, 0.0 }, 0.3, 1.5);
  for (Index slice = 1; slice < 3; ++slice)
  {
    AddEllipse(stack, slice, { 0.1 * slice, -1.4 }, 0.3, 0.3);
    AddEllipse(stack, slice, { 0.1 * slice, 1.4 }, 0.3, 0.3);
  }
  AddEllipse(stack, 3, { 0.3, 0.0 }, 0.3, 1.5);
  EXPECT_EQ(TreeEdges(stack).size(), 5u);
}

//----------------------------------------------------------------------------
// Two columns 20 apart: the edge that joins them is longer than three median ones. At 4 it is not.
TEST(SpanningTreeCriterion, EdgesOutOfProportionAreDropped)
{
  const auto columns = [](double distance)
  {
    ContourStack stack = EmptyStack(4);
    for (Index slice = 0; slice < 4; ++slice)
    {
      AddEllipse(stack, slice, { 2.0 * slice, 0.0 }, 0.8, 0.8);
      AddEllipse(stack, slice, { 2.0 * slice, distance }, 0.8, 0.8);
    }
    return TreeEdges(stack);
  };
  EXPECT_EQ(
    columns(20.0), (ContourPairs{ { 0, 2 }, { 1, 3 }, { 2, 4 }, { 3, 5 }, { 4, 6 }, { 5, 7 } }));
  EXPECT_EQ(columns(4.0).size(), 7u);
}

//----------------------------------------------------------------------------
// Of an upright column all edges have the length 0; the nearest contour is kept nevertheless.
TEST(SpanningTreeCriterion, EdgesBetweenNearContoursAreKept)
{
  ContourStack stack = EmptyStack(4);
  for (Index slice = 0; slice < 4; ++slice)
  {
    AddEllipse(stack, slice, { slice < 3 ? 0.0 : 1.0, 0.0 }, 0.8, 0.8);
  }
  EXPECT_EQ(TreeEdges(stack), (ContourPairs{ { 0, 1 }, { 1, 2 }, { 2, 3 } }));
}

//----------------------------------------------------------------------------
// Against Kruskal's algorithm on the list of all pairs; so close together that none is dropped.
TEST(SpanningTreeCriterion, IsTheTreeOfAllPairs)
{
  Random random(11);
  for (int round = 0; round < 50; ++round)
  {
    ContourStack stack = EmptyStack(4);
    std::vector<std::array<double, 4>> values;
    for (Index slice = 0; slice < 4; ++slice)
    {
      for (std::size_t i = 0; i < 1 + random.Below(6); ++i)
      {
        const double u = random.Uniform(0, 1), v = random.Uniform(0, 1);
        const double b = random.Uniform(2, 3), a = b + random.Uniform(0, 1);
        AddEllipse(stack, slice, { u, v }, a, b);
        values.push_back({ u, v, a, b });
      }
    }
    std::vector<std::pair<double, std::pair<Index, Index>>> all;
    for (Index i = 0; i < stack.Count(); ++i)
    {
      for (Index j = 0; j < stack.Count(); ++j)
      {
        if (stack.Slice[j] == stack.Slice[i] + 1)
        {
          double cost = 0.0;
          for (int k = 0; k < 4; ++k)
          {
            cost += (values[i][k] - values[j][k]) * (values[i][k] - values[j][k]);
          }
          all.push_back({ cost, { i, j } });
        }
      }
    }
    std::sort(all.begin(), all.end());
    DisjointSets trees(stack.Count());
    ContourPairs expected;
    for (const auto& edge : all)
    {
      if (trees.Unite(edge.second.first, edge.second.second))
      {
        expected.push_back(edge.second);
      }
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(TreeEdges(stack), expected) << "round " << round;
  }
}
