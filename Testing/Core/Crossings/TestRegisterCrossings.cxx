// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/RegisterCrossings.h"

#include "Support/Random.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A crossing in words: the plane crossed, where along it, upwards or downwards.
struct Seen
{
  char Axis; ///< of the plane crossed
  Index Plane;
  double Position;
  int Direction;
  Index Slab;

  bool operator==(const Seen& other) const
  {
    return Axis == other.Axis && Plane == other.Plane && Position == other.Position &&
      Direction == other.Direction && Slab == other.Slab;
  }
};

std::ostream& operator<<(std::ostream& os, const Seen& seen)
{
  return os << seen.Axis << seen.Plane << " at " << seen.Position << " direction " << seen.Direction
            << " slab " << seen.Slab;
}

/// One z-slice and planes of x and y.
struct Walk
{
  Walk(const std::string& contours, std::vector<double> xs, std::vector<double> ys)
    : Set(ParseContours(contours))
    , Grid(BuildSpatialGrid(Set, 0.0))
  {
    this->Grid.Planes[0] = std::move(xs);
    this->Grid.Planes[1] = std::move(ys);
    this->Crossings = RegisterCrossings(this->Set, this->Grid, Execution(), this->Isolated);
  }

  Seen At(Index c) const
  {
    const GridEdge edge = GridEdgeCode(this->Grid).Decode(this->Crossings.Edge[c]);
    // On a z-slice, grid lines along y lie on x-planes (family 0) and those along x on y-planes.
    const bool crossesX = edge.Direction == 1;
    EXPECT_EQ(this->Crossings.Family[c], crossesX ? 0 : 1);
    return { crossesX ? 'x' : 'y', crossesX ? edge.Second : edge.First, this->Crossings.Position[c],
      this->Crossings.Direction[c], edge.Slab };
  }

  /// All crossings in the contour's order, from its first vertex on.
  std::vector<Seen> All() const
  {
    std::vector<Seen> all;
    for (Index c = 0; c < this->Crossings.Count(); ++c)
    {
      all.push_back(this->At(c));
    }
    return all;
  }

  Contours Set;
  SpatialGrid Grid;
  GridCrossings Crossings;
  std::vector<IsolatedLoop> Isolated;
};
}

//----------------------------------------------------------------------------
TEST(RegisterCrossings, SquareOverOneGridVertex)
{
  const Walk walk("z=0: -1,-1 1,-1 1,1 -1,1", { 0.0 }, { 0.25 });
  EXPECT_EQ(walk.All(),
    (std::vector<Seen>{ { 'x', 0, -1.0, 1, 0 }, { 'y', 0, 1.0, 1, 1 }, { 'x', 0, 1.0, -1, 1 },
      { 'y', 0, -1.0, -1, 0 } }));
  EXPECT_EQ(walk.Crossings.Next, (std::vector<Index>{ 1, 2, 3, 0 }));
  EXPECT_EQ(walk.Crossings.Previous, (std::vector<Index>{ 3, 0, 1, 2 }));
  // Each arc has one corner of the square.
  EXPECT_EQ(walk.Crossings.RunFirst, (std::vector<Index>{ 1, 2, 3, 0 }));
  EXPECT_EQ(walk.Crossings.RunCount, (std::vector<Index>{ 1, 1, 1, 1 }));
  EXPECT_TRUE(walk.Isolated.empty());
}

//----------------------------------------------------------------------------
TEST(RegisterCrossings, LongSegmentCrossesManyPlanesInOrder)
{
  const Walk walk("z=0: 0,0 8,4 0,8", { 1.0, 3.0 }, { 1.0 });
  const std::vector<Seen> all = walk.All();
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[0], (Seen{ 'x', 0, 0.5, 1, 0 }));
  EXPECT_EQ(all[1], (Seen{ 'y', 0, 2.0, 1, 1 }));
  EXPECT_EQ(all[2], (Seen{ 'x', 1, 1.5, 1, 1 }));
  EXPECT_EQ(all[3], (Seen{ 'x', 1, 6.5, -1, 1 }));
  EXPECT_EQ(all[4], (Seen{ 'x', 0, 7.5, -1, 1 }));
  EXPECT_EQ(all[5], (Seen{ 'y', 0, 0.0, -1, 0 }));
}

//----------------------------------------------------------------------------
TEST(RegisterCrossings, ContourWithinAFaceIsIsolated)
{
  const Walk walk("z=0: 5,5 6,5 6,6; z=0: 0.1,0.1 0.2,0.1 0.2,0.2", { 0.0, 1.0 }, { 0.0, 1.0 });
  EXPECT_EQ(walk.Crossings.Count(), 0);
  ASSERT_EQ(walk.Isolated.size(), 2u);
  EXPECT_EQ(walk.Isolated[0].Contour, 0);
  EXPECT_EQ(walk.Isolated[1].Contour, 1);
  EXPECT_EQ(walk.Isolated[1].FirstRun, GridCrossings::None);
}

