// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   every input that once gave a wrong surface, as small as it still did
 *
 * Found by FuzzReconstruct and RandomSolids and reduced by them.
 */

#include "Support/CheckEmbedding.h"
#include "Support/Perturbations.h"
#include "Support/ReduceInput.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Options AsDrawn()
{
  Options options;
  options.Invalid = InvalidContours::LeaveOut;
  options.Orient = Orientation::AsDrawn;
  return options;
}

Options ByNesting()
{
  Options options;
  options.Invalid = InvalidContours::LeaveOut;
  return options;
}

/// In double and, rounded, in float.
void ExpectNoFlaws(const std::string& text, Options options)
{
  PieceSets sets = ParsePieces(text);
  EXPECT_EQ(FindFlaws(sets, options), "");
  RoundToFloat(sets);
  options.SinglePrecision = true;
  EXPECT_EQ(FindFlaws(sets, options), "");
}
}

//----------------------------------------------------------------------------
// Arcs of one face that are apart, but by less than the rounding of their copies in the shells.

TEST(Regression, VertexBesideAnotherArcByLessThanTheRoundingOfShells)
{
  ExpectNoFlaws("x=0: -4,-4 4,-4 -4,-3.9999992847442627 4,4 -4,4\n"
                "y=0: -4,4 -4,-4 4,-4\n"
                "z=0: -4,-4 4,4 -4,4\n"
                "z=-2.6645352591003757e-15: -4,-4 4,-4.0000000000000027 4,4",
    AsDrawn());
}

//----------------------------------------------------------------------------
TEST(Regression, ArcThatRunsAlongAGridLinePastAnotherNode)
{
  ExpectNoFlaws(
    "x=-0.31122222542762756: 0,0.12000000000000002 0.30000000000000004,0.15000000000000002 1,0\n"
    "y=0.11316666752099991: 0.11541666835546494,-0.13470007479190826 "
    "0.20000000000000001,-0.30000000000000004 -0.30000000000000004,-1\n"
    "z=0.11541666835546494: 0,1 -0.13470007479190826,0.11316666752099991 -0.40000000000000002,0",
    AsDrawn());
}

//----------------------------------------------------------------------------
TEST(Regression, VerticesOneStepApartInAShell)
{
  Options options = AsDrawn();
  options.Crossing = CrossingContours::LeaveOut;
  ExpectNoFlaws("x=5: 3,5 3,7 0,7\n"
                "x=7: 3,5 3,7 0,7\n"
                "y=2: 5,5 7,5 7,8 5,8\n"
                "y=1: 7,4 7,6 5,6\n"
                "y=2: 5,4 7,4 7,6 5,6\n"
                "z=7: 4,1 6.0000000000000009,1 6,1 6,6",
    options);
}

//----------------------------------------------------------------------------
TEST(Regression, SpikeThatMissesItselfByOneStep)
{
  ExpectNoFlaws("x=0: -9,-9 9,-9 -9,9\n"
                "x=0: -2,-2 2,-2 -2,2\n"
                "x=0: -6,-6 6,-6 -6,6\n"
                "x=0: -8,-8 8,-8 8,8 -8,8\n"
                "y=0: -9,-9 9,-9 9,9 -9,9\n"
                "y=0: -2,-2 2,-2 2,2 -2,1 -2,2\n"
                "y=0: -4,-4 4,1 -4,4\n"
                "y=0: -6,-6 6,-6 6,6 -6,6\n"
                "y=0: -8,-8 8,-8 8,8 -8,8\n"
                "z=0: -8,-8 8,-8 8,8 -8,8",
    ByNesting());
}

//----------------------------------------------------------------------------
/// Where contours of neighbouring slices cross in projection next to a corner, rounding to float
/// put the new vertices of both sides of the corner on one line.
TEST(Regression, NewVerticesOfParallelSlicesBesideACorner)
{
  Options options = ByNesting();
  options.Central = CentralPointMethod::Centroid;
  ExpectNoFlaws("y=9.9999997171806854e-10: -9.9999997171806854e-10,1.9999999434361371e-09 "
                "1.9999999434361371e-09,4.000000330961484e-09 0,3.9999998868722741e-09\n"
                "y=4.9999999696126451e-09: -9.9999997171806854e-10,0 "
                "-9.9999997171806854e-10,9.9999997171806854e-10 0,3.9999998868722741e-09",
    options);
}

//----------------------------------------------------------------------------
/// An isolated contour that is one step wide at a corner: no shell has room beside it.
TEST(Regression, IsolatedContourOneStepWide)
{
  Options options = ByNesting();
  options.Central = CentralPointMethod::Centroid;
  ExpectNoFlaws(
    "z=2e-9: 8.0000000000000005e-09,7.9999995231628425e-09 0,5.0000000000000001e-09 "
    "0,6.0000000000000008e-09\n"
    "z=1e-9: 9.0000000000000012e-09,9.0000000000000012e-09 1e-08,1.0000000000000001e-09 "
    "0,5.0000000000000001e-09 0,8.9999992847442626e-09\n"
    "z=1e-9: 5.0000000000000001e-09,7.9999999999999988e-09 "
    "6.0000000000000008e-09,6.0000000000000008e-09 "
    "6.0000000000000008e-09,6.0000000000000016e-09",
    options);
}

//----------------------------------------------------------------------------
// Two contours with a corner in common in projection: their slices are displaced by less than the
// steps of float, which makes one vertex of two.

TEST(Regression, NewVerticesOfAStackThatRoundingMovesToOldOnes)
{
  ExpectNoFlaws("y=4: 104,104 102,101 103,101; y=8: 102,101 103,104 102,104", ByNesting());
}
