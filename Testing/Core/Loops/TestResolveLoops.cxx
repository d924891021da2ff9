// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/ResolveLoops.h"
#include "Core/Loops/WeldBridges.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"
#include "Core/Slices/SpatialGrid.h"
#include "Support/LoopOracle.h"
#include "Support/Random.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
struct Resolved
{
  std::vector<Polygon> Loops;
  std::vector<std::int64_t> Cells;
  std::vector<Problem> Mended;
  Index First = 0;

  double Area() const
  {
    return std::accumulate(this->Loops.begin(), this->Loops.end(), 0.0,
      [](double sum, const Polygon& loop) { return sum + SignedArea(loop); });
  }
  Index Count(ProblemKind kind) const
  {
    return static_cast<Index>(std::count_if(this->Mended.begin(), this->Mended.end(),
      [=](const Problem& problem) { return problem.Kind == kind; }));
  }
};

Resolved Resolve(Contours contours, LoopRule rule = LoopRule::Union, bool asDrawn = false,
  bool partTouching = false)
{
  BuildSpatialGrid(contours, 0.0);
  Resolved result;
  result.First = ResolveLoops(rule, asDrawn, partTouching, Execution(), contours, result.Mended);
  for (Index i = 0; i < contours.Count(); ++i)
  {
    result.Loops.emplace_back();
    result.Cells.push_back(contours.Cell[i]);
    for (Index v = contours.Offsets[i]; v < contours.Offsets[i + 1]; ++v)
    {
      result.Loops.back().push_back({ contours.U[v], contours.V[v] });
    }
  }
  return result;
}

Resolved Resolve(const std::string& text, LoopRule rule = LoopRule::Union, bool asDrawn = false)
{
  return Resolve(ParseContours(text), rule, asDrawn);
}

Contours ToContours(const std::vector<Polygon>& polygons)
{
  Contours contours;
  for (const Polygon& polygon : polygons)
  {
    AddContour(contours, polygon);
  }
  return contours;
}

/// A polygon whose corners are different points of a square grid.
Polygon RandomPolygon(Random& random, std::size_t size, std::size_t corners)
{
  Polygon polygon;
  while (polygon.size() < corners)
  {
    const Point2 p{ static_cast<double>(random.Below(size)),
      static_cast<double>(random.Below(size)) };
    if (std::find(polygon.begin(), polygon.end(), p) == polygon.end())
    {
      polygon.push_back(p);
    }
  }
  return polygon;
}

/// Whether the loops are simple, and surround once what they should, and nothing else.
void ExpectRegion(
  const std::vector<Polygon>& input, LoopRule rule, const std::vector<Polygon>& loops)
{
  EXPECT_TRUE(AreDisjointAndSimple(loops));
  const std::vector<FacePoint> points = PointsInAllFaces(input, 1e-6);
  const std::vector<bool> inside = FindInsidePoints(rule, input, points);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    int winding = 0;
    bool isNearCut = false;
    for (const Polygon& loop : loops)
    {
      winding += WindingNumber(loop, points[k].Place);
      for (const Point2& corner : loop)
      {
        isNearCut = isNearCut || Distance(corner, points[k].Place) < 0.03;
      }
    }
    if (!isNearCut)
    {
      ASSERT_EQ(winding, inside[k] ? 1 : 0) << points[k].Place[0] << " " << points[k].Place[1];
    }
  }
}
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, ContoursThatTouchOrNestStayAsTheyAre)
{
  for (const char* text : { "z=0: 0,0 9,0 9,9 0,9; z=0: 3,3 6,3 6,6 3,6",
         "z=0: 0,0 1,0 1,1 0,1; z=0: 1,1 2,1 2,2 1,2",       // in a corner
         "z=0: 0,0 4,0 4,4 0,4; z=0: 2,0 3,1 1,1",           // a corner on an edge
         "z=0: 0,0 1,1 0,2 2,2 1,1 2,0; x=0: 0,0 1,0 1,1" }) // itself, in a corner
  {
    SCOPED_TRACE(text);
    const Resolved result = Resolve(text);
    const Contours contours = ParseContours(text);
    EXPECT_EQ(result.First, contours.Count());
    EXPECT_TRUE(result.Mended.empty());
    ASSERT_EQ(static_cast<Index>(result.Loops.size()), contours.Count());
    for (Index i = 0; i < contours.Count(); ++i)
    {
      EXPECT_EQ(static_cast<Index>(result.Loops[i].size()), contours.Size(i));
    }
  }
}

