// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/PiecePlanes.h"

#include "Support/Random.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Pieces Read(const std::string& text) { return ParsePieces(text)[2]; }

std::set<double> PlanesOf(const Pieces& pieces) { return { pieces.W.begin(), pieces.W.end() }; }

/// Twenty points each on these planes, moved off them by up to `noise`.
Pieces NoisyPieces(const std::vector<double>& planes, double noise, std::uint64_t seed)
{
  Random random(seed);
  Pieces pieces;
  pieces.Axis = 2;
  for (const double plane : planes)
  {
    std::vector<std::array<double, 2>> loop;
    for (int i = 0; i < 20; ++i)
    {
      loop.push_back({ std::cos(0.3 * i), std::sin(0.3 * i) });
    }
    AddPiece(pieces, loop, plane);
    for (std::size_t i = pieces.W.size() - 20; i < pieces.W.size(); ++i)
    {
      pieces.W[i] += random.Uniform(-noise, noise);
    }
  }
  return pieces;
}
}

//----------------------------------------------------------------------------
TEST(PiecePlanes, PlanarPiecesAreLeftAlone)
{
  for (const char* text : { "z=0: 0,0 1,0 1,1; z=1e-9: 0,0 1,0 1,1; z=5: 0,0 1,0 1,1",
         "z=0: 0,0 1,0,1e-6 1,1; z=1: 0,0 1,0 1,1", "z=0: 0,0 nan,0,nan 1,1" })
  {
    SCOPED_TRACE(text);
    Pieces pieces = Read(text);
    const std::vector<double> before = pieces.W;
    EXPECT_TRUE(MoveOntoPlanes(1e-5, 1e-3, pieces).empty());
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      EXPECT_TRUE(pieces.W[i] == before[i] || std::isnan(before[i]));
    }
  }
}

//----------------------------------------------------------------------------
TEST(PiecePlanes, ATenthOfTheDistanceOfSlicesIsLittle)
{
  Pieces pieces = Read("z=0: 0,0 1,0 1,1,0.4 0,1; z=5: 0,0 1,0 1,1; z=10: 0,0 1,0 1,1");
  const std::vector<PlaneShift> shifts = MoveOntoPlanes(1e-5, 1e-3, pieces);
  ASSERT_EQ(shifts.size(), 3u);
  EXPECT_EQ(shifts[0].Vertex, 2);
  EXPECT_EQ(shifts[0].Distance, 0.4);
  EXPECT_EQ(shifts[0].From, 0.4);
  EXPECT_EQ(shifts[1].Vertex, -1);
  EXPECT_EQ(PlanesOf(pieces), (std::set<double>{ 0.0, 5.0, 10.0 }));
  pieces = Read("z=0: 0,0 1,0 1,1,0.6 0,1; z=5: 0,0 1,0 1,1; z=10: 0,0 1,0 1,1");
  MoveOntoPlanes(1e-5, 1e-3, pieces);
  EXPECT_EQ(PlanesOf(pieces), (std::set<double>{ 0.0, 0.6, 5.0, 10.0 })) << "that is not little";
}

//----------------------------------------------------------------------------
TEST(PiecePlanes, PiecesThatAreAllFarOffTheirPlanesStayAsTheyAre)
{
  Pieces pieces = Read("z=0: 0,0 1,0 1,1,0.13 0,1; z=1: 0,0 1,0 1,1,1.13 0,1");
  const std::vector<double> before = pieces.W;
  EXPECT_TRUE(MoveOntoPlanes(1e-5, 1.0, pieces).empty());
  EXPECT_EQ(pieces.W, before);
}

