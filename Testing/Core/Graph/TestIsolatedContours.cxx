// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/EmbedIsolated.h"
#include "Core/Graph/IsolatedContours.h"

#include "Support/CheckEmbedding.h"
#include "Support/Random.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// The stages up to EmbedIsolated; contours as drawn.
struct LoopStages : Stages
{
  explicit LoopStages(const std::string& text, double minimum = 0.0)
    : Stages(text)
    , Copies(CopyIsolated(this->Isolated, this->Set, this->Crossings))
  {
    this->Embed(minimum);
  }

  void Embed(double minimum)
  {
    EmbedIsolated({ this->Grid, this->Nodes, this->Crossings, this->Graph }, minimum, Execution(),
      this->Copies);
  }

  std::vector<Point3> PointsOfArc(Index arc) const
  {
    std::vector<Point3> points;
    for (Index i = 0; i < this->Graph.PointCount(arc); ++i)
    {
      points.push_back(this->Graph.PointAt(this->Graph.FirstPoint(arc) + i));
    }
    return points;
  }
  std::vector<Point3> PointsOfLoop(Index loop) const
  {
    return this->PointsOfArc(this->Graph.Arcs + loop);
  }
  std::vector<Point3> PointsOfContour(Index contour) const
  {
    std::vector<Point3> points;
    for (Index i = this->Copies.Offsets[contour]; i < this->Copies.Offsets[contour + 1]; ++i)
    {
      points.push_back({ this->Copies.Points[3 * i], this->Copies.Points[3 * i + 1],
        this->Copies.Points[3 * i + 2] });
    }
    return points;
  }

  IsolatedContours Copies;
};

double AreaSeenFrom(const std::vector<Point3>& points, int axis)
{
  const int u = FirstAxis(axis), v = SecondAxis(axis);
  double area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point3& p = points[i];
    const Point3& q = points[(i + 1) % points.size()];
    area += 0.5 * (p[u] * q[v] - q[u] * p[v]);
  }
  return area;
}

/// A curve with the axis of its slice; closed, or an arc with its nodes.
struct Curve
{
  std::vector<Point3> Points;
  int Axis;
  bool Closed;

  std::size_t Sides() const { return this->Points.size() - (this->Closed ? 0 : 1); }
  const Point3& At(std::size_t i) const { return this->Points[i % this->Points.size()]; }
};

/// Whether two curves on one plane have a point in common; or one curve with itself, beyond the
/// vertices of consecutive sides.
bool Touch(const Curve& a, const Curve& b)
{
  for (std::size_t i = 0; i < a.Sides(); ++i)
  {
    for (std::size_t j = &a == &b ? i + 1 : 0; j < b.Sides(); ++j)
    {
      const bool next = &a == &b && j == i + 1;
      const bool last = &a == &b && a.Closed && i == 0 && j + 1 == b.Sides();
      if (next || last)
      {
        // Consecutive sides must not fold back.
        const Point3& p = next ? a.At(i) : a.At(j);
        const Point3& q = next ? a.At(j) : a.At(0);
        const Point3& r = next ? a.At(j + 1) : a.At(1);
        const int u = FirstAxis(a.Axis), v = SecondAxis(a.Axis);
        const double along = (q[u] - p[u]) * (r[u] - q[u]) + (q[v] - p[v]) * (r[v] - q[v]);
        if (ExactTurn(p, q, r, a.Axis) == 0 && along < 0.0)
        {
          return true;
        }
        continue;
      }
      if (SegmentsMeet(a.At(i), a.At(i + 1), b.At(j), b.At(j + 1), a.Axis))
      {
        return true;
      }
    }
  }
  return false;
}

std::vector<Curve> LoopsOf(const LoopStages& stages)
{
  std::vector<Curve> loops;
  for (std::size_t i = 0; i < stages.Graph.Loops.size(); ++i)
  {
    loops.push_back(
      { stages.PointsOfLoop(static_cast<Index>(i)), stages.Graph.Loops[i].Axis, true });
  }
  return loops;
}

