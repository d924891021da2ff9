// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/SegmentTree.h"

#include "Support/Random.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Contours of one slice: random walks, so that many boxes overlap.
Contours RandomContours(std::uint64_t seed)
{
  Random random(seed);
  Contours contours;
  const std::size_t count = 1 + random.Below(5);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t size = 3 + random.Below(60);
    double u = random.Uniform(-3, 3), v = random.Uniform(-3, 3);
    for (std::size_t k = 0; k < size; ++k)
    {
      contours.U.push_back(u += random.Uniform(-1, 1));
      contours.V.push_back(v += random.Uniform(-1, 1));
    }
    contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
    contours.Axis.push_back(2);
    contours.Coordinate.push_back(0.0);
    contours.Plane.push_back(0);
    contours.Cell.push_back(0);
  }
  return contours;
}

std::vector<Index> AllOf(const Contours& contours)
{
  std::vector<Index> all(contours.Count());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Ends of the segment that starts at a vertex.
std::array<Index, 2> Ends(const Contours& contours, Index contour, Index vertex)
{
  const Index next = vertex + 1;
  return { vertex, next < contours.Offsets[contour + 1] ? next : contours.Offsets[contour] };
}

bool BoxesOverlap(const std::vector<double>& x, std::array<Index, 2> a, std::array<Index, 2> b)
{
  return std::min(x[a[0]], x[a[1]]) <= std::max(x[b[0]], x[b[1]]) &&
    std::min(x[b[0]], x[b[1]]) <= std::max(x[a[0]], x[a[1]]);
}

std::multiset<std::pair<Index, Index>> OverlapsByBruteForce(const Contours& contours)
{
  std::vector<std::array<Index, 2>> segments;
  for (Index c = 0; c < contours.Count(); ++c)
  {
    for (Index i = contours.Offsets[c]; i < contours.Offsets[c + 1]; ++i)
    {
      segments.push_back(Ends(contours, c, i));
    }
  }
  std::multiset<std::pair<Index, Index>> pairs;
  for (std::size_t j = 0; j < segments.size(); ++j)
  {
    for (std::size_t i = 0; i < j; ++i)
    {
      const auto &a = segments[i], &b = segments[j];
      const bool share = a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
      if (!share && BoxesOverlap(contours.U, a, b) && BoxesOverlap(contours.V, a, b))
      {
        pairs.emplace(a[0], b[0]);
      }
    }
  }
  return pairs;
}
}

//----------------------------------------------------------------------------
TEST(SegmentTree, VisitsEveryOverlappingPairOnce)
{
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE(seed);
    const Contours contours = RandomContours(seed);
    std::multiset<std::pair<Index, Index>> pairs;
    SegmentTree(contours, AllOf(contours))
      .VisitOverlaps([&](SegmentTree::Segment a, SegmentTree::Segment b)
        { pairs.insert(std::minmax(a.Vertex, b.Vertex)); });
    EXPECT_EQ(pairs, OverlapsByBruteForce(contours));
    found += pairs.size();
  }
  EXPECT_GT(found, 1000u);
}

//----------------------------------------------------------------------------
TEST(SegmentTree, TellsTheContoursOfAPair)
{
  const Contours contours = ParseContours("z=0: 0,0 4,0 4,4 0,4; z=0: 3,1 6,1 6,2 3,2");
  SegmentTree(contours, { 0, 1 })
    .VisitOverlaps(
      [&](SegmentTree::Segment a, SegmentTree::Segment b)
      {
        EXPECT_EQ(a.Contour, a.Vertex < 4 ? 0 : 1);
        EXPECT_EQ(b.Contour, b.Vertex < 4 ? 0 : 1);
      });
}

//----------------------------------------------------------------------------
TEST(SegmentTree, CountsWhatLiesAbove)
{
  const Contours contours = ParseContours("z=0: 0,0 4,0 4,4 0,4; z=0: 1,1 3,1 3,3 1,3");
  const SegmentTree tree(contours, { 0, 1 });
  EXPECT_EQ(tree.CountAbove(2, -1, -1), 4);
  EXPECT_EQ(tree.CountAbove(2, 2, -1), 2);
  EXPECT_EQ(tree.CountAbove(2, 2, 1), 1);
  EXPECT_EQ(tree.CountAbove(0.5, 2, -1), 1);
  EXPECT_EQ(tree.CountAbove(2, 5, -1), 0);
  EXPECT_EQ(tree.CountAbove(9, 0, -1), 0);
}

//----------------------------------------------------------------------------
TEST(SegmentTree, CountsAboveAsBruteForceDoes)
{
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE(seed);
    const Contours contours = RandomContours(seed);
    const SegmentTree tree(contours, AllOf(contours));
    Random random(seed);
    for (int k = 0; k < 50; ++k)
    {
      const double u = random.Uniform(-5, 5), v = random.Uniform(-5, 5);
      Index expected = 0;
      for (Index i = contours.Offsets[0]; i < contours.Offsets.back(); ++i)
      {
        Index c = 0;
        while (contours.Offsets[c + 1] <= i)
        {
          ++c;
        }
        const auto ends = Ends(contours, c, i);
        const double a = contours.U[ends[0]] - u, b = contours.U[ends[1]] - u;
        const double height = (contours.V[ends[0]] * b - contours.V[ends[1]] * a) / (b - a);
        expected += c != 0 && (a > 0) != (b > 0) && height > v ? 1 : 0;
      }
      EXPECT_EQ(tree.CountAbove(u, v, 0), expected);
    }
  }
}

//----------------------------------------------------------------------------
TEST(SegmentTree, OfNoContoursFindsNothing)
{
  const Contours contours;
  const SegmentTree tree(contours, {});
  bool visited = false;
  tree.VisitOverlaps([&](SegmentTree::Segment, SegmentTree::Segment) { visited = true; });
  EXPECT_FALSE(visited);
  EXPECT_EQ(tree.CountAbove(0, 0, -1), 0);
}
