// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/RedrawnContours.h"

#include "Core/Slices/SpatialGrid.h"
#include "Support/Random.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A circle, or an ellipse, with a vertex every `step` degrees; clockwise if that is negative.
void AddEllipse(Pieces& pieces, double plane, const Point2& radius, double step = 7.5,
  const Point2& center = { 0.0, 0.0 })
{
  std::vector<Point2> vertices;
  for (int i = 0; i < std::lround(360.0 / std::abs(step)); ++i)
  {
    const double angle = 3.14159265358979 / 180.0 * step * i;
    vertices.push_back(
      { center[0] + radius[0] * std::cos(angle), center[1] + radius[1] * std::sin(angle) });
  }
  AddPiece(pieces, vertices, plane);
}

void AddCircle(Pieces& pieces, double plane, double radius, double step = 7.5)
{
  AddEllipse(pieces, plane, { radius, radius }, step);
}

/// The contours of the pieces, all of which are closed.
Contours Close(const PieceSets& sets) { return ParseContours(ToText(sets)); }

/// Cells of z-slices that are left, and what was reported.
std::vector<Problem> Remove(Contours& contours, double share = 0.05, bool directionsCount = false)
{
  BuildSpatialGrid(contours, 0.0);
  std::vector<Problem> mended;
  RemoveRedrawn(share, directionsCount, Execution(), contours, mended);
  return mended;
}
}

//----------------------------------------------------------------------------
TEST(RedrawnContours, CopiesAreRemovedAndNamed)
{
  Contours contours =
    ParseContours("z=0: 0,0 9,0 9,9 0,9; z=0: 3,3 6,3 6,6 3,6\n"
                  "z=0: 0,0 9,0 9,9 0,9; z=0: 6,6 6,3 3,3 3,6; z=1: 3,3 6,3 6,6 3,6");
  const std::vector<Problem> mended = Remove(contours, 0.0);
  EXPECT_EQ(contours.Cell, (std::vector<std::int64_t>{ 0, 1, 4 }));
  ASSERT_EQ(mended.size(), 2u);
  EXPECT_EQ(mended[0].Kind, ProblemKind::DrawnTwice);
  EXPECT_EQ(mended[0].Cell, 2);
  EXPECT_EQ(mended[1].Cell, 3);
  EXPECT_TRUE(mended[1].IsLeftOut);
  EXPECT_EQ(mended[0].Size, 0.0);
}

//----------------------------------------------------------------------------
TEST(RedrawnContours, WhatIsDrawnBesideItselfCountsOnce)
{
  for (const double step : { 7.5, -7.5, 5.0 })
  {
    for (const double radius : { 10.3, 9.7 })
    {
      SCOPED_TRACE(std::to_string(step) + " " + std::to_string(radius));
      PieceSets sets = EmptySets();
      AddCircle(sets[2], 0.0, 10.0);
      AddCircle(sets[2], 4.0, 10.0);
      AddCircle(sets[2], 4.0, radius, step);
      AddCircle(sets[2], 8.0, 10.0);
      Contours contours = Close(sets);
      const std::vector<Problem> mended = Remove(contours);
      EXPECT_EQ(contours.Cell, (std::vector<std::int64_t>{ 0, 1, 3 }));
      ASSERT_EQ(mended.size(), 1u);
      EXPECT_EQ(mended[0].Cell, 2);
      EXPECT_EQ(mended[0].Where[2], 4.0);
      EXPECT_NEAR(mended[0].Size, 0.3, 0.03);
      contours = Close(sets);
      EXPECT_TRUE(Remove(contours, 0.0).empty());
      contours = Close(sets);
      EXPECT_EQ(Remove(contours, 0.05, true).size(), step > 0.0 ? 1u : 0u);
    }
  }
}