//----------------------------------------------------------------------------
/// What follows would leave out the vertices in which they touch, and half of a square with them.
TEST(ResolveLoops, ContoursThatTouchArePartedIfAskedFor)
{
  const struct
  {
    const char* Text;
    std::size_t Loops;
    double Area;
  } cases[] = { { "z=0: 0,0 1,0 1,1 0,1; z=0: 1,1 2,1 2,2 1,2", 2, 2.0 },      // in a corner
    { "z=0: 0,0 1,0 1,1 0,1; z=0: 1,1.0000000000000002 2,1 2,2 1,2", 2, 2.0 }, // but for rounding
    { "z=0: 0,0 4,0 4,4 0,4; z=0: 2,0 3,1 1,1", 2, 15.0 },                     // a hole on an edge
    { "z=0: 0,0 1,1 0,2 2,2 1,1 2,0", 2, 2.0 },                                // itself
    { "z=0: 0,0 4,0 4,2 4.00001,2.00001 4,2 4,4 0,4", 1, 16.0 } }; // with a crumb that stays
  for (const auto& test : cases)
  {
    SCOPED_TRACE(test.Text);
    const Resolved result = Resolve(ParseContours(test.Text), LoopRule::Union, false, true);
    EXPECT_EQ(result.Loops.size(), test.Loops);
    EXPECT_NEAR(result.Area(), test.Area, 0.01);
    EXPECT_TRUE(test.Loops == 1 || AreDisjointAndSimple(result.Loops));
  }
}

