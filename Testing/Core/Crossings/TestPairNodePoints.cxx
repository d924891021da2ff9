// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/PairNodePoints.h"

#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
std::set<Point3> Positions(const Stages& stages)
{
  std::set<Point3> positions;
  const GridEdgeCode code(stages.Grid);
  for (Index node = 0; node < stages.Nodes.Count(); ++node)
  {
    positions.insert(NodePosition(stages.Grid, code, stages.Crossings, stages.Nodes, node));
  }
  return positions;
}
}

//----------------------------------------------------------------------------
TEST(PairNodePoints, OctahedronHasOneOnEachHalfAxis)
{
  const Stages stages{ Octahedron() };
  EXPECT_EQ(stages.Nodes.Count(), 6);
  EXPECT_EQ(Positions(stages),
    (std::set<Point3>{
      { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } }));
}

//----------------------------------------------------------------------------
TEST(PairNodePoints, CubeHasTwoOnEachGridLine)
{
  const Stages stages{ Cube() };
  std::set<Point3> expected;
  for (const double end : { 0.5, 2.5 })
  {
    for (const double a : { 1.0, 2.0 })
    {
      for (const double b : { 1.0, 2.0 })
      {
        expected.insert({ end, a, b });
        expected.insert({ a, end, b });
        expected.insert({ a, b, end });
      }
    }
  }
  EXPECT_EQ(stages.Nodes.Count(), 24);
  EXPECT_EQ(Positions(stages), expected);
}

//----------------------------------------------------------------------------
TEST(PairNodePoints, LiesMidwayBetweenItsTwoContours)
{
  // The z-slice reaches 0.5 farther along +y than the x-slice.
  const Stages stages("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                      "z=0: -1,-1 1,-1 1,1.5 -1,1.5");
  ASSERT_EQ(stages.Nodes.Count(), 6);
  const GridEdgeCode code(stages.Grid);
  int disagreeing = 0;
  for (Index node = 0; node < 6; ++node)
  {
    const double distance = stages.Nodes.Disagreement(node);
    const Point3 p = NodePosition(stages.Grid, code, stages.Crossings, stages.Nodes, node);
    disagreeing += distance == 0.5 ? 1 : 0;
    EXPECT_EQ(distance == 0.5, p == (Point3{ 0, 1.25, 0 }));
  }
  EXPECT_EQ(disagreeing, 1);
}

//----------------------------------------------------------------------------
TEST(PairNodePoints, PartnersAreMutualAndOnTheSameEdge)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    SCOPED_TRACE(seed);
    for (Index c = 0; c < stages.Crossings.Count(); ++c)
    {
      if (stages.Crossings.IsRemoved(c))
      {
        EXPECT_EQ(stages.Nodes.NodeOf[c], GridCrossings::None);
        continue;
      }
      const Index partner = stages.Nodes.Partner(stages.Crossings, c);
      EXPECT_EQ(stages.Nodes.Partner(stages.Crossings, partner), c);
      EXPECT_EQ(stages.Crossings.Edge[partner], stages.Crossings.Edge[c]);
      EXPECT_NE(stages.Crossings.Family[partner], stages.Crossings.Family[c]);
      EXPECT_EQ(stages.Crossings.Sign(partner), stages.Crossings.Sign(c));
    }
  }
}

//----------------------------------------------------------------------------
/// The z-slice reaches 0.3 farther along +y than the x-slice: the node is where the real one is, to
/// the last bit, and nothing says that the two disagree.
TEST(PairNodePoints, LiesOnTheRealContour)
{
  for (const int virtualAxis : { 0, 2 })
  {
    PieceSets sets = ParsePieces("x=0: -1,-1 1,-1 1,0.9 -1,0.9; y=0: -1,-1 1,-1 1,1 -1,1\n"
                                 "z=0: -1,-1 1,-1 1,1.2 -1,1.2");
    // The coordinates of the x-slice are y and z: turn it, so that 0.9 is along y.
    std::swap(sets[0].U, sets[0].V);
    sets[virtualAxis].Virtual.assign(1, 1);
    Input input;
    input.Sets = sets;
    const Stages stages(input);
    const Point3 expected{ 0.0, virtualAxis == 0 ? 1.2 : 0.9, 0.0 };
    EXPECT_EQ(Positions(stages).count(expected), 1u);
    for (Index node = 0; node < stages.Nodes.Count(); ++node)
    {
      EXPECT_EQ(stages.Nodes.Disagreement(node), 0.0);
    }
  }
}
