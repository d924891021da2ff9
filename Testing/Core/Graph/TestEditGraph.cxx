// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/EditGraph.h"

#include "Core/Graph/CheckGraph.h"
#include "Core/Graph/FaceArcs.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
std::vector<Point3> VerticesOf(const NodeGraph& graph, Index arc)
{
  std::vector<Point3> points;
  for (Index i = 0; i < graph.PointCount(arc); ++i)
  {
    points.push_back(graph.PointAt(graph.FirstPoint(arc) + i));
  }
  return points;
}

/// Two octahedra far from each other: twelve node points.
std::string TwoOctahedra()
{
  return Octahedron() +
    "; x=10: 9,9 11,9 11,11 9,11; y=10: 9,9 11,9 11,11 9,11; z=10: 9,9 11,9 11,11 9,11";
}
}

//----------------------------------------------------------------------------
TEST(EditGraph, ReplacesTheVerticesOfAnArcAndNoOthers)
{
  const Stages stages{ Cube() };
  NodeGraph graph = stages.Graph;
  GridCrossings crossings = stages.Crossings;
  FaceDrawing drawing;
  drawing.Arcs = { 3 };
  drawing.Points = { { 1, 2, 3 }, { 4, 5, 6 } };
  drawing.Offsets = { 0, 2 };
  ReplaceArcs({ drawing }, crossings, graph);
  for (Index arc = 0; arc < graph.Arcs; ++arc)
  {
    EXPECT_EQ(VerticesOf(graph, arc), arc == 3 ? drawing.Points : VerticesOf(stages.Graph, arc));
    EXPECT_EQ(graph.Redrawn[arc], arc == 3 ? 1 : 0);
  }
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    EXPECT_EQ(graph.PointAt(node), stages.Graph.PointAt(node));
  }
}

//----------------------------------------------------------------------------
TEST(EditGraph, JoinsArcsInBothDirections)
{
  const Stages stages{ Cube() };
  NodeGraph graph = stages.Graph;
  GridCrossings crossings = stages.Crossings;
  FaceDrawing drawing;
  const Index a = 0, b = 5;
  drawing.Joins = { { a, crossings.Next[b] }, { b, crossings.Next[a] } };
  ReplaceArcs({ drawing }, crossings, graph);
  EXPECT_EQ(crossings.Next[a], stages.Crossings.Next[b]);
  EXPECT_EQ(crossings.Next[b], stages.Crossings.Next[a]);
  EXPECT_EQ(crossings.Previous[crossings.Next[a]], a);
  EXPECT_EQ(crossings.Previous[crossings.Next[b]], b);
}

//----------------------------------------------------------------------------
TEST(EditGraph, LeavesOutTheVerticesThatAreNotMarked)
{
  const Stages stages{ Cube(4) };
  NodeGraph graph = stages.Graph;
  std::vector<std::uint8_t> isKept(graph.Offsets.back());
  for (std::size_t i = 0; i < isKept.size(); ++i)
  {
    isKept[i] = i % 3 == 0 ? 1 : 0;
  }
  LeaveOutVertices(isKept, graph);
  for (Index arc = 0; arc < graph.Arcs; ++arc)
  {
    std::vector<Point3> expected;
    for (Index i = stages.Graph.Offsets[arc]; i < stages.Graph.Offsets[arc + 1]; ++i)
    {
      if (i % 3 == 0)
      {
        expected.push_back(stages.Graph.PointAt(stages.Graph.Nodes + i));
      }
    }
    EXPECT_EQ(VerticesOf(graph, arc), expected);
  }
  EXPECT_EQ(CheckFourArcs(stages.Crossings, stages.Nodes, graph), "");
}

//----------------------------------------------------------------------------
TEST(EditGraph, ReplacesLoops)
{
  const Stages stages{ Octahedron() };
  NodeGraph graph = stages.Graph;
  const GraphLoop first{ { 2, 0, { 1, 1 } }, { { 5, 5, 0 }, { 6, 5, 0 }, { 6, 6, 0 } } };
  const GraphLoop second{ { 2, 0, { 1, 1 } }, { { 7, 7, 0 }, { 8, 7, 0 }, { 8, 8, 0 } } };
  SetLoops({ first, second }, graph);
  ASSERT_EQ(graph.Loops.size(), 2u);
  EXPECT_EQ(VerticesOf(graph, graph.Arcs), first.Points);
  EXPECT_EQ(VerticesOf(graph, graph.Arcs + 1), second.Points);
  EXPECT_EQ(CheckEmbedding(stages.Grid, stages.Crossings, stages.Nodes, graph), "");
  SetLoops({ second }, graph);
  ASSERT_EQ(graph.Loops.size(), 1u);
  EXPECT_EQ(VerticesOf(graph, graph.Arcs), second.Points);
  SetLoops({}, graph);
  EXPECT_EQ(graph.Points, stages.Graph.Points);
  EXPECT_EQ(graph.Offsets, stages.Graph.Offsets);
}

//----------------------------------------------------------------------------
TEST(EditGraph, RemovesNodesWithTheirArcs)
{
  const Stages stages{ TwoOctahedra() };
  ASSERT_EQ(stages.Graph.Nodes, 12);
  NodeGraph graph = stages.Graph;
  GridCrossings crossings = stages.Crossings;
  NodePoints nodes = stages.Nodes;
  std::vector<std::uint8_t> isRemoved(12);
  std::vector<Point3> kept;
  std::vector<double> normals;
  for (Index node = 0; node < 12; ++node)
  {
    const Point3 p = graph.PointAt(node);
    isRemoved[node] = p[0] > 5 ? 1 : 0;
    normals.insert(normals.end(), p.begin(), p.end()); // any values that can be told apart
    if (p[0] <= 5)
    {
      kept.push_back(p);
    }
  }
  ASSERT_EQ(kept.size(), 6u);
  RemoveNodes(isRemoved, crossings, nodes, normals, graph);
  ASSERT_EQ(graph.Nodes, 6);
  for (Index node = 0; node < 6; ++node)
  {
    EXPECT_EQ(graph.PointAt(node), kept[node]);
    EXPECT_EQ(
      (Point3{ normals[3 * node], normals[3 * node + 1], normals[3 * node + 2] }), kept[node]);
  }
  EXPECT_EQ(CheckFourArcs(crossings, nodes, graph), "");
}

//----------------------------------------------------------------------------
TEST(EditGraph, MovesVerticesIntoTheirFaces)
{
  const Stages stages{ Cube(4) };
  NodeGraph graph = stages.Graph;
  const ArcsByFace faces = GroupArcsByFace(stages.Grid, stages.Crossings, Execution());
  // A vertex of some arc is put onto the edge of its face.
  Index moved = -1;
  for (Index i = 0; i < faces.Count() && moved < 0; ++i)
  {
    const FaceArcs face = faces[i];
    const int axis = FirstAxis(face.Face.Axis);
    if (face.Face.Slab[0] > 0 && graph.PointCount(*face.First) > 0)
    {
      moved = graph.FirstPoint(*face.First);
      graph.Points[3 * moved + axis] = stages.Grid.Planes[axis][face.Face.Slab[0] - 1];
    }
  }
  ASSERT_GE(moved, 0);
  EXPECT_NE(CheckEmbedding(stages.Grid, stages.Crossings, stages.Nodes, graph), "");
  MoveInsideFaces(stages.Grid, faces, Execution(), graph);
  EXPECT_EQ(CheckEmbedding(stages.Grid, stages.Crossings, stages.Nodes, graph).find("leaves"),
    std::string::npos);
}