//----------------------------------------------------------------------------
/// Overlapping by 1 % of their area, discs are a third as wide where they meet.
TEST(ResolveLoops, LoopsThatOverlapByANeckAreUnited)
{
  std::vector<Polygon> discs(2);
  for (int i = 0; i < 80; ++i)
  {
    const double angle = 2.0 * 3.141592653589793 * (i % 40) / 40.0;
    discs[i / 40].push_back({ 10.0 * std::cos(angle) + 19.0 * (i / 40), 10.0 * std::sin(angle) });
  }
  const Resolved result = Resolve(ToContours(discs));
  EXPECT_EQ(result.Loops.size(), 1u);
  EXPECT_EQ(result.Count(ProblemKind::LoopsUnited), 2);
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, LoopsThatOverlapAreUnited)
{
  const Resolved two = Resolve("z=0: 0,0 4,0 4,4 0,4; z=0: 2,2 2,6 6,6 6,2");
  ASSERT_EQ(two.Loops.size(), 1u);
  EXPECT_EQ(two.Area(), 28.0);
  EXPECT_EQ(two.Count(ProblemKind::LoopsUnited), 2);
  EXPECT_EQ(two.First, 0);
  // A chain, with a hole in the first and one lone loop elsewhere.
  const Resolved chain =
    Resolve("z=0: 0,0 6,0 6,6 0,6; z=0: 5,1 9,1 9,5 5,5; z=0: 8,2 12,2 12,4 8,4; "
            "z=0: 1,1 2,1 2,2 1,2; z=0: 20,0 21,0 21,1");
  EXPECT_EQ(chain.Loops.size(), 3u);
  EXPECT_EQ(chain.Area(), 36.0 + 12.0 + 6.0 - 1.0 + 0.5);
  EXPECT_EQ(chain.Count(ProblemKind::LoopsUnited), 3);
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, RulesDifferWhereLoopsOverlap)
{
  const std::string text = "z=0: 0,0 4,0 4,4 0,4; z=0: 2,2 2,6 6,6 6,2"; // one clockwise
  EXPECT_EQ(Resolve(text, LoopRule::Union).Area(), 28.0);
  EXPECT_NEAR(Resolve(text, LoopRule::EvenOdd).Area(), 24.0, 0.01);
  EXPECT_NEAR(Resolve(text, LoopRule::NonZero).Area(), 24.0, 0.01);
  const std::string alike = "z=0: 0,0 4,0 4,4 0,4; z=0: 2,2 6,2 6,6 2,6";
  EXPECT_NEAR(Resolve(alike, LoopRule::NonZero).Area(), 28.0, 0.01);
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, NonZeroCountsDirectionsOfNestedLoops)
{
  EXPECT_EQ(Resolve("z=0: 0,0 9,0 9,9 0,9; z=0: 3,3 6,3 6,6 3,6", LoopRule::NonZero).Area(), 81.0);
  EXPECT_EQ(Resolve("z=0: 0,0 9,0 9,9 0,9; z=0: 3,3 3,6 6,6 6,3", LoopRule::NonZero).Area(), 72.0);
  EXPECT_EQ(Resolve("z=0: 0,0 0,9 9,9 9,0; z=0: 3,3 6,3 6,6 3,6", LoopRule::NonZero).Area(), 72.0);
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, HolesOfOverlappingLoopsStay)
{
  // Two rings that overlap: what is hole of one and inside of the other is inside.
  const Resolved rings = Resolve("z=0: 0,0 8,0 8,8 0,8; z=0: 2,2 6,2 6,6 2,6; "
                                 "z=0: 5,0 13,0 13,8 5,8; z=0: 7,2 11,2 11,6 7,6");
  EXPECT_EQ(rings.Area(), 13.0 * 8.0 - 3.0 * 4.0 - 3.0 * 4.0);
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, KeyholesBecomeOutlineAndHole)
{
  for (const char* text :
    { // The hole drawn in the other direction, in the same one, and with a corner of the bridge.
      "z=0: 0,0 9,0 9,9 0,9 0,4 3,4 3,6 6,6 6,3 3,3 3,4 0,4",
      "z=0: 0,0 9,0 9,9 0,9 0,4 3,4 3,3 6,3 6,6 3,6 3,4 0,4",
      "z=0: 0,0 9,0 9,9 0,9 0,4 1,5 3,4 3,3 6,3 6,6 3,6 3,4 1,5 0,4" })
  {
    SCOPED_TRACE(text);
    const Resolved keyhole = Resolve(text);
    ASSERT_EQ(keyhole.Loops.size(), 2u);
    EXPECT_EQ(keyhole.Area(), 72.0);
    ASSERT_EQ(keyhole.Mended.size(), 1u);
    EXPECT_EQ(keyhole.Mended[0].Kind, ProblemKind::BridgeRemoved);
    EXPECT_GE(keyhole.Mended[0].Size, 3.0);
  }
  // Two holes, the second one reached from the first.
  const Resolved two = Resolve("z=0: 0,0 20,0 20,9 0,9 0,4 3,4 3,3 6,3 6,4 9,4 9,3 12,3 12,6 9,6 "
                               "9,4 6,4 6,6 3,6 3,4 0,4");
  EXPECT_EQ(two.Loops.size(), 3u);
  EXPECT_EQ(two.Area(), 162.0);
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, BridgesWithALittleSpaceBetweenTheirSidesAreTakenOut)
{
  const auto weld = [](const std::string& text)
  {
    Contours contours = ParseContours(text);
    BuildSpatialGrid(contours, 0.0);
    WeldBridges(0.05, Execution(), contours);
    return Resolve(contours);
  };
  for (const char* text :
    { "z=0: 0,0 20,0 20,9.9 14,9.9 14,6 6,6 6,14 14,14 14,10 20,10 20,20 0,20",
      "z=0: 0,20 20,20 20,10 14,10 14,14 6,14 6,6 14,6 14,9.9 20,9.9 20,0 0,0",
      "z=0: 0,0 20,0 20,9.9 13.5,10 14,6 6,6 6,14 14,14 14,10.1 20,10 20,20 0,20" })
  {
    SCOPED_TRACE(text);
    const Resolved keyhole = weld(text);
    ASSERT_EQ(keyhole.Loops.size(), 2u);
    EXPECT_NEAR(keyhole.Area(), 400.0 - 64.0, 2.0);
    EXPECT_EQ(keyhole.Count(ProblemKind::BridgeRemoved), 1);
  }
  // A slot that leads nowhere, a hole with a wide mouth.
  for (const char* text : { "z=0: 0,0 20,0 20,9.9 6,9.9 6,10 20,10 20,20 0,20",
         "z=0: 0,0 20,0 20,9 14,9 14,6 6,6 6,14 14,14 14,10 20,10 20,20 0,20" })
  {
    SCOPED_TRACE(text);
    EXPECT_EQ(weld(text).Loops.size(), 1u);
    EXPECT_TRUE(weld(text).Mended.empty());
  }
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, NoiseThatMakesContoursCrossALittleIsLeftAlone)
{
  // A curl, a hole that pokes out, two contours that overlap by a little.
  for (const char* text : { "z=0: 0,0 9,0 9,4 9.2,4.3 9.2,4 9,4.3 9,9 0,9",
         "z=0: 0,0 9,0 9,9 0,9; z=0: 3,0.5 3.2,-0.1 3.4,0.5 6,0.5 6,6 3,6",
         "z=0: 0,0 9,0 9,9 0,9; z=0: 8.9,4 9.3,3 15,3 15,6 9.3,5" })
  {
    SCOPED_TRACE(text);
    const Resolved result = Resolve(text);
    EXPECT_EQ(result.First, ParseContours(text).Count());
    ASSERT_EQ(result.Mended.size(), 1u);
    EXPECT_LE(result.Mended[0].Kind, ProblemKind::CrossesOther);
  }
  // With a real overlap on the slice the hole stays one.
  EXPECT_NEAR(
    Resolve(
      "z=0: 0,0 9,0 9,9 0,9; z=0: 3,0.5 3.2,-0.1 3.4,0.5 6,0.5 6,6 3,6; z=0: 8,1 12,1 12,8 8,8")
      .Area(),
    81.0 - 16.6 + 21.0, 0.2);
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, LobesAreKept)
{
  const Resolved bowtie = Resolve("z=0: 0,0 10,10 10,0 0,10");
  EXPECT_EQ(bowtie.Loops.size(), 2u);
  EXPECT_NEAR(bowtie.Area(), 50.0, 0.02);
  EXPECT_EQ(bowtie.Count(ProblemKind::LoopSplit), 1);
  const Resolved uneven = Resolve("z=0: 0,0 10,6 10,0 0,2");
  EXPECT_EQ(uneven.Loops.size(), 2u);
  EXPECT_GT(SignedArea(uneven.Loops[0]), 0.0);
  EXPECT_GT(SignedArea(uneven.Loops[1]), 0.0);
  const Resolved corner = Resolve("z=0: 0,0 0,-10 -10,-10 -10,0 0,0 10,0 10,10 0,10");
  EXPECT_EQ(corner.Loops.size(), 2u);
  EXPECT_NEAR(corner.Area(), 200.0, 0.02);
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, SharedSidesVanish)
{
  const Resolved result = Resolve("z=0: 0,0 4,0 4,4 0,4; z=0: 4,1 8,1 8,3 4,3");
  ASSERT_EQ(result.Loops.size(), 1u);
  EXPECT_EQ(result.Area(), 24.0);
  // A hole that is open along the border that it shares.
  EXPECT_EQ(Resolve("z=0: 0,0 9,0 9,9 0,9; z=0: 3,0 6,0 6,3 3,3").Area(), 72.0);
  // The outline once more, but for a corner.
  const Resolved again = Resolve("z=0: 0,0 9,0 9,9 0,9; z=0: 0,0 9,0 9,8 8,9 0,9");
  EXPECT_EQ(again.Loops.size(), 1u);
  EXPECT_EQ(again.Area(), 81.0);
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, StarsAndSpirals)
{
  Polygon star;
  for (int i = 0; i < 5; ++i)
  {
    const double angle = 2.0 * 6.283185307179586 / 5 * i;
    star.push_back({ std::cos(angle), std::sin(angle) });
  }
  const Resolved filled = Resolve(ToContours({ star }));
  EXPECT_EQ(filled.Loops.size(), 1u);
  EXPECT_NEAR(filled.Area(), 1.12257, 1e-4);
  EXPECT_NEAR(Resolve(ToContours({ star }), LoopRule::EvenOdd).Area(), 0.77567, 1e-3);
  Polygon spiral;
  for (int i = 0; i <= 60; ++i)
  {
    const double angle = 0.2 * i;
    spiral.push_back({ (1 + 0.05 * i) * std::cos(angle), (1 + 0.05 * i) * std::sin(angle) });
  }
  const Resolved wound = Resolve(ToContours({ spiral }));
  EXPECT_EQ(wound.Loops.size(), 1u);
  EXPECT_GT(wound.Area(), 0.0);
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, AsDrawnKeepsTheSideOfTheInterior)
{
  const std::string clockwise = "z=0: 0,0 0,4 4,4 4,0; z=0: 2,2 2,6 6,6 6,2";
  EXPECT_EQ(Resolve(clockwise, LoopRule::Union, true).Area(), -28.0);
  EXPECT_EQ(
    Resolve("z=0: 0,0 4,0 4,4 0,4; z=0: 2,2 6,2 6,6 2,6", LoopRule::Union, true).Area(), 28.0);
  // A hole that crosses the outline.
  EXPECT_EQ(
    Resolve("z=0: 0,0 4,0 4,4 0,4; z=0: 2,2 2,6 6,6 6,2", LoopRule::Union, true).Area(), 12.0);
}