/// Loops are simple and touch neither each other nor an arc; they keep their directions and lie
/// strictly inside their faces.
void ExpectSound(const LoopStages& stages)
{
  const std::vector<Curve> loops = LoopsOf(stages);
  const auto& faces = stages.Graph.Loops;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    EXPECT_FALSE(Touch(loops[i], loops[i]));
    for (std::size_t j = i + 1; j < loops.size(); ++j)
    {
      EXPECT_FALSE(faces[i].Axis == faces[j].Axis && faces[i].Plane == faces[j].Plane &&
        Touch(loops[i], loops[j]));
    }
    const int axis = faces[i].Axis;
    for (const Point3& p : loops[i].Points)
    {
      EXPECT_EQ(p[axis], stages.Grid.Planes[axis][faces[i].Plane]);
      EXPECT_TRUE(stages.Grid.IsInside(FirstAxis(axis), faces[i].Slab[0], p[FirstAxis(axis)]));
      EXPECT_TRUE(stages.Grid.IsInside(SecondAxis(axis), faces[i].Slab[1], p[SecondAxis(axis)]));
    }
  }
  for (Index arc = 0; arc < stages.Graph.Arcs; ++arc)
  {
    if (stages.Crossings.IsRemoved(arc))
    {
      continue;
    }
    const GridEdge edge = stages.EdgeOf(arc);
    const bool first = stages.Crossings.Family[arc] == 0;
    const int axis = first ? FirstAxis(edge.Direction) : SecondAxis(edge.Direction);
    Curve curve{ stages.PointsOfArc(arc), axis, false };
    curve.Points.insert(curve.Points.begin(), stages.Graph.PointAt(stages.Nodes.NodeOf[arc]));
    curve.Points.push_back(stages.Graph.PointAt(stages.Nodes.NodeOf[stages.Crossings.Next[arc]]));
    for (std::size_t i = 0; i < loops.size(); ++i)
    {
      EXPECT_FALSE(axis == faces[i].Axis && (first ? edge.First : edge.Second) == faces[i].Plane &&
        Touch(curve, loops[i]));
    }
  }
  std::vector<int> used(loops.size(), 0);
  for (Index contour = 0; contour < stages.Copies.Count(); ++contour)
  {
    const Index loop = stages.Copies.Loop[contour];
    if (loop == IsolatedContours::None)
    {
      continue;
    }
    ++used[loop];
    EXPECT_EQ(stages.Copies.LeftOut[contour], 0);
    EXPECT_EQ(stages.Copies.Axis[contour], faces[loop].Axis);
    EXPECT_EQ(stages.Copies.Plane[contour], faces[loop].Plane);
    // Seen from above, the interior stays on the same side.
    EXPECT_GT(AreaSeenFrom(stages.PointsOfContour(contour), faces[loop].Axis) *
        AreaSeenFrom(loops[loop].Points, faces[loop].Axis),
      0.0);
  }
  EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](int n) { return n == 1; }));
}

const char* const FaceInTheMiddle = "1.2,1.2 1.2,1.8 1.8,1.8 1.8,1.2";
}

//----------------------------------------------------------------------------
TEST(IsolatedContours, ContourInsideAFaceBecomesALoop)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    SCOPED_TRACE(axis);
    // The wall of a cavity.
    const std::string name(1, "xyz"[axis]);
    const LoopStages stages(Cube() + name + "=2: " + FaceInTheMiddle);
    ASSERT_EQ(stages.Copies.Count(), 1);
    ASSERT_EQ(stages.Graph.Loops.size(), 1u);
    const Face& face = stages.Graph.Loops[0];
    EXPECT_EQ(face.Axis, axis);
    EXPECT_EQ(face.Plane, 1);
    EXPECT_EQ(face.Slab, (std::array<Index, 2>{ 1, 1 }));
    EXPECT_EQ(stages.PointsOfLoop(0), stages.PointsOfContour(0));
    EXPECT_EQ(CountLeftOut(stages.Copies), 0);
    EXPECT_LT(AreaSeenFrom(stages.PointsOfLoop(0), axis), 0.0);
    ExpectSound(stages);
  }
}

//----------------------------------------------------------------------------
TEST(IsolatedContours, NodesAndArcsStayAsTheyAre)
{
  const Stages without(Cube());
  const LoopStages with(Cube() + "z=1: " + FaceInTheMiddle + "\nz=1: 4,4 5,4 5,5");
  EXPECT_EQ(with.Graph.Nodes, without.Graph.Nodes);
  EXPECT_EQ(with.Graph.Arcs, without.Graph.Arcs);
  for (Index point = 0; point < without.Graph.Count(); ++point)
  {
    EXPECT_EQ(with.Graph.PointAt(point), without.Graph.PointAt(point));
  }
  EXPECT_EQ(with.Graph.Loops.size(), 2u);
}

