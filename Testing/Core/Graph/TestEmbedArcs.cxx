// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/EmbedArcs.h"

#include "Support/CheckEmbedding.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// An arc as its points, nodes included.
struct DrawnArc
{
  int Axis;
  std::array<Index, 4> Face; ///< axis, plane, slabs
  std::vector<Point3> Points;
};

Point3 PointOf(const NodeGraph& graph, Index point)
{
  const double* p = graph.Points.data() + 3 * static_cast<std::size_t>(point);
  return { p[0], p[1], p[2] };
}

DrawnArc Draw(const Stages& stages, Index arc)
{
  DrawnArc drawn;
  const int t = stages.EdgeOf(arc).Direction;
  drawn.Axis = stages.Crossings.Family[arc] == 0 ? FirstAxis(t) : SecondAxis(t);
  drawn.Points.push_back(PointOf(stages.Graph, stages.Nodes.NodeOf[arc]));
  for (Index i = 0; i < stages.Graph.PointCount(arc); ++i)
  {
    drawn.Points.push_back(PointOf(stages.Graph, stages.Graph.FirstPoint(arc) + i));
  }
  drawn.Points.push_back(PointOf(stages.Graph, stages.Nodes.NodeOf[stages.Crossings.Next[arc]]));
  // The face is that of any point between the ends; of their middle, if there is none.
  Point3 inside = drawn.Points[1];
  for (int axis = 0; drawn.Points.size() == 2 && axis < 3; ++axis)
  {
    inside[axis] = drawn.Points[0][axis] + 0.5 * (drawn.Points[1][axis] - drawn.Points[0][axis]);
  }
  const int u = FirstAxis(drawn.Axis), v = SecondAxis(drawn.Axis);
  drawn.Face = { drawn.Axis, stages.Grid.Slab(drawn.Axis, inside[drawn.Axis]),
    stages.Grid.Slab(u, inside[u]), stages.Grid.Slab(v, inside[v]) };
  return drawn;
}

std::map<std::array<Index, 4>, std::vector<DrawnArc>> DrawFaces(const Stages& stages)
{
  std::map<std::array<Index, 4>, std::vector<DrawnArc>> faces;
  for (Index arc = 0; arc < stages.Crossings.Count(); ++arc)
  {
    if (!stages.Crossings.IsRemoved(arc))
    {
      const DrawnArc drawn = Draw(stages, arc);
      faces[drawn.Face].push_back(drawn);
    }
  }
  return faces;
}

/// Strictly inside the face but for the ends, in its plane.
void ExpectInside(const Stages& stages, const DrawnArc& arc)
{
  for (std::size_t i = 0; i < arc.Points.size(); ++i)
  {
    const Point3& p = arc.Points[i];
    EXPECT_EQ(p[arc.Axis], stages.Grid.Planes[arc.Axis][arc.Face[1] - 1]);
    for (int side = 0; side < 2 && i > 0 && i + 1 < arc.Points.size(); ++side)
    {
      const int axis = (arc.Axis + 1 + side) % 3;
      EXPECT_TRUE(stages.Grid.IsInside(axis, arc.Face[2 + side], p[axis]));
    }
  }
}

bool FoldsBack(const Point3& a, const Point3& b, const Point3& c, int axis)
{
  double dot = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    dot += (a[i] - b[i]) * (c[i] - b[i]);
  }
  return a == b || b == c || (ExactTurn(a, b, c, axis) == 0 && dot > 0.0);
}

/// Compares all segments of a face with each other.
void ExpectNoneMeet(const std::vector<DrawnArc>& arcs)
{
  const int axis = arcs.front().Axis;
  for (std::size_t a = 0; a < arcs.size(); ++a)
  {
    const std::vector<Point3>& p = arcs[a].Points;
    for (std::size_t i = 0; i + 1 < p.size(); ++i)
    {
      EXPECT_FALSE(i + 2 < p.size() && FoldsBack(p[i], p[i + 1], p[i + 2], axis));
      for (std::size_t b = a; b < arcs.size(); ++b)
      {
        const std::vector<Point3>& q = arcs[b].Points;
        for (std::size_t j = a == b ? i + 2 : 0; j + 1 < q.size(); ++j)
        {
          EXPECT_FALSE(SegmentsMeet(p[i], p[i + 1], q[j], q[j + 1], axis));
        }
      }
    }
  }
}