//----------------------------------------------------------------------------
TEST(ResolveLoops, SurroundsWhatBruteForceSays)
{
  int resolved = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::size_t size = 3 + random.Below(7);
    std::vector<Polygon> polygons;
    const std::size_t count = 1 + random.Below(4);
    while (polygons.size() < count)
    {
      polygons.push_back(RandomPolygon(random, size, 3 + random.Below(6)));
    }
    double common = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      common += CommonLength(polygons[i], polygons[i], true);
      for (std::size_t j = 0; j < i; ++j)
      {
        common += CommonLength(polygons[i], polygons[j]) > 2.0 ? 1.0 : 0.0;
      }
    }
    for (const LoopRule rule : { LoopRule::Union, LoopRule::EvenOdd, LoopRule::NonZero })
    {
      SCOPED_TRACE(static_cast<int>(rule));
      const Resolved result = Resolve(ToContours(polygons), rule);
      if (result.First > 0)
      {
        continue;
      }
      ++resolved;
      if (common > 0.0 && rule == LoopRule::Union)
      {
        EXPECT_TRUE(AreDisjointAndSimple(result.Loops));
        continue;
      }
      ExpectRegion(polygons, rule, result.Loops);
      if (::testing::Test::HasFailure())
      {
        return;
      }
    }
  }
  EXPECT_GT(resolved, 500);
}