//----------------------------------------------------------------------------
TEST(IsolatedContours, OneThatCrossesAnArcIsLeftOut)
{
  // The arc on z = 1 runs along x = 0.5 from y = 2 to y = 1: crossed by so little that the contours
  // are not united.
  const LoopStages stages(Cube() + "z=1: 0.499,1.4 0.6,1.4 0.6,1.6 0.499,1.6");
  ASSERT_EQ(stages.Copies.Count(), 1);
  EXPECT_EQ(stages.Copies.Loop[0], IsolatedContours::None);
  EXPECT_TRUE(stages.Graph.Loops.empty());
  EXPECT_EQ(CountLeftOut(stages.Copies), 1);
  // Close to it, or parted from it where they touched.
  for (const char* contour : { "0.5000001,1.5 0.6,1.4 0.6,1.6", "0.2,1.4 0.5,1.5 0.2,1.6" })
  {
    SCOPED_TRACE(contour);
    const LoopStages close(Cube() + "z=1: " + contour);
    EXPECT_EQ(close.Graph.Loops.size(), 1u);
    ExpectSound(close);
  }
}

//----------------------------------------------------------------------------
TEST(IsolatedContours, OfTwoThatCoincideOneIsLeftOut)
{
  const LoopStages stages("z=0: 0,0 2,0 2,2 0,2\nz=0: 0,0 1,0 2,0 2,2 0,2\nz=1: 0,0 1,0 1,1");
  // Before it gets here: a contour that was drawn twice counts once.
  ASSERT_EQ(stages.Copies.Count(), 2);
  ExpectSound(stages);
  EXPECT_EQ(stages.Graph.Loops.size(), 2u);
  EXPECT_EQ(CountLeftOut(stages.Copies), 0);
}

//----------------------------------------------------------------------------
/// The loop that encloses more stays.
TEST(IsolatedContours, OneThatTouchesALargerLoopIsLeftOut)
{
  // A vertex on a vertex: two ends of curves touch, which UncrossCurves cannot take apart.
  for (const bool largeFirst : { true, false })
  {
    const std::string large = "z=0: 0,0 4,0 4,4 0,4\n", small = "z=0: 0,0 -1,0 0,-1\n";
    const LoopStages stages(largeFirst ? large + small : small + large);
    ASSERT_EQ(stages.Copies.Count(), 2);
    ExpectSound(stages);
    EXPECT_NE(stages.Copies.Loop[largeFirst ? 0 : 1], IsolatedContours::None);
  }
}

//----------------------------------------------------------------------------
TEST(IsolatedContours, CrossingOnesAreTakenApart)
{
  const LoopStages two("z=0: 0,0 3,0 3,3 0,3\nz=0: 2.99,1.5 3.5,1 5,1 5,2 3.5,2");
  ASSERT_EQ(two.Copies.Count(), 2);
  EXPECT_EQ(two.Graph.Loops.size(), 2u);
  ExpectSound(two);
  // No vertex is lost.
  EXPECT_EQ(two.PointsOfLoop(0).size() + two.PointsOfLoop(1).size(), 9u);

  const LoopStages eight("z=0: 0,0 3,2 3,0.1 0,1.5");
  ASSERT_EQ(eight.Copies.Count(), 1);
  EXPECT_EQ(eight.Graph.Loops.size(), 1u);
  EXPECT_EQ(eight.PointsOfLoop(0).size(), 3u) << "as drawn, the clockwise lobe bounds nothing";
  ExpectSound(eight);
}

//----------------------------------------------------------------------------
TEST(IsolatedContours, NestedLoopsOfOneFaceAllStay)
{
  const LoopStages stages("z=0: 0,0 9,0 9,9 0,9\nz=0: 1,1 1,8 8,8 8,1\nz=0: 2,2 7,2 7,7 2,7");
  ASSERT_EQ(stages.Graph.Loops.size(), 3u);
  for (Index i = 0; i < 3; ++i)
  {
    EXPECT_EQ(stages.Copies.Loop[i], i);
    EXPECT_EQ(stages.PointsOfLoop(i), stages.PointsOfContour(i));
  }
  ExpectSound(stages);
}

