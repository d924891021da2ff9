// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/NodeGraph.h"

#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Point3 PointOf(const NodeGraph& graph, Index i)
{
  return { graph.Points[3 * i], graph.Points[3 * i + 1], graph.Points[3 * i + 2] };
}

std::set<Point3> AllPoints(const NodeGraph& graph)
{
  std::set<Point3> points;
  for (Index i = 0; i < graph.Count(); ++i)
  {
    points.insert(PointOf(graph, i));
  }
  return points;
}

/// Components by spreading labels along the arcs until nothing changes.
Index ComponentsByBruteForce(const Stages& stages, std::vector<Index>& label)
{
  label.resize(stages.Nodes.Count());
  for (Index node = 0; node < stages.Nodes.Count(); ++node)
  {
    label[node] = node;
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (Index arc = 0; arc < stages.Crossings.Count(); ++arc)
    {
      if (!stages.Crossings.IsRemoved(arc))
      {
        Index& a = label[stages.Nodes.NodeOf[arc]];
        Index& b = label[stages.Nodes.NodeOf[stages.Crossings.Next[arc]]];
        changed |= a != b;
        a = b = std::min(a, b);
      }
    }
  }
  return static_cast<Index>(std::set<Index>(label.begin(), label.end()).size());
}
}

//----------------------------------------------------------------------------
TEST(NodeGraph, CubeHas24NodesAnd48ArcsWithACornerInHalfOfThem)
{
  const Stages stages{ Cube() };
  EXPECT_EQ(stages.Graph.Nodes, 24);
  EXPECT_EQ(stages.Crossings.Count(), 48);
  EXPECT_EQ(stages.Graph.Components, 1);
  EXPECT_EQ(stages.Graph.Count(), 24 + 6 * 4);
  Index corners = 0;
  for (Index arc = 0; arc < stages.Crossings.Count(); ++arc)
  {
    corners += stages.Graph.PointCount(arc);
    EXPECT_LE(stages.Graph.PointCount(arc), 1);
  }
  EXPECT_EQ(corners, 24);
  EXPECT_EQ(AllPoints(stages.Graph).size(), 48u);
  EXPECT_EQ(AllPoints(stages.Graph).count(Point3{ 1, 0.5, 2.5 }), 1u);
  EXPECT_EQ(AllPoints(stages.Graph).count(Point3{ 0.5, 2.5, 2 }), 1u);
}

//----------------------------------------------------------------------------
TEST(NodeGraph, ArcsKeepTheGeometryOfTheirContour)
{
  const Stages stages("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                      "z=0: 0,-1 1,-1 1.5,-0.5 1,0 1,1 0.5,2 0,1 -1,1 -1,0 -1,-1");
  // From (1, 0) to (0, 1), both vertices of the contour: the vertices in between, in order, and no
  // node twice.
  Index arc = -1;
  for (Index c = 0; c < stages.Crossings.Count(); ++c)
  {
    const bool starts = PointOf(stages.Graph, stages.Nodes.NodeOf[c]) == Point3{ 1, 0, 0 };
    arc = starts && stages.EdgeOf(c).Direction == 0 && stages.Crossings.Family[c] == 1 ? c : arc;
  }
  ASSERT_GE(arc, 0);
  ASSERT_EQ(stages.Graph.PointCount(arc), 2);
  EXPECT_EQ(PointOf(stages.Graph, stages.Graph.FirstPoint(arc)), (Point3{ 1, 1, 0 }));
  EXPECT_EQ(PointOf(stages.Graph, stages.Graph.FirstPoint(arc) + 1), (Point3{ 0.5, 2, 0 }));
}

//----------------------------------------------------------------------------
TEST(NodeGraph, SeparateSolidsAreSeparateComponents)
{
  std::string text;
  for (const char* shape : { "-1,-1 1,-1 1,1 -1,1", "9,9 11,9 11,11 9,11" })
  {
    for (const char* plane : { "x", "y", "z" })
    {
      text += std::string(plane) + (shape[0] == '9' ? "=10: " : "=0: ") + shape + "\n";
    }
  }
  const Stages stages(text);
  EXPECT_EQ(stages.Graph.Nodes, 12);
  EXPECT_EQ(stages.Graph.Components, 2);
  EXPECT_EQ(stages.Graph.Component[0], 0); // numbered by their first node
}

//----------------------------------------------------------------------------
TEST(NodeGraph, ComponentsAsBruteForceHasThem)
{
  Index several = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    SCOPED_TRACE(seed);
    std::vector<Index> label;
    EXPECT_EQ(stages.Graph.Components, ComponentsByBruteForce(stages, label));
    for (Index node = 1; node < stages.Nodes.Count(); ++node)
    {
      EXPECT_EQ(label[node] == label[0], stages.Graph.Component[node] == stages.Graph.Component[0]);
    }
    several += stages.Graph.Components > 1 ? 1 : 0;
  }
  EXPECT_GT(several, 10);
}

//----------------------------------------------------------------------------
/// Else two arcs would be the same edge of the surface.
TEST(NodeGraph, NoTwoArcsWithoutVerticesJoinTheSameNodes)
{
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    SCOPED_TRACE(seed);
    std::set<std::pair<Index, Index>> straight;
    for (Index arc = 0; arc < stages.Crossings.Count(); ++arc)
    {
      if (!stages.Crossings.IsRemoved(arc) && stages.Graph.PointCount(arc) == 0)
      {
        const Index a = stages.Nodes.NodeOf[arc];
        const Index b = stages.Nodes.NodeOf[stages.Crossings.Next[arc]];
        EXPECT_NE(a, b);
        EXPECT_TRUE(straight.insert(std::minmax(a, b)).second);
      }
    }
  }
}

//----------------------------------------------------------------------------
TEST(NodeGraph, PointsStayOnTheirSlice)
{
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    SCOPED_TRACE(seed);
    for (Index arc = 0; arc < stages.Crossings.Count(); ++arc)
    {
      const GridEdge edge = stages.EdgeOf(arc);
      const bool first = stages.Crossings.Family[arc] == 0;
      const int axis = first ? FirstAxis(edge.Direction) : SecondAxis(edge.Direction);
      const double plane = stages.Grid.Planes[axis][first ? edge.First : edge.Second];
      for (Index i = 0; i < stages.Graph.PointCount(arc); ++i)
      {
        EXPECT_EQ(PointOf(stages.Graph, stages.Graph.FirstPoint(arc) + i)[axis], plane);
      }
    }
  }
}
