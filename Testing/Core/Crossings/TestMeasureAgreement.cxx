// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/MeasureAgreement.h"

#include "Core/Crossings/NodeNormals.h"
#include "Support/Perturbations.h"
#include "Support/SliceSolid.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
SliceAgreement Measure(const Stages& stages)
{
  return MeasureAgreement(stages.Set, stages.Grid, stages.Crossings, stages.Nodes,
    ComputeNodeNormals(stages.Set, stages.Grid, stages.Crossings, stages.Nodes, Execution()));
}

void ExpectAgreement(const Agreement& found, Index nodes, double meanSquare, double greatest)
{
  EXPECT_EQ(found.NodePoints, nodes);
  EXPECT_NEAR(found.RootMeanSquare(), std::sqrt(meanSquare), 1e-14);
  EXPECT_EQ(found.Greatest, greatest);
}

void ExpectShift(const Point3& found, const Point3& expected)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(found[axis], expected[axis], 1e-14) << "xyz"[axis];
  }
}
}

//----------------------------------------------------------------------------
TEST(Agreement, CountsAndSums)
{
  Agreement agreement;
  EXPECT_EQ(agreement.RootMeanSquare(), 0.0);
  for (const double disagreement : { 1.0, -3.0, 0.0, 2.0 })
  {
    agreement.Add(disagreement);
  }
  ExpectAgreement(agreement, 4, 14.0 / 4.0, 3.0);
}

//----------------------------------------------------------------------------
/// Half-widths 1, 1.25 and 1.75: every contour meets two others, each of them twice.
TEST(MeasureAgreement, SquaresOfDifferentSizes)
{
  const Stages stages("x=0: -1,-1 1,-1 1,1 -1,1\n"
                      "y=0: -1.25,-1.25 1.25,-1.25 1.25,1.25 -1.25,1.25\n"
                      "z=0: -1.75,-1.75 1.75,-1.75 1.75,1.75 -1.75,1.75");
  const SliceAgreement result = Measure(stages);
  const double xy = 0.25, yz = 0.5, zx = 0.75; // distances of the contours of two axes
  ASSERT_EQ(result.OfContour.size(), 3u);
  ExpectAgreement(result.OfContour[0], 4, 0.5 * (xy * xy + zx * zx), zx);
  ExpectAgreement(result.OfContour[1], 4, 0.5 * (xy * xy + yz * yz), yz);
  ExpectAgreement(result.OfContour[2], 4, 0.5 * (yz * yz + zx * zx), zx);
  for (int axis = 0; axis < 3; ++axis)
  {
    ASSERT_EQ(result.OfPlane[axis].size(), 1u);
    EXPECT_EQ(result.OfPlane[axis][0].SumOfSquares, result.OfContour[axis].SumOfSquares);
    ExpectShift(result.Shift[axis][0], { 0, 0, 0 }); // too large or too small, but not off center
  }
}

//----------------------------------------------------------------------------
/// Two boxes on one y- and one z-plane, of which one is too wide on its x-plane.
TEST(MeasureAgreement, ContoursOfOnePlaneAreToldApart)
{
  const Stages stages("x=0: -1,-1 1,-1 1,1 -1,1; x=10: -1.5,-1.5 1.5,-1.5 1.5,1.5 -1.5,1.5\n"
                      "y=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,9 1,9 1,11 -1,11\n"
                      "z=0: -1,-1 1,-1 1,1 -1,1; z=0: 9,-1 11,-1 11,1 9,1");
  const SliceAgreement result = Measure(stages);
  ASSERT_EQ(result.OfContour.size(), 6u);
  const double d = 0.5;
  for (const Index good : { 0, 2, 4 })
  {
    ExpectAgreement(result.OfContour[good], 4, 0.0, 0.0);
  }
  ExpectAgreement(result.OfContour[1], 4, d * d, d);
  ExpectAgreement(result.OfContour[3], 4, d * d / 2.0, d);
  ExpectAgreement(result.OfContour[5], 4, d * d / 2.0, d);
  ASSERT_EQ(result.OfPlane[0].size(), 2u);
  ExpectAgreement(result.OfPlane[0][0], 4, 0.0, 0.0);
  ExpectAgreement(result.OfPlane[0][1], 4, d * d, d);
  ExpectAgreement(result.OfPlane[1][0], 8, d * d / 4.0, d);
  ExpectAgreement(result.OfPlane[2][0], 8, d * d / 4.0, d);
}

//----------------------------------------------------------------------------
namespace
{
/// A box from 0.5 to 4.5 cut by the planes 1 to 4 of each axis; z = 3 moved by (0.25, -0.125).
std::string BoxWithMovedSlice()
{
  std::string text;
  for (const char axis : { 'x', 'y', 'z' })
  {
    for (const char plane : { '1', '2', '3', '4' })
    {
      const bool moved = axis == 'z' && plane == '3';
      text += std::string(1, axis) + '=' + plane +
        (moved ? ": 0.75,0.375 4.75,0.375 4.75,4.375 0.75,4.375\n"
               : ": 0.5,0.5 4.5,0.5 4.5,4.5 0.5,4.5\n");
    }
  }
  return text;
}
}