//----------------------------------------------------------------------------
/// A coordinate on a plane belongs to its upper side: such vertices move off it.
TEST(IsolatedContours, VerticesOnTheBorderOfTheFaceMoveInside)
{
  const LoopStages stages(Cube() + "z=2: 1,1 1,1.5 1.5,1.5 1.5,1");
  ASSERT_EQ(stages.Graph.Loops.size(), 1u);
  ExpectSound(stages);
  const std::vector<Point3> points = stages.PointsOfLoop(0);
  ASSERT_EQ(points.size(), 4u);
  const double margin = stages.Grid.Margin(0, 1);
  EXPECT_EQ(points[0], (Point3{ 1.0 + margin, 1.0 + margin, 2.0 }));
  EXPECT_EQ(points[2], (Point3{ 1.5, 1.5, 2.0 }));
}

//----------------------------------------------------------------------------
TEST(IsolatedContours, SmallOnesAreLeftOut)
{
  // Diagonals of 5 and 1.3.
  const std::string text = "z=0: 0,0 3,0 3,4 0,4\nz=0: 5,5 5.5,5 5.5,6.2";
  for (const auto& c : { std::make_pair(0.0, 2u), std::make_pair(1.3 - 1e-9, 2u),
         std::make_pair(1.3 + 1e-9, 1u), std::make_pair(5.0 + 1e-9, 0u) })
  {
    const LoopStages stages(text, c.first);
    EXPECT_EQ(stages.Graph.Loops.size(), c.second) << c.first;
    EXPECT_EQ(CountLeftOut(stages.Copies), 2 - static_cast<Index>(c.second));
  }
  // The sizes of the bounding boxes of three-dimensional contours on other axes.
  EXPECT_EQ(LoopStages("x=0: 0,0 3,0 3,4", 4.9).Graph.Loops.size(), 1u);
  EXPECT_EQ(LoopStages("y=0: 0,0 3,0 3,4", 5.1).Graph.Loops.size(), 0u);
}

//----------------------------------------------------------------------------
TEST(IsolatedContours, FormerLoopsAreReplaced)
{
  LoopStages stages(Cube() + "z=2: " + FaceInTheMiddle + "\nz=1: 4,4 5,4 5,5");
  const NodeGraph before = stages.Graph;
  EXPECT_EQ(before.Loops.size(), 2u);
  stages.Embed(0.0);
  EXPECT_EQ(stages.Graph.Points, before.Points);
  EXPECT_EQ(stages.Graph.Offsets, before.Offsets);
  EXPECT_EQ(stages.Graph.Loops.size(), 2u);
  stages.Embed(1.0);
  EXPECT_EQ(stages.Graph.Loops.size(), 1u);
  stages.Embed(9.0);
  EXPECT_EQ(stages.Graph.Loops.size(), 0u);
  EXPECT_EQ(stages.Graph.Points, Stages(Cube()).Graph.Points);
}

//----------------------------------------------------------------------------
/// Parts that the other slices contradict are no contours of their own.
TEST(IsolatedContours, PartsThatWereCutOffAreNoLoops)
{
  // The spike of the z-slice through x = 2 is cut off where the x-slice has nothing.
  const LoopStages spike("x=0: -1,-1 1,-1 1,1 -1,1\nx=2: 5,-1 6,-1 6,1 5,1\n"
                         "z=0: -1,-1 1,-1 1,0.2 3,0.3 3.1,0.5 3,0.7 1,0.8 1,1 -1,1\n"
                         "y=0: -1,-1 1,-1 1,1 -1,1\nz=0: 1.5,5 2.5,5 2.5,6 1.5,6\n");
  ASSERT_EQ(spike.Copies.Count(), 1);
  EXPECT_EQ(spike.Copies.LeftOut[0], 1);
  EXPECT_EQ(spike.Copies.Loop[0], IsolatedContours::None);

  std::uint64_t cut = 0, kept = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    const Input input = RandomContradictoryInput(seed);
    const Stages stages(input);
    IsolatedContours copies = CopyIsolated(stages.Isolated, stages.Set, stages.Crossings);
    NodeGraph graph = stages.Graph;
    GridCrossings crossings = stages.Crossings;
    EmbedIsolated({ stages.Grid, stages.Nodes, crossings, graph }, 0.0, Execution(), copies);
    for (std::size_t i = 0; i < stages.Isolated.size(); ++i)
    {
      if (stages.Isolated[i].FirstRun != GridCrossings::None)
      {
        cut += copies.LeftOut[i];
        kept += 1 - copies.LeftOut[i];
        EXPECT_TRUE(copies.LeftOut[i] == 0 || copies.Loop[i] == IsolatedContours::None);
      }
    }
  }
  EXPECT_GT(cut, 0u);
  EXPECT_GT(kept, 0u);
}

