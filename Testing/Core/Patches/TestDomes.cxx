// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Reconstruct.h"

#include "Core/Base/Vectors.h"
#include "Core/Patches/Domes.h"
#include "Support/CheckSurface.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SliceSolid.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Top = 0.97; ///< the last z-plane; above it is the top of the unit ball

/// The unit ball, or all but a ball-shaped cavity in a cube.
Reconstruction CappedBall(bool cavity, PatchMethod method)
{
  Solid solid;
  solid.Low = { -1.6, -1.6, -1.6 };
  solid.High = { 1.6, 1.6, 1.6 };
  solid.Function = [cavity](const Point3& p)
  {
    const double ball = Length(p) - 1.0;
    const double cube = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) - 1.5;
    return cavity ? std::max(cube, -ball) : ball;
  };
  const PlaneSets planes{ { { -1.1, -0.7, -0.3, 0.4, 0.8, 1.2 },
    { -1.2, -0.8, -0.4, 0.3, 0.7, 1.1 }, { -1.25, -0.9, -0.6, -0.2, 0.2, 0.55, Top, 1.3 } } };
  Options options;
  options.Patching.Method = method;
  return Reconstruct(SliceSolid(solid, planes, 8, InPlaneGrid::Aligned), options, Execution());
}

/// Of the loop at the top.
Index DomeOf(const Reconstruction& result)
{
  const CycleGeometry geometry = GeometryOf(result);
  for (Index cycle = 0; cycle < result.Cycles.Count(); ++cycle)
  {
    if (geometry.IsLoop(cycle) && geometry.FirstArc(cycle).Above)
    {
      return cycle;
    }
  }
  return -1;
}
}

//----------------------------------------------------------------------------
/// The loop has a radius of 0.24, the dome only a height of 0.03.
TEST(Domes, EndWhereTheSurfaceBelowLetsThem)
{
  for (const bool cavity : { false, true })
  {
    for (const PatchMethod method : { PatchMethod::Fan, PatchMethod::Smooth })
    {
      const Reconstruction result = CappedBall(cavity, method);
      const Index dome = DomeOf(result);
      ASSERT_GE(dome, 0);
      const double* apex = result.Surface.CentralPoints.data() + 3 * dome;
      EXPECT_NEAR(apex[2], 1.0, 0.01);
    }
  }
}

//----------------------------------------------------------------------------
TEST(Domes, TiltIsThatOfTheSurface)
{
  for (const bool cavity : { false, true })
  {
    const Reconstruction result = CappedBall(cavity, PatchMethod::Smooth);
    const CycleGeometry geometry = GeometryOf(result);
    const Index dome = DomeOf(result);
    ASSERT_GE(dome, 0);
    const std::vector<double> tilts =
      TiltOfDomes(geometry, result.Surface.CentralPoints, result.Surface.Meshes);
    EXPECT_NEAR(tilts[geometry.LoopOf(dome)], cavity ? -Top : Top, 0.02);
  }
}

//----------------------------------------------------------------------------
/// All points inside the patch, not the apex alone.
TEST(Domes, AreSmoothPatches)
{
  const Reconstruction result = CappedBall(false, PatchMethod::Smooth);
  const InnerPatches& inner = result.Surface.Inner;
  const Index dome = DomeOf(result);
  const auto at = std::lower_bound(inner.Cycle.begin(), inner.Cycle.end(), dome);
  ASSERT_TRUE(at != inner.Cycle.end() && *at == dome);
  const std::size_t i = static_cast<std::size_t>(at - inner.Cycle.begin());
  for (auto p = inner.PointOffsets[i]; p < inner.PointOffsets[i + 1]; ++p)
  {
    EXPECT_NEAR(Length(inner.PointAt(p)), 1.0, 0.01);
    EXPECT_GT(inner.PointAt(p)[2], Top);
  }
  EXPECT_TRUE(CheckSurface(MeshOf(result)).IsClosedManifold());
}