//----------------------------------------------------------------------------
TEST(RedrawnContours, WhatIsDrawnAcrossItselfCountsOnce)
{
  PieceSets sets = EmptySets();
  AddEllipse(sets[2], 0.0, { 10.0, 7.0 });
  AddEllipse(sets[2], 0.0, { 9.8, 7.2 }, 5.0);
  AddEllipse(sets[2], 0.0, { 10.0, 7.0 }, 7.5, { 0.1, 0.1 });
  Contours contours = Close(sets);
  EXPECT_EQ(Remove(contours).size(), 2u);
  EXPECT_EQ(contours.Cell, (std::vector<std::int64_t>{ 0 }));
}

//----------------------------------------------------------------------------
TEST(RedrawnContours, ThickerWallsAndOtherShapesStay)
{
  PieceSets sets = EmptySets();
  AddCircle(sets[2], 0.0, 10.0);
  AddCircle(sets[2], 0.0, 9.3); // a wall of 7 %
  // A strip along a circle: near to it everywhere, but not the same.
  std::vector<Point2> strip;
  for (int i = 0; i < 96; ++i)
  {
    const double angle = 3.14159265358979 / 180.0 * 7.4 * (i < 48 ? i : 95 - i);
    const double radius = i < 48 ? 20.2 : 19.8;
    strip.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  AddCircle(sets[2], 1.0, 20.0);
  AddPiece(sets[2], strip, 1.0);
  Contours contours = Close(sets);
  EXPECT_TRUE(Remove(contours).empty());
  EXPECT_EQ(contours.Count(), 4);
}

//----------------------------------------------------------------------------
/// A pipe, of which each slice has both sides of the wall.
TEST(RedrawnContours, WallsThatOtherSlicesShowStay)
{
  for (const bool isWall : { true, false })
  {
    PieceSets sets = EmptySets();
    for (const double z : { 0.0, 2.0, 4.0 })
    {
      AddCircle(sets[2], z, 10.0);
      AddCircle(sets[2], z, 9.7, -7.5);
    }
    for (const double x : { -4.0, 0.3, 4.0 })
    {
      const double outer = std::sqrt(100.0 - x * x), inner = std::sqrt(9.7 * 9.7 - x * x);
      for (const double side : { -1.0, 1.0 })
      {
        if (isWall)
        {
          AddPiece(sets[0],
            { { side * inner, -1.0 }, { side * outer, -1.0 }, { side * outer, 5.0 },
              { side * inner, 5.0 } },
            x);
        }
      }
      if (!isWall)
      {
        AddPiece(
          sets[0], { { -outer, -1.0 }, { outer, -1.0 }, { outer, 5.0 }, { -outer, 5.0 } }, x);
      }
    }
    Contours contours = Close(sets);
    EXPECT_EQ(Remove(contours).size(), isWall ? 0u : 3u);
  }
}

//----------------------------------------------------------------------------
/// Slices across may have been drawn twice, too, so that they show two sides as those of a wall do.
TEST(RedrawnContours, WhatCrossesItselfIsNoWall)
{
  PieceSets sets = EmptySets();
  for (const double z : { 0.0, 2.0, 4.0 })
  {
    AddEllipse(sets[2], z, { 10.1, 9.9 });
    AddEllipse(sets[2], z, { 9.9, 10.1 }, -7.5);
  }
  for (const double x : { -4.0, 0.3, 4.0 })
  {
    const double side = std::sqrt(100.0 - x * x);
    for (const double more : { 0.05, -0.05 })
    {
      const double y = side + more, low = -1.0 + more, high = 5.0 + more;
      AddPiece(sets[0], { { -y, low }, { y, low }, { y, high }, { -y, high } }, x);
    }
  }
  Contours contours = Close(sets);
  EXPECT_EQ(Remove(contours).size(), 6u);
}

//----------------------------------------------------------------------------
TEST(RedrawnContours, OppositeSidesOnNeighbouringSlicesAreAWall)
{
  for (const double step : { 7.5, -7.5 })
  {
    PieceSets sets = EmptySets();
    for (const double z : { 0.0, 2.0, 4.0 })
    {
      AddCircle(sets[2], z, 10.0);
      AddCircle(sets[2], z, 9.7, step);
    }
    Contours contours = Close(sets);
    EXPECT_EQ(Remove(contours).size(), step > 0.0 ? 3u : 0u);
  }
}