void ExpectEmbedded(const Stages& stages)
{
  for (const auto& face : DrawFaces(stages))
  {
    for (const DrawnArc& arc : face.second)
    {
      ExpectInside(stages, arc);
    }
    ExpectNoneMeet(face.second);
  }
}

/// Contours on the plane z = 0 that cross the planes x = 0 and y = 0 at 3 and -3, and at 2 and -2
/// where there is a hole.
std::string OnOnePlane(const std::string& contours, bool hole = false)
{
  std::string text;
  for (const char* plane : { "x=0: ", "y=0: " })
  {
    text += std::string(plane) + "-3,-3 3,-3 3,3 -3,3\n";
    text += hole ? std::string(plane) + "-2,-2 -2,2 2,2 2,-2\n" : "";
  }
  return text + contours;
}

/// Every arc leads to the one that comes from it.
void ExpectLinked(const GridCrossings& crossings)
{
  for (Index arc = 0; arc < crossings.Count(); ++arc)
  {
    EXPECT_TRUE(crossings.IsRemoved(arc) || crossings.Previous[crossings.Next[arc]] == arc);
  }
}

std::size_t CountKind(const Stages& stages, RepairKind kind)
{
  std::size_t count = 0;
  for (const Repair& repair : stages.Redrawn)
  {
    count += repair.Kind == kind ? 1 : 0;
  }
  return count;
}

std::ptrdiff_t CountMarks(const Stages& stages)
{
  return std::count(stages.Graph.Redrawn.begin(), stages.Graph.Redrawn.end(), 1);
}
}

//----------------------------------------------------------------------------
TEST(EmbedArcs, LeavesContoursThatDoNotTouch)
{
  for (const std::string& text : { Cube(), Octahedron() })
  {
    const Stages stages(text);
    EXPECT_TRUE(stages.Redrawn.empty());
    ExpectEmbedded(stages);
  }
}

//----------------------------------------------------------------------------
TEST(EmbedArcs, MovesVerticesOffTheBorderOfTheirFace)
{
  // From the line x = 0 the contour touches the line y = 0 before it crosses it.
  const Stages stages(OnOnePlane("z=0: 0,-3 1,-2 2,0 2.5,-1 3,0 3,3 -3,3 -3,-3"));
  EXPECT_TRUE(stages.Redrawn.empty());
  ExpectEmbedded(stages);
}

//----------------------------------------------------------------------------
TEST(EmbedArcs, LeavesOutTheTipOfASpike)
{
  const Stages stages(OnOnePlane("z=0: -3,-3 3,-3 3,3 1,1 3,3 -3,3"));
  ASSERT_EQ(stages.Redrawn.size(), 1u);
  EXPECT_EQ(stages.Redrawn[0].Kind, RepairKind::ArcsUncrossed);
  ExpectEmbedded(stages);
  EXPECT_EQ(CountMarks(stages), 1);
}

//----------------------------------------------------------------------------
TEST(EmbedArcs, PassesALoopTheOtherWay)
{
  const Stages before(OnOnePlane("z=0: -3,-3 3,-3 3,1 1,1 1,2 3,3 -3,3"));
  const Stages stages(OnOnePlane("z=0: -3,-3 3,-3 3,1 1,2 1,1 3,3 -3,3"));
  ASSERT_EQ(stages.Redrawn.size(), 1u);
  const Repair& repair = stages.Redrawn[0];
  EXPECT_EQ(repair.Kind, RepairKind::ArcsUncrossed);
  EXPECT_EQ(repair.Axis, 2);
  EXPECT_EQ(repair.Plane, 0);
  EXPECT_NEAR(repair.Size, std::sqrt(8.0) - 2.0, 1e-12);
  EXPECT_EQ(repair.Where[2], 0.0);
  ExpectEmbedded(stages);
  EXPECT_EQ(CountMarks(stages), 1);
  // The same surface as if the contour had been drawn that way, with all its vertices.
  EXPECT_EQ(before.Graph.Points, stages.Graph.Points);
}