//----------------------------------------------------------------------------
TEST(RegisterCrossings, VertexOnAPlaneLiesAboveIt)
{
  // From below the vertex on the plane is reached across it; touching from above is no crossing.
  EXPECT_EQ(Walk("z=0: 0,-1 1,1 -1,1", { 9.0 }, { 1.0 }).All(),
    (std::vector<Seen>{ { 'y', 0, 1.0, 1, 0 }, { 'y', 0, -1.0, -1, 0 } }));
  EXPECT_TRUE(Walk("z=0: 0,1 1,2 -1,2", { 9.0 }, { 1.0 }).All().empty());
  // Touching from below is two crossings at the same place.
  EXPECT_EQ(Walk("z=0: 0,1 -1,0 1,0", { 9.0 }, { 1.0 }).All(),
    (std::vector<Seen>{ { 'y', 0, 0.0, -1, 0 }, { 'y', 0, 0.0, 1, 0 } }));
}

//----------------------------------------------------------------------------
TEST(RegisterCrossings, SegmentsAlongAPlaneLieAboveIt)
{
  EXPECT_EQ(Walk("z=0: 0,0 4,0 4,2 0,2", { 9.0 }, { 0.0, 1.0 }).All().size(), 2u);
  EXPECT_EQ(Walk("z=0: 0,0 4,0 4,2 0,2", { 9.0 }, { 1.0, 2.0 }).All().size(), 4u);
}

//----------------------------------------------------------------------------
/// The planes count as moved down, x more than y: x is met before y on the way up a diagonal.
TEST(RegisterCrossings, ThroughAGridVertex)
{
  const Walk up("z=0: -1,-1 1,1 -9,1", { 0.0 }, { 0.0 });
  ASSERT_GE(up.Crossings.Count(), 2);
  EXPECT_EQ(up.At(0), (Seen{ 'x', 0, 0.0, 1, 0 }));
  EXPECT_EQ(up.At(1), (Seen{ 'y', 0, 0.0, 1, 1 }));
  const Walk down("z=0: 1,1 -1,-1 9,-1", { 0.0 }, { 0.0 });
  ASSERT_GE(down.Crossings.Count(), 2);
  EXPECT_EQ(down.At(0), (Seen{ 'y', 0, 0.0, -1, 1 }));
  EXPECT_EQ(down.At(1), (Seen{ 'x', 0, 0.0, -1, 0 }));
  const Walk across("z=0: -1,1 1,-1 1,9", { 0.0 }, { 0.0 });
  ASSERT_GE(across.Crossings.Count(), 2);
  EXPECT_EQ(across.At(0), (Seen{ 'x', 0, 0.0, 1, 1 }));
  EXPECT_EQ(across.At(1), (Seen{ 'y', 0, 0.0, -1, 1 }));
}

//----------------------------------------------------------------------------
namespace
{
/// A polygon of small integers, most of whose vertices and crossings lie on the planes 0 to 6.
std::string IntegerPolygon(std::uint64_t seed, std::vector<std::array<long, 2>>& polygon)
{
  Random random(seed);
  std::string text = "z=0:";
  const std::size_t size = 3 + random.Below(6);
  while (polygon.size() < size)
  {
    const long u = static_cast<long>(random.Below(9)) - 1;
    const long v = static_cast<long>(random.Below(9)) - 1;
    if (polygon.empty() || polygon.back() != std::array<long, 2>{ u, v })
    {
      polygon.push_back({ u, v });
      text += " " + std::to_string(u) + "," + std::to_string(v);
    }
  }
  return text;
}

/// Crossings with the planes across axis `a`, each as plane, 840 times the position, direction.
std::vector<std::array<long, 3>> CrossingsByExactArithmetic(
  const std::vector<std::array<long, 2>>& polygon, int a, long planes)
{
  std::vector<std::array<long, 3>> crossings;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const auto& p = polygon[i];
    const auto& q = polygon[(i + 1) % polygon.size()];
    for (long plane = 0; plane < planes; ++plane)
    {
      if ((p[a] >= plane) != (q[a] >= plane))
      {
        // 840 is a multiple of every difference up to 8.
        const long along =
          840 * p[1 - a] + 840 / (q[a] - p[a]) * (plane - p[a]) * (q[1 - a] - p[1 - a]);
        crossings.push_back({ plane, along, q[a] > p[a] ? 1 : -1 });
      }
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}
}

TEST(RegisterCrossings, AsExactArithmeticOnIntegers)
{
  const std::vector<double> planes{ 0, 1, 2, 3, 4, 5, 6 };
  std::size_t crossings = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed)
  {
    SCOPED_TRACE(seed);
    std::vector<std::array<long, 2>> polygon;
    const Walk walk(IntegerPolygon(seed, polygon), planes, planes);
    for (int axis = 0; axis < 2; ++axis)
    {
      std::vector<std::array<long, 3>> found;
      for (const Seen& seen : walk.All())
      {
        if (seen.Axis == "xy"[axis])
        {
          found.push_back({ seen.Plane, std::lround(840 * seen.Position), seen.Direction });
          EXPECT_NEAR(840 * seen.Position, std::lround(840 * seen.Position), 1e-9);
        }
      }
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, CrossingsByExactArithmetic(polygon, axis, 7));
      crossings += found.size();
    }
  }
  EXPECT_GT(crossings, 10000u);
}