//----------------------------------------------------------------------------
/// The z-slice grazes x = 2, where the x-slice has nothing but something else far away.
TEST(IsolatedContours, OfAContourThatGrazedAPlaneTheRestStays)
{
  const LoopStages stages("z=0: 1,0 1.9,-0.2 2.1,0.3 2.2,0.5 2.1,0.7 1.9,1.2 1,1\n"
                          "x=2: 5,-1 6,-1 6,1 5,1\nz=0: 1.5,5 2.5,5 2.5,6 1.5,6\n");
  ASSERT_EQ(stages.Copies.Count(), 2);
  ASSERT_EQ(stages.Graph.Loops.size(), 1u);
  EXPECT_EQ(CountLeftOut(stages.Copies), 1);
  EXPECT_EQ(stages.PointsOfLoop(0).size(), 4u);
  ExpectSound(stages);
  // Half of it beyond the plane is no bulge: nobody knows which half is right.
  const LoopStages halves("z=0: 1,0 1.9,-0.2 2.1,-0.2 3,0 3,1 2.1,1.2 1.9,1.2 1,1\n"
                          "x=2: 5,-1 6,-1 6,1 5,1\nz=0: 1.5,5 2.5,5 2.5,6 1.5,6\n");
  EXPECT_EQ(halves.Copies.Count(), 2);
  EXPECT_TRUE(halves.Graph.Loops.empty());
}

//----------------------------------------------------------------------------
/// Random triangles to hexagons in the faces of a cube: what touches nothing stays as it is.
TEST(IsolatedContours, RandomPolygonsAsBruteForceHasThem)
{
  Random random(5);
  int kept = 0, untouched = 0, contours = 0;
  for (int run = 0; run < 150; ++run)
  {
    SCOPED_TRACE(run);
    std::string text = Cube();
    const int count = 1 + static_cast<int>(random.Below(6));
    // On a lattice in every other run, so that coincidences are frequent.
    const bool crossings = run % 2 == 0;
    for (int i = 0; i < count; ++i)
    {
      // The face x in (1, 2), y < 1, where an arc runs along y = 0.5; or x > 2, y > 2.
      const bool corner = random.Chance(0.3);
      text += random.Chance(0.5) ? "z=1:" : "z=2:";
      const std::size_t vertices = 3 + random.Below(4);
      for (std::size_t v = 0; v < vertices; ++v)
      {
        const auto number = [&]
        {
          return crossings ? 0.125 * static_cast<double>(1 + random.Below(7))
                           : random.Uniform(0.01, 0.99);
        };
        const double x = (corner ? 2.0 : 1.0) + number();
        const double y = (corner ? 2.0 : 0.0) + number();
        text += " " + std::to_string(x) + "," + std::to_string(y);
      }
      text += "\n";
    }
    const LoopStages stages(text);
    ExpectSound(stages);
    contours += stages.Copies.Count();
    kept += static_cast<int>(stages.Graph.Loops.size());
    std::vector<Curve> curves;
    for (Index i = 0; i < stages.Copies.Count(); ++i)
    {
      curves.push_back({ stages.PointsOfContour(i), stages.Copies.Axis[i], true });
    }
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      // The four sides of the square that bounds the cube.
      bool touches = Touch(curves[i], curves[i]);
      const double z = curves[i].Points[0][2];
      const Curve square{ { { 0.5, 0.5, z }, { 2.5, 0.5, z }, { 2.5, 2.5, z }, { 0.5, 2.5, z } }, 2,
        true };
      touches |= Touch(curves[i], square);
      for (std::size_t j = 0; j < curves.size(); ++j)
      {
        touches |= i != j && curves[j].Points[0][2] == z && Touch(curves[i], curves[j]);
      }
      const double area = AreaSeenFrom(curves[i].Points, 2);
      if (!touches && area != 0.0)
      {
        ++untouched;
        const Index loop = stages.Copies.Loop[i];
        ASSERT_NE(loop, IsolatedContours::None);
        EXPECT_EQ(stages.PointsOfLoop(loop), curves[i].Points);
      }
    }
  }
  EXPECT_GT(untouched, 15);
  EXPECT_GT(kept, untouched);
  EXPECT_LT(kept, contours);
}
