// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/TriangleAdjacency.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Two triangles with a common side from point 0 to point 1.
TriangleAdjacency TwoTriangles()
{
  TriangleAdjacency triangles;
  triangles.push_back({ { 0, 1, 2 }, { 1, -1, -1 } });
  triangles.push_back({ { 3, 1, 0 }, { -1, 0, -1 } });
  return triangles;
}

using Side = std::pair<Index, Index>;

/// All sides, and that the links are those of triangles with the same side, the other way round.
std::set<Side> CheckLinks(const TriangleAdjacency& triangles)
{
  std::map<Side, Index> sides;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const TriangleSide side{ static_cast<Index>(t), i };
      EXPECT_TRUE(
        sides.insert({ { triangles.StartOf(side), triangles.EndOf(side) }, side.Triangle }).second);
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const TriangleSide side{ static_cast<Index>(t), i };
      const auto back = sides.find({ triangles.EndOf(side), triangles.StartOf(side) });
      EXPECT_EQ(triangles.NeighborOf(side), back == sides.end() ? -1 : back->second);
    }
  }
  std::set<Side> all;
  for (const auto& [side, triangle] : sides)
  {
    all.insert(side);
  }
  return all;
}
}

//----------------------------------------------------------------------------
TEST(TriangleAdjacency, KnowsWhatIsAcrossASide)
{
  const TriangleAdjacency triangles = TwoTriangles();
  CheckLinks(triangles);
  const TriangleSide back = triangles.BackOf({ 0, 0 });
  EXPECT_EQ(back.Triangle, 1);
  EXPECT_EQ(back.Side, 1);
  EXPECT_EQ(triangles.ApexOf({ 0, 0 }), 2);
  EXPECT_EQ(triangles.ApexOf(back), 3);
  EXPECT_EQ(triangles[1].CornerOf(0), 2);
  EXPECT_EQ(triangles[1].SideTo(0), 1);
}

//----------------------------------------------------------------------------
TEST(TriangleAdjacency, FlipTakesTheOtherDiagonal)
{
  TriangleAdjacency triangles = TwoTriangles();
  triangles.Flip({ 0, 0 });
  EXPECT_EQ(triangles[0].Corners, (std::array<Index, 3>{ 0, 3, 2 }));
  EXPECT_EQ(triangles[1].Corners, (std::array<Index, 3>{ 3, 1, 2 }));
  const std::set<Side> sides = CheckLinks(triangles);
  EXPECT_EQ(sides.count({ 0, 1 }) + sides.count({ 1, 0 }), 0u);
  EXPECT_EQ(sides.count({ 2, 3 }) + sides.count({ 3, 2 }), 2u);
}

//----------------------------------------------------------------------------
TEST(TriangleAdjacency, DivideAndSplitKeepTheOuterSides)
{
  const std::set<Side> outer{ { 1, 2 }, { 2, 0 }, { 0, 3 }, { 3, 1 } };
  TriangleAdjacency divided = TwoTriangles();
  divided.Divide(0, 4);
  ASSERT_EQ(divided.size(), 4u);
  EXPECT_EQ(divided[0].Corners, (std::array<Index, 3>{ 0, 1, 4 }));
  EXPECT_EQ(divided[2].Corners, (std::array<Index, 3>{ 1, 2, 4 }));
  EXPECT_EQ(divided[3].Corners, (std::array<Index, 3>{ 2, 0, 4 }));
  TriangleAdjacency split = TwoTriangles();
  split.Split({ 0, 0 }, 4);
  ASSERT_EQ(split.size(), 4u);
  const std::set<Side> sides = CheckLinks(split);
  EXPECT_EQ(sides.count({ 0, 1 }), 0u);
  for (const Side& side : outer)
  {
    EXPECT_EQ(sides.count(side), 1u);
    EXPECT_EQ(CheckLinks(divided).count(side), 1u);
  }
}

//----------------------------------------------------------------------------
TEST(TriangleAdjacency, LinksStayRightUnderRandomChanges)
{
  Random random(1);
  TriangleAdjacency triangles = TwoTriangles();
  Index points = 4;
  for (int i = 0; i < 300; ++i)
  {
    const TriangleSide side{ static_cast<Index>(random.Below(triangles.size())),
      static_cast<int>(random.Below(3)) };
    if (random.Chance(0.2))
    {
      triangles.Divide(side.Triangle, points++);
    }
    else if (triangles.NeighborOf(side) >= 0)
    {
      // A flip must not join two points a second time.
      const Index c = triangles.ApexOf(side), d = triangles.ApexOf(triangles.BackOf(side));
      const std::set<Side> sides = CheckLinks(triangles);
      if (random.Chance(0.2))
      {
        triangles.Split(side, points++);
      }
      else if (sides.count({ c, d }) + sides.count({ d, c }) == 0)
      {
        triangles.Flip(side);
      }
    }
    CheckLinks(triangles);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_EQ(triangles.size(), 2u + 2u * static_cast<std::size_t>(points - 4));
}