//----------------------------------------------------------------------------
TEST(EmbedArcs, TakesTwoArcsApartThatCrossTwice)
{
  // In the first quadrant the ends are nested and the arcs cross all the same, by so little that
  // the loops count as two.
  const Stages stages(OnOnePlane("z=0: 3,-3 3,1 1.45,1.45 1,3 -3,3 -3,-3\n"
                                 "z=0: -2,-2 -2,2 1,2 2,1 2,-2",
    true));
  EXPECT_EQ(CountKind(stages, RepairKind::ArcsUncrossed), 1u);
  EXPECT_EQ(stages.Redrawn.size(), 1u);
  EXPECT_EQ(CountMarks(stages), 2);
  ExpectEmbedded(stages);
  ExpectLinked(stages.Crossings);
}

//----------------------------------------------------------------------------
/// A real slice has a hole that meets the plane z = 0 from x = 1 to 2. The virtual slice there
/// lacks it, and has an arc close beside that edge of the grid.
TEST(EmbedArcs, FitsABumpBetweenAnArcAndAnEdge)
{
  Input input;
  input.Sets = ParsePieces(OnOnePlane("y=0: -1,1 -1,2 1,2 1,1\n"
                                      "z=0: -3,-3 3,-3 3,2 2.5,0.1 0.5,0.1 1,3 -3,3"));
  for (Pieces& pieces : input.Sets)
  {
    pieces.Virtual.assign(pieces.Cell.size(), &pieces == &input.Sets[2] ? 1 : 0);
  }
  const Stages stages(input);
  // The bump in the face below, where there is nothing else, and the arc and the bump in that
  // above.
  EXPECT_EQ(CountKind(stages, RepairKind::ArcsRedrawn), 1u);
  EXPECT_EQ(CountKind(stages, RepairKind::ArcsUncrossed), 1u);
  EXPECT_EQ(stages.Redrawn.size(), 2u);
  ExpectEmbedded(stages);
  ExpectLinked(stages.Crossings);
  Index kept = 0; // vertices of the arc
  for (Index point = 0; point < stages.Graph.Count(); ++point)
  {
    const Point3 p = PointOf(stages.Graph, point);
    kept += p == Point3{ 2.5, 0.1, 0.0 } || p == Point3{ 0.5, 0.1, 0.0 } ? 1 : 0;
  }
  EXPECT_EQ(kept, 2);
}

//----------------------------------------------------------------------------
TEST(EmbedArcs, RedrawsFacesOnDemand)
{
  Stages stages(Octahedron());
  const std::vector<Repair> repairs =
    EmbedArcs({ stages.Grid, stages.Nodes, stages.Crossings, stages.Graph }, Execution(), { 0 });
  EXPECT_EQ(repairs.size(), 1u);
  EXPECT_EQ(repairs[0].Kind, RepairKind::ArcsRedrawn);
  ExpectEmbedded(stages);
}

//----------------------------------------------------------------------------
TEST(EmbedArcs, NoArcsMeetWhateverTheContours)
{
  std::size_t uncrossed = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(60); ++seed)
  {
    Input input = RandomContradictoryInput(seed);
    SCOPED_TRACE(input.Name);
    input.Settings.Crossing = CrossingContours::Repair;
    const Stages stages(input);
    ExpectEmbedded(stages);
    ExpectLinked(stages.Crossings);
    uncrossed += CountKind(stages, RepairKind::ArcsUncrossed);
  }
  EXPECT_GT(uncrossed, 100u);
}

//----------------------------------------------------------------------------
TEST(EmbedArcs, NoShellsMeetWhateverTheContours)
{
  std::size_t redrawn = 0, reconnected = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(60); ++seed)
  {
    Input input = RandomContradictoryInput(seed);
    SCOPED_TRACE(input.Name);
    input.Settings.Crossing = CrossingContours::Repair;
    const Stages stages(input, true);
    ExpectEmbedded(stages);
    ExpectLinked(stages.Crossings);
    redrawn += CountKind(stages, RepairKind::ArcsRedrawn);
    reconnected += CountKind(stages, RepairKind::ArcsReconnected);
    EXPECT_EQ(CountKind(stages, RepairKind::ArcsUncrossed), 0u);
  }
  EXPECT_GT(redrawn, 1000u);
  EXPECT_GT(reconnected, 0u);
}
