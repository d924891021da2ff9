// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/LightenArcs.h"

#include "Core/Base/TriangleDistance.h"
#include "Core/Base/Vectors.h"
#include "Core/Graph/CheckGraph.h"
#include "Core/Reconstruct.h"
#include "Support/SliceSolid.h"
#include "Support/SmoothSolids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A part of the unit circle, counter-clockwise.
std::vector<Point2> Circle(double angle, int sides)
{
  std::vector<Point2> curve;
  for (int i = 0; i <= sides; ++i)
  {
    curve.push_back({ std::cos(angle * i / sides), std::sin(angle * i / sides) });
  }
  return curve;
}

/// The tables of a reconstruction with few triangles before and after LightenArcs.
struct Before
{
  explicit Before(const SmoothSolid& solid, double accuracy)
  {
    Options options;
    options.Patching.Accuracy = accuracy;
    Reconstruct(SliceSolid(solid, EqualPlanes(solid, { 10, 10, 10 }), 12, InPlaneGrid::Aligned),
      options, Execution(),
      [this](Stage stage, const StageTables&, const Reconstruction& result)
      {
        if (stage == Stage::EstimateNormals)
        {
          this->Result = result;
        }
      });
    this->Light = LightenArcs({ GeometryOf(this->Result), this->Result.Cells,
                                this->Result.Surface.Meshes, this->Result.Normals },
      accuracy, Execution());
  }

  Reconstruction Result;
  LightGraph Light;
};
}

//----------------------------------------------------------------------------
TEST(LightenArcs, SmoothCurvesGetSidesOfEqualLength)
{
  const double angle = 1.2;
  const std::vector<Point2> curve = Circle(angle, 60);
  for (const double tolerance : { 0.1, 0.02, 0.005 })
  {
    const LightCurve light = LightenCurve(curve, tolerance);
    // As few as the height of a circle's part over its chord allows.
    const double sides = std::ceil(angle / (2.0 * std::acos(1.0 - tolerance)) - 1e-9);
    ASSERT_EQ(light.Sides.size(), static_cast<std::size_t>(sides));
    const double height = 1.0 - std::cos(0.5 * angle / sides);
    for (const CurveDeviation& side : light.Sides)
    {
      EXPECT_LE(side.Farthest, tolerance);
      EXPECT_NEAR(side.Height, height, 0.02 * height); // to the right: outside of the circle
    }
    EXPECT_EQ(light.Places.front().Place, curve.front());
    EXPECT_EQ(light.Places.back().Place, curve.back());
  }
}

//----------------------------------------------------------------------------
TEST(LightenArcs, CornersAreVertices)
{
  const std::vector<Point2> corner{ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 3, 0.5 }, { 3, 1 } };
  const LightCurve light = LightenCurve(corner, 0.01);
  ASSERT_EQ(light.Places.size(), 3u);
  EXPECT_EQ(light.Places[1].Place, (Point2{ 3, 0 }));
}

//----------------------------------------------------------------------------
/// A side may fall on two vertices only: there is nothing to leave out, and no curve.
TEST(LightenArcs, OneSideStays)
{
  const LightCurve light = LightenCurve({ { 0, 0 }, { 1, 2 } }, 0.1);
  ASSERT_EQ(light.Sides.size(), 1u);
  EXPECT_EQ(light.Sides[0].Farthest, 0.0);
  EXPECT_EQ(light.Sides[0].Height, 0.0);
}

//----------------------------------------------------------------------------
TEST(LightenArcs, ArcsAreEmbeddedAndContoursWithinTheTolerance)
{
  for (const SmoothSolid& solid : AllSmoothSolids())
  {
    SCOPED_TRACE(solid.Name);
    const double accuracy = 0.02;
    const Before before(solid, accuracy);
    const NodeGraph &all = before.Result.Graph, &light = before.Light.Graph;
    EXPECT_LT(light.Count(), all.Count());
    ASSERT_EQ(light.Nodes, all.Nodes);
    EXPECT_EQ(before.Light.Normals.Normals.size(), static_cast<std::size_t>(3 * light.Count()));
    NodePoints nodes = before.Result.Nodes;
    nodes.Position = before.Light.Positions;
    const GridCrossings& crossings = before.Result.Crossings;
    EXPECT_EQ(CheckEmbedding(before.Result.Grid, crossings, nodes, light), "");
    const double most = accuracy * 1.01 *
      std::max({ before.Result.Grid.MeanSpacing(0), before.Result.Grid.MeanSpacing(1),
        before.Result.Grid.MeanSpacing(2) });
    for (Index arc = 0; arc < all.Arcs; ++arc)
    {
      std::vector<Point3> sides{ light.PointAt(nodes.NodeOf[arc]) };
      for (Index i = 0; i < light.PointCount(arc); ++i)
      {
        sides.push_back(light.PointAt(light.FirstPoint(arc) + i));
      }
      sides.push_back(light.PointAt(nodes.NodeOf[crossings.Next[arc]]));
      for (Index i = 0; i < all.PointCount(arc); ++i)
      {
        const Point3 vertex = all.PointAt(all.FirstPoint(arc) + i);
        double nearest = HUGE_VAL;
        for (std::size_t k = 1; k < sides.size(); ++k)
        {
          nearest = std::min(nearest, SquaredDistanceToSegment(vertex, sides[k - 1], sides[k]));
        }
        ASSERT_LE(std::sqrt(nearest), most);
      }
    }
  }
}

//----------------------------------------------------------------------------
/// On a convex solid, few vertices lie outside, so that the middles of sides lie about on the
/// surface.
TEST(LightenArcs, VerticesAreMovedToTheOutsideOfBulges)
{
  const SmoothSolid solid = SmoothEllipsoid();
  const Before before(solid, 0.05);
  const NodeGraph& light = before.Light.Graph;
  double outside = 0.0, inside = 0.0;
  for (Index node = 0; node < light.Nodes; ++node)
  {
    Point3 normal;
    const Point3 here = light.PointAt(node);
    outside += Dot(here - solid.Project(here, normal), normal) / light.Nodes;
  }
  const GridCrossings& crossings = before.Result.Crossings;
  for (Index arc = 0; arc < light.Arcs; ++arc)
  {
    Point3 normal;
    const Point3 to = light.PointCount(arc) > 0
      ? light.PointAt(light.FirstPoint(arc))
      : light.PointAt(before.Result.Nodes.NodeOf[crossings.Next[arc]]);
    const Point3 middle = Between(light.PointAt(before.Result.Nodes.NodeOf[arc]), to, 0.5);
    inside += Dot(solid.Project(middle, normal) - middle, normal) / light.Arcs;
  }
  EXPECT_GT(outside, 0.0);
  EXPECT_LT(std::abs(inside), 0.5 * outside);
}
