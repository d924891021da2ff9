// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/ClearLines.h"

#include "Core/Base/EditContours.h"
#include "Core/Labels/ShareBorders.h"
#include "Core/Labels/SideMeetings.h"
#include "Core/Labels/SliceMembers.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Height = 5.0; ///< of a line along x, on a slice across z
constexpr double Margin = 5e-6;

SpatialGrid MakeGrid()
{
  SpatialGrid grid;
  grid.Planes = { { { 0.0, 10.0 }, { 0.0, Height, 10.0 }, { 1.0, 2.0 } } };
  return grid;
}

Contours MakeContour(const std::vector<Point2>& corners)
{
  Contours contours;
  AddContour(contours, corners, 1.0);
  contours.Plane.push_back(0);
  contours.Cell.back() = 7;
  return contours;
}

/// Contours cleared, and traced anew.
void Clear(std::vector<Contours>& structures)
{
  const std::vector<Contours*> all = PointersTo(structures);
  ClearLines(MakeGrid(), Execution(), all);
  ShareBorders(0.0, {}, Execution(), all);
}

/// The vertices on the line; fails if others are close to it.
int CountOnLine(const Contours& contours)
{
  int count = 0;
  for (const double v : contours.V)
  {
    count += v == Height ? 1 : 0;
    EXPECT_TRUE(v == Height || std::abs(v - Height) > 0.999 * Margin) << v;
  }
  return count;
}

/// Three structures that meet in a point, of which the last one is above it.
std::vector<Contours> MeetIn(const Point2& place)
{
  return { MakeContour({ { 1.0, 1.0 }, { 3.0, 1.0 }, place, { 2.0, 9.0 }, { 1.0, 9.0 } }),
    MakeContour({ { 3.0, 1.0 }, { 6.0, 1.0 }, { 6.0, 9.0 }, { 4.0, 9.0 }, place }),
    MakeContour({ place, { 4.0, 9.0 }, { 2.0, 9.0 } }) };
}
}

TEST(ClearLines, WhatPassesStraightStaysAsItIs)
{
  const std::vector<Contours> before = MeetIn({ 3.0, 6.0 });
  std::vector<Contours> structures = before;
  Clear(structures);
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    EXPECT_EQ(structures[i].U, before[i].U);
    EXPECT_EQ(structures[i].V, before[i].V);
  }
}

/// Structures that meet on a line meet on the rim of its strip afterwards: those that pass have a
/// side in common from there to the line.
TEST(ClearLines, ContoursPartOnTheRims)
{
  std::vector<Contours> structures = MeetIn({ 3.0, Height });
  Clear(structures);
  EXPECT_EQ(CountOnLine(structures[0]), 1);
  EXPECT_EQ(CountOnLine(structures[1]), 1);
  EXPECT_EQ(CountOnLine(structures[2]), 0);
  for (const Contours& contours : structures)
  {
    EXPECT_TRUE(HasVertex(contours, { 3.0, Height + Margin }));
    EXPECT_EQ(contours.Cell, (std::vector<std::int64_t>{ 7 }));
  }
  EXPECT_TRUE(HasVertex(structures[0], { 3.0, Height }));
  EXPECT_TRUE(HasVertex(structures[1], { 3.0, Height }));
  EXPECT_FALSE(DoSidesMeet(MakeGrid(), structures));
}

/// From below, too, where a contour would pass the line twice in that point.
TEST(ClearLines, WhatTouchesFromBelowIsOffTheLine)
{
  std::vector<Contours> structures = MeetIn({ 3.0, Height });
  for (Contours& contours : structures)
  {
    for (double& v : contours.V)
    {
      v = 2.0 * Height - v;
    }
    std::reverse(contours.U.begin(), contours.U.end());
    std::reverse(contours.V.begin(), contours.V.end());
  }
  Clear(structures);
  EXPECT_EQ(CountOnLine(structures[0]), 1);
  EXPECT_EQ(CountOnLine(structures[1]), 1);
  EXPECT_EQ(CountOnLine(structures[2]), 0);
  EXPECT_FALSE(DoSidesMeet(MakeGrid(), structures));
}

/// A structure thinner than the margin where it passes a line is parted there, and its neighbours
/// have a common place on the line.
TEST(ClearLines, PlacesThatAreCloseBecomeOne)
{
  const Point2 left{ 3.0, Height }, right{ 3.0 + 0.5 * Margin, Height };
  std::vector<Contours> structures{
    MakeContour({ { 1.0, 1.0 }, { 2.0, 1.0 }, left, { 2.0, 9.0 }, { 1.0, 9.0 } }),
    MakeContour({ { 2.0, 1.0 }, { 4.0, 1.0 }, right, { 4.0, 9.0 }, { 2.0, 9.0 }, left }),
    MakeContour({ { 4.0, 1.0 }, { 6.0, 1.0 }, { 6.0, 9.0 }, { 4.0, 9.0 }, right })
  };
  Clear(structures);
  EXPECT_TRUE(HasVertex(structures[0], left));
  EXPECT_EQ(CountOnLine(structures[1]), 0);
  EXPECT_EQ(structures[1].Count(), 2);
  EXPECT_TRUE(HasVertex(structures[2], left));
  EXPECT_FALSE(DoSidesMeet(MakeGrid(), structures));
}

/// Places on both lines next to a vertex of M are on the rims of the strips across.
TEST(ClearLines, CornersOfCellsAreClearedFromBothSides)
{
  const double tiny = 0.25 * Margin;
  std::vector<Contours> structures{ MakeContour(
    { { 10.0 + tiny, Height + tiny }, { 4.0, 8.0 }, { 10.0 + tiny, Height - 3.0 * tiny } }) };
  ClearLines(MakeGrid(), Execution(), { structures.data() });
  const Contours& cleared = structures.front();
  for (std::size_t i = 0; i < cleared.U.size(); ++i)
  {
    const double u = std::abs(cleared.U[i] - 10.0), v = std::abs(cleared.V[i] - Height);
    EXPECT_TRUE(u == 0.0 || u > 0.999 * Margin) << u;
    EXPECT_TRUE(v == 0.0 || v > 0.999 * Margin) << v;
    EXPECT_TRUE(u > 0.0 || v > 0.0);
  }
}

TEST(SideMeetings, CommonSidesAreNone)
{
  const std::vector<Contours> apart = MeetIn({ 3.0, 6.0 });
  EXPECT_FALSE(DoSidesMeet(MakeGrid(), apart));
  std::vector<Contours> crossing = apart;
  crossing[2].U[0] += 0.1; // into the second one
  EXPECT_TRUE(DoSidesMeet(MakeGrid(), crossing));
  std::vector<Contours> touching = apart;
  touching[2] = MakeContour({ { 3.0, 6.0 }, { 3.5, 7.5 }, { 2.0, 9.0 } });
  EXPECT_TRUE(DoSidesMeet(MakeGrid(), touching));
}

/// A graph takes contours off the border of their face, which may make them cross others.
TEST(SideMeetings, ContoursWithoutNodesAreOffTheBorderOfTheirFace)
{
  const Point2 place{ 3.0, Height };
  const std::vector<Contours> structures{
    MakeContour({ { 1.0, 1.0 }, { 3.0, 1.0 }, place, { 9.0, 5.5 }, { 1.0, 9.0 } }),
    MakeContour({ place, { 9.0, 5.2 }, { 9.0, 5.4 } })
  };
  EXPECT_FALSE(DoSidesMeet(SpatialGrid(), structures));
  EXPECT_TRUE(DoSidesMeet(MakeGrid(), structures));
}