//----------------------------------------------------------------------------
/// Every arc stays on one face: what it crosses next borders the face that it entered.
TEST(RegisterCrossings, ConsecutiveCrossingsBorderTheSameFace)
{
  const std::vector<double> planes{ 0, 1, 2, 3, 4, 5, 6 };
  for (std::uint64_t seed = 0; seed < 2000; ++seed)
  {
    SCOPED_TRACE(seed);
    std::vector<std::array<long, 2>> polygon;
    const Walk walk(IntegerPolygon(seed, polygon), planes, planes);
    for (Index c = 0; c < walk.Crossings.Count(); ++c)
    {
      const Seen from = walk.At(c), to = walk.At(walk.Crossings.Next[c]);
      // Slab across the crossed plane after `from` and before `to`; and the slab along it.
      const Index after = from.Plane + (from.Direction > 0 ? 1 : 0);
      const Index before = to.Plane + (to.Direction > 0 ? 0 : 1);
      EXPECT_EQ(from.Axis == to.Axis ? after : from.Slab, before) << from << " then " << to;
      EXPECT_EQ(from.Axis == to.Axis ? from.Slab : after, to.Slab) << from << " then " << to;
      EXPECT_EQ(walk.Crossings.Previous[walk.Crossings.Next[c]], c);
    }
  }
}

//----------------------------------------------------------------------------
TEST(RegisterCrossings, PositionsLieOnTheirEdgesAndRunsCoverTheContours)
{
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    SCOPED_TRACE(seed);
    std::vector<Index> vertices(stages.Set.Count(), 0);
    for (Index c = 0; c < stages.Registered.Count(); ++c)
    {
      const GridEdge edge = GridEdgeCode(stages.Grid).Decode(stages.Registered.Edge[c]);
      const double x = stages.Registered.Position[c];
      EXPECT_EQ(stages.Grid.Clamp(edge.Direction, edge.Slab, x), x);
      vertices[stages.Registered.RunContour[c]] += stages.Registered.RunCount[c];
    }
    for (Index i = 0; i < stages.Set.Count(); ++i)
    {
      EXPECT_TRUE(vertices[i] == 0 || vertices[i] == stages.Set.Size(i));
    }
  }
}

//----------------------------------------------------------------------------
TEST(FileOnEdges, GroupsByEdgeThenFamilyThenPosition)
{
  GridCrossings crossings;
  crossings.Resize(6);
  crossings.Edge = { 7, 3, 7, 7, 3, 9 };
  crossings.Family = { 1, 0, 0, 0, 0, 0 };
  crossings.Position = { 0.0, 5.0, 2.0, 1.0, 5.0, 0.0 };
  crossings.Next = { 0, 0, 0, 0, 0, GridCrossings::Removed };
  const EdgeRegister edges = FileOnEdges(crossings);
  EXPECT_EQ(edges.Offsets, (std::vector<Index>{ 0, 2, 5 }));
  EXPECT_EQ(edges.Crossing, (std::vector<Index>{ 1, 4, 3, 2, 0 }));
}

//----------------------------------------------------------------------------
TEST(FileOnEdges, OfNothingIsEmpty) { EXPECT_EQ(FileOnEdges(GridCrossings()).Count(), 0); }

//----------------------------------------------------------------------------
TEST(CrossingPoint, IsThePointOfTheGridLine)
{
  SpatialGrid grid;
  grid.Planes = { std::vector<double>{ 1, 2 }, std::vector<double>{ 30, 40 },
    std::vector<double>{ 500, 600 } };
  const GridEdgeCode code(grid);
  EXPECT_EQ(CrossingPoint(grid, code, code.Encode({ 0, 1, 0, 1 }), 1.5), (Point3{ 1.5, 40, 500 }));
  EXPECT_EQ(CrossingPoint(grid, code, code.Encode({ 1, 0, 1, 2 }), 99.0), (Point3{ 2, 99, 500 }));
  EXPECT_EQ(CrossingPoint(grid, code, code.Encode({ 2, 1, 1, 0 }), 7.0), (Point3{ 2, 40, 7 }));
}