TEST(MeasureAgreement, MovedSliceStandsOutAndAsksForItsWayBack)
{
  const double u = 0.25, v = 0.125;
  const Stages stages(BoxWithMovedSlice());
  const SliceAgreement result = Measure(stages);
  for (Index plane = 0; plane < 4; ++plane)
  {
    SCOPED_TRACE(plane);
    // Four planes of each of the other two axes, and two node points with each of these.
    const bool moved = plane == 2;
    ExpectAgreement(
      result.OfPlane[2][plane], 16, moved ? 0.5 * (u * u + v * v) : 0.0, moved ? u : 0.0);
    ExpectShift(result.Shift[2][plane], moved ? Point3{ -u, v, 0.0 } : Point3{ 0.0, 0.0, 0.0 });
    // Of the sixteen node points of each x- and y-slice, eight lie on z-slices, two on this one.
    ExpectAgreement(result.OfPlane[0][plane], 16, v * v / 8.0, v);
    ExpectAgreement(result.OfPlane[1][plane], 16, u * u / 8.0, u);
    ExpectShift(result.Shift[0][plane], { 0.0, -v / 4.0, 0.0 });
    ExpectShift(result.Shift[1][plane], { u / 4.0, 0.0, 0.0 });
  }
}

//----------------------------------------------------------------------------
/// The same on a curved shape, whose contours do not meet the edges at right angles.
TEST(MeasureAgreement, MovedSliceOfATorusIsTheWorstAndAsksForItsWayBack)
{
  const Solid solid = TiltedTorus();
  const PlaneSets planes = EqualPlanes(solid, { 16, 16, 16 });
  const double du = 0.004, dv = -0.003, length = 0.005;
  for (int axis = 0; axis < 3; ++axis)
  {
    SCOPED_TRACE(axis);
    Input input;
    input.Sets = SliceSolid(solid, planes, 3, InPlaneGrid::Aligned);
    Pieces& pieces = input.Sets[axis];
    const double moved = planes[axis][8];
    for (std::size_t i = 0; i < pieces.U.size(); ++i)
    {
      pieces.U[i] += pieces.W[i] == moved ? du : 0.0;
      pieces.V[i] += pieces.W[i] == moved ? dv : 0.0;
    }
    const Stages stages(input);
    const SliceAgreement result = Measure(stages);
    const std::vector<double>& found = stages.Grid.Planes[axis];
    const auto worst =
      static_cast<std::size_t>(std::find(found.begin(), found.end(), moved) - found.begin());
    ASSERT_LT(worst, found.size());
    EXPECT_NEAR(result.Shift[axis][worst][FirstAxis(axis)], -du, 0.03 * length);
    EXPECT_NEAR(result.Shift[axis][worst][SecondAxis(axis)], -dv, 0.03 * length);
    for (int other = 0; other < 3; ++other)
    {
      for (std::size_t plane = 0; plane < result.Shift[other].size(); ++plane)
      {
        if (other != axis || plane != worst)
        {
          const Point3& shift = result.Shift[other][plane];
          EXPECT_LT(std::hypot(shift[0], shift[1], shift[2]), other == axis ? 1e-9 : 0.97 * length);
          EXPECT_LT(result.OfPlane[other][plane].RootMeanSquare(),
            result.OfPlane[axis][worst].RootMeanSquare());
        }
      }
    }
  }
}

//----------------------------------------------------------------------------
/// All node points of a slice have the same normal: it could lie anywhere across.
TEST(MeasureAgreement, NothingIsSaidAboutAShiftThatNoNodePointShows)
{
  // The z-slice is moved by 0.25 along +y and meets the x-slice only.
  const Stages stages("x=0: -1,-1 1,-1 1,1 -1,1; y=9: 7,7 8,7 8,8\n"
                      "z=0: -1,-0.75 1,-0.75 1,1.25 -1,1.25");
  const SliceAgreement result = Measure(stages);
  ExpectAgreement(result.OfPlane[2][0], 2, 0.25 * 0.25, 0.25);
  ExpectShift(result.Shift[2][0], { 0, 0, 0 });
  ExpectAgreement(result.OfPlane[1][0], 0, 0.0, 0.0);
  ExpectShift(result.Shift[1][0], { 0, 0, 0 });
}

//----------------------------------------------------------------------------
/// Loops that reconciliation inserts are no contours of the user's.
TEST(MeasureAgreement, OverruledSliceHasNoNodePointsOfItsOwn)
{
  const Stages stages("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                      "z=0: 0.2,0.2 0.8,0.2 0.8,0.8 0.2,0.8");
  ASSERT_EQ(stages.Nodes.Count(), 6);
  const SliceAgreement result = Measure(stages);
  ExpectAgreement(result.OfContour[0], 4, 0.5, 1.0);
  ExpectAgreement(result.OfContour[1], 4, 0.5, 1.0);
  ExpectAgreement(result.OfContour[2], 0, 0.0, 0.0);
  ExpectAgreement(result.OfPlane[2][0], 0, 0.0, 0.0);
}

//----------------------------------------------------------------------------
TEST(MeasureAgreement, SlicesThatAgreeHaveNothingButZeros)
{
  Index nodes = 0, passed = 0;
  for (std::uint64_t seed = 0; seed < 40; seed += 2)
  {
    const Input input = RandomConsistentInput(seed);
    SCOPED_TRACE(input.Name);
    ASSERT_TRUE(input.Exact);
    const Stages stages(input);
    const SliceAgreement result = Measure(stages);
    ASSERT_EQ(result.OfContour.size(), static_cast<std::size_t>(stages.Set.Count()));
    for (const Agreement& agreement : result.OfContour)
    {
      EXPECT_EQ(agreement.Greatest, 0.0);
      EXPECT_EQ(agreement.SumOfSquares, 0.0);
      passed += agreement.NodePoints;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const Point3& shift : result.Shift[axis])
      {
        ExpectShift(shift, { 0, 0, 0 });
      }
    }
    nodes += stages.Nodes.Count();
  }
  EXPECT_GT(nodes, 1000);
  EXPECT_EQ(passed, 2 * nodes); // two contours meet in each
}