//----------------------------------------------------------------------------
TEST(PiecePlanes, OnePieceFarOffItsPlaneSaysNothingOfOthers)
{
  // Neither are the slices 0 and 0.5 merged, nor does noise of 3 count as little.
  Pieces pieces = Read("z=0: 0,0 1,0 1,1,0.04 0,1; z=0.5: 0,0 1,0 1,1; z=5: 0,0 1,0,8 1,1 0,1");
  MoveOntoPlanes(1e-5, 1e-3, pieces);
  EXPECT_EQ(PlanesOf(pieces), (std::set<double>{ 0.0, 0.5, 5.0, 8.0 }));
}

//----------------------------------------------------------------------------
TEST(PiecePlanes, PiecesOfOneSliceMeetOnOnePlane)
{
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE(seed);
    // Two pieces on each slice, all with noise.
    Pieces pieces = NoisyPieces({ 1.0, 1.0, 2.0, 2.0, 3.5, 3.5 }, 0.02, seed);
    const std::vector<PlaneShift> shifts = MoveOntoPlanes(1e-5, 1e-3, pieces);
    ASSERT_EQ(shifts.size(), 6u);
    const std::set<double> planes = PlanesOf(pieces);
    ASSERT_EQ(planes.size(), 3u);
    const double expected[] = { 1.0, 2.0, 3.5 };
    std::size_t i = 0;
    for (const double plane : planes)
    {
      EXPECT_NEAR(plane, expected[i++], 0.02);
    }
  }
}

//----------------------------------------------------------------------------
TEST(PiecePlanes, SlicesNearToEachOtherStayApart)
{
  // The first two slices are twenty times nearer than the others; their noise is smaller still.
  Pieces pieces = NoisyPieces({ 1.0, 1.1, 3.0, 5.0 }, 0.004, 3);
  MoveOntoPlanes(1e-5, 1e-3, pieces);
  EXPECT_EQ(PlanesOf(pieces).size(), 4u);
}

//----------------------------------------------------------------------------
TEST(PiecePlanes, PiecesWithoutNoiseGiveThePlane)
{
  Pieces pieces = NoisyPieces({ 1.0, 2.0, 3.0 }, 0.01, 1);
  AddPiece(pieces, { { 5.0, 5.0 }, { 6.0, 5.0 }, { 6.0, 6.0 } }, 1.0);
  AddPiece(pieces, { { 5.0, 5.0 }, { 6.0, 5.0 }, { 6.0, 6.0 } }, 2.0);
  MoveOntoPlanes(1e-5, 1e-3, pieces);
  const std::set<double> planes = PlanesOf(pieces);
  EXPECT_EQ(planes.size(), 3u);
  EXPECT_EQ(planes.count(1.0) + planes.count(2.0), 2u);
}

//----------------------------------------------------------------------------
TEST(PiecePlanes, LooseSegmentsOfASliceAreOfOnePlane)
{
  Random random(5);
  Pieces pieces;
  pieces.Axis = 2;
  for (int i = 0; i < 200; ++i)
  {
    AddPiece(pieces, { { 1.0 * i, 0.0 }, { i + 1.0, 0.0 } }, i % 2 == 0 ? 0.0 : 1.0);
    pieces.W[2 * i] += random.Uniform(-0.01, 0.01);
    pieces.W[2 * i + 1] += random.Uniform(-0.01, 0.01);
  }
  MoveOntoPlanes(1e-5, 1e-3, pieces);
  EXPECT_EQ(PlanesOf(pieces).size(), 2u);
}

//----------------------------------------------------------------------------
TEST(PiecePlanes, ASingleSliceHasAToleranceOfItsOwn)
{
  Pieces pieces = Read("z=1: 0,0 1,0 1,1,1.05 0,1");
  MoveOntoPlanes(1e-5, 0.1, pieces);
  EXPECT_EQ(PlanesOf(pieces), (std::set<double>{ 1.0 }));
  pieces = Read("z=1: 0,0 1,0 1,1,1.05 0,1");
  MoveOntoPlanes(1e-5, 0.01, pieces);
  EXPECT_EQ(PlanesOf(pieces).size(), 2u);
}
