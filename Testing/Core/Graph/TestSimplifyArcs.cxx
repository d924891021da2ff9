// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/SimplifyArcs.h"

#include "Core/Base/Vectors.h"
#include "Support/SliceSolid.h"
#include "Support/Stages.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
NodeGraph Thin(
  const Stages& stages, const Thinning& thinning, const Execution& execution = Execution())
{
  NodeGraph graph = stages.Graph;
  ThinArcs(thinning, stages.Crossings, stages.Nodes, execution, graph);
  return graph;
}

/// The points of an arc from node to node.
std::vector<Point3> PointsOf(const Stages& stages, const NodeGraph& graph, Index arc)
{
  std::vector<Point3> points{ graph.PointAt(stages.Nodes.NodeOf[arc]) };
  for (Index i = 0; i < graph.PointCount(arc); ++i)
  {
    points.push_back(graph.PointAt(graph.FirstPoint(arc) + i));
  }
  points.push_back(graph.PointAt(stages.Nodes.NodeOf[stages.Crossings.Next[arc]]));
  return points;
}

double DistanceTo(const Point3& p, const Point3& a, const Point3& b)
{
  const Point3 ab = b - a;
  const double share = Dot(ab, ab) > 0.0 ? Dot(p - a, ab) / Dot(ab, ab) : 0.0;
  return Length(p - Between(a, b, std::max(0.0, std::min(1.0, share))));
}

Stages FineSlices(const Solid& solid, int count = 7, int subdivisions = 12)
{
  Input input;
  input.Sets =
    SliceSolid(solid, EqualPlanes(solid, { count, count, count }), subdivisions, InPlaneGrid::Free);
  return Stages(input);
}

/// The greatest distance of points left out from the line between the points that stay around them.
double ExpectThinned(const Stages& stages, const NodeGraph& thin)
{
  double worst = 0.0;
  for (Index arc = 0; arc < stages.Crossings.Count(); ++arc)
  {
    if (stages.Crossings.IsRemoved(arc))
    {
      EXPECT_EQ(thin.PointCount(arc), 0);
      continue;
    }
    const std::vector<Point3> before = PointsOf(stages, stages.Graph, arc);
    const std::vector<Point3> after = PointsOf(stages, thin, arc);
    std::size_t i = 0;
    for (std::size_t j = 0; j + 1 < after.size(); ++j)
    {
      for (++i; i < before.size() && before[i] != after[j + 1]; ++i)
      {
        worst = std::max(worst, DistanceTo(before[i], after[j], after[j + 1]));
      }
    }
    EXPECT_EQ(i + 1, before.size()) << "a vertex of arc " << arc << " that was not there";
  }
  return worst;
}
}

//----------------------------------------------------------------------------
TEST(ThinArcs, NothingChangesWithoutTolerance)
{
  const Stages stages = FineSlices(TiltedTorus());
  for (const double tolerance : { 0.0, -1.0, std::nan("") })
  {
    const NodeGraph same = Thin(stages, { tolerance });
    EXPECT_EQ(same.Points, stages.Graph.Points);
    EXPECT_EQ(same.Offsets, stages.Graph.Offsets);
  }
}

//----------------------------------------------------------------------------
TEST(ThinArcs, KeepsTheTolerance)
{
  const Stages stages = FineSlices(TiltedTorus());
  Index before = stages.Graph.Count();
  for (const double tolerance : { 1e-4, 1e-3, 1e-2 })
  {
    const NodeGraph thin = Thin(stages, { tolerance });
    EXPECT_LE(ExpectThinned(stages, thin), tolerance);
    EXPECT_LT(thin.Count(), before);
    EXPECT_EQ(thin.Points.size(), 3u * thin.Count());
    before = thin.Count();
  }
}

//----------------------------------------------------------------------------
TEST(ThinArcs, NodePointsStay)
{
  const Stages stages = FineSlices(LinkedTori());
  const NodeGraph thin = Thin(stages, { 100.0 });
  EXPECT_EQ(thin.Nodes, stages.Graph.Nodes);
  EXPECT_EQ(thin.Count(), thin.Nodes); // nothing else is left
  EXPECT_TRUE(std::equal(thin.Points.begin(), thin.Points.end(), stages.Graph.Points.begin()));
}

//----------------------------------------------------------------------------
TEST(ThinArcs, VerticesOnOneLineGoAndCornersStay)
{
  const Stages stages("x=0: -1,-1 0.3,-1 0.6,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1;"
                      "z=0: -1,-1 1,-1 1,1 -1,1");
  const NodeGraph thin = Thin(stages, { 1e-6 });
  EXPECT_EQ(thin.Count(), stages.Graph.Count() - 2);
  EXPECT_EQ(ExpectThinned(stages, thin), 0.0);
  // Farther than the diagonal of a quarter of a square, the corners go, too.
  EXPECT_EQ(Thin(stages, { 0.7 }).Count(), stages.Graph.Count() - 2);
  EXPECT_EQ(Thin(stages, { 0.71 }).Count(), thin.Nodes);
}

//----------------------------------------------------------------------------
TEST(ThinArcs, SidesStayShort)
{
  const Stages stages("x=0: -1,-1 0.3,-1 0.6,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1;"
                      "z=0: -1,-1 1,-1 1,1 -1,1");
  EXPECT_EQ(Thin(stages, { 1e-6, 0.65 }).Count(), stages.Graph.Count() - 1); // 0.6 stays
  EXPECT_EQ(Thin(stages, { 1e-6, 0.55 }).Count(), stages.Graph.Count());
  EXPECT_EQ(Thin(stages, { 0.71, 0.55 }).Count(), stages.Graph.Count());
}

//----------------------------------------------------------------------------
/// Two node points: each contour has two arcs, far from the line between their ends.
TEST(ThinArcs, BothArcsOfAContourWithTwoNodePoints)
{
  const Stages stages("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1");
  ASSERT_EQ(stages.Nodes.Count(), 2);
  ASSERT_EQ(stages.Crossings.Count(), 4);
  const NodeGraph thin = Thin(stages, { 0.5 });
  for (Index arc = 0; arc < 4; ++arc)
  {
    EXPECT_EQ(thin.PointCount(arc), 2);
  }
  EXPECT_LE(ExpectThinned(stages, thin), 0.5);
}

//----------------------------------------------------------------------------
TEST(ThinArcs, SameForAnyNumberOfThreads)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    const NodeGraph one = Thin(stages, { 0.02 }), many = Thin(stages, { 0.02 }, ManyThreads());
    EXPECT_EQ(one.Points, many.Points);
    EXPECT_EQ(one.Offsets, many.Offsets);
    EXPECT_LE(ExpectThinned(stages, one), 0.02 * (1.0 + 1e-12));
  }
}