//----------------------------------------------------------------------------
TEST(Domes, AreRoundWhereNothingIsKnown)
{
  Options options;
  options.Several = SeveralCycles::Discs;
  const Reconstruction result =
    Reconstruct(ParsePieces("z=0: 0,0 2,0 2,2 0,2; z=9: 0,0 2,0 2,2 0,2"), options, Execution());
  const CycleGeometry geometry = GeometryOf(result);
  for (Index cycle = 0; cycle < result.Cycles.Count(); ++cycle)
  {
    const HalfArc& half = geometry.FirstArc(cycle);
    const double plane = geometry.LoopOf(cycle) == 0 ? 0.0 : 9.0;
    const double height = result.Surface.CentralPoints[3 * cycle + 2] - plane;
    EXPECT_GT(half.Above ? height : -height, 1.0);
    EXPECT_LT(std::abs(height), 1.4143);
  }
  for (const double tilt :
    TiltOfDomes(geometry, result.Surface.CentralPoints, result.Surface.Meshes))
  {
    EXPECT_EQ(tilt, 0.0); // the surface is upright: domes on both sides
  }
}

//----------------------------------------------------------------------------
namespace
{
/// How far the surface of a solid cut at -2.5, -1.5 to 2.5 along one axis reaches beyond the last
/// slices, below and above.
std::array<double, 2> HeightsBeyondSlices(
  int axis, const std::function<double(double along, double u, double v)>& function)
{
  Solid solid;
  solid.Low = { -4.0, -4.0, -4.0 };
  solid.High = { 4.0, 4.0, 4.0 };
  solid.Function = [&](const Point3& p)
  { return function(p[axis], p[FirstAxis(axis)], p[SecondAxis(axis)]); };
  PlaneSets planes;
  planes[axis] = { -2.5, -1.5, -0.5, 0.5, 1.5, 2.5 };
  const Reconstruction result =
    Reconstruct(SliceSolid(solid, planes, 60, InPlaneGrid::Free), Options(), Execution());
  EXPECT_EQ(result.Topology.Components, 1);
  std::array<double, 2> heights{ 0.0, 0.0 };
  for (const Point3& p : MeshOf(result).Points)
  {
    heights[0] = std::max(heights[0], -2.5 - p[axis]);
    heights[1] = std::max(heights[1], p[axis] - 2.5);
  }
  return heights;
}
}

/// Sections that do not shrink end at the last slice; those of balls and at tips of cones in domes.
TEST(Domes, AreFlatWhereTheLastTwoSectionsSaySo)
{
  constexpr double flat = 2.0 * 1e-3, least = 0.3, most = 0.5;
  for (int axis = 0; axis < 3; ++axis)
  {
    SCOPED_TRACE(axis);
    const auto box = HeightsBeyondSlices(axis,
      [](double w, double u, double v) {
        return std::max({ std::abs(w) - 2.6, std::abs(u) - 1.7, std::abs(v) - 1.2 });
      });
    EXPECT_LT(std::max(box[0], box[1]), flat);
    const auto cylinder = HeightsBeyondSlices(axis,
      [](double w, double u, double v)
      { return std::max(std::abs(w) - 2.6, std::hypot(u - 0.1 * w, v) - 1.5); });
    EXPECT_LT(std::max(cylinder[0], cylinder[1]), flat);
    const auto ball = HeightsBeyondSlices(
      axis, [](double w, double u, double v) { return std::hypot(w, u, v) - 2.95; });
    EXPECT_GT(std::min(ball[0], ball[1]), least);
    EXPECT_LE(std::max(ball[0], ball[1]), most);
    // A cone with its foot below: flat there, and a tip above.
    const auto cone = HeightsBeyondSlices(axis,
      [](double w, double u, double v)
      { return std::max(-2.6 - w, std::hypot(u, v) - 0.5 * (2.95 - w)); });
    EXPECT_LT(cone[0], flat);
    EXPECT_GT(cone[1], flat);
    EXPECT_LE(cone[1], most);
  }
}
