// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/ShareBorders.h"

#include "Core/Base/EditContours.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using support::HasVertex;

namespace
{
void AddContour(const std::vector<Point2>& corners, Contours& contours)
{
  support::AddContour(contours, corners, 1.0);
  contours.Plane.push_back(0);
}

Contours Rectangle(double left, double low, double right, double high)
{
  Contours contours;
  AddContour({ { left, low }, { right, low }, { right, high }, { left, high } }, contours);
  return contours;
}

SharedBorders Share(
  std::vector<Contours>& structures, double thickness = 0.01, const StructureSets& allowed = {})
{
  return ShareBorders(thickness, allowed, Execution(), PointersTo(structures));
}

double AreaOf(const Contours& contours)
{
  double area = 0.0;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    area += 0.5 * TwiceSignedArea(contours, i);
  }
  return area;
}
}

TEST(ShareBorders, WhatDoesNotMeetStaysAsItIs)
{
  std::vector<Contours> structures{ Rectangle(0, 0, 1, 1), Rectangle(2, 0, 3, 1) };
  const SharedBorders shared = Share(structures);
  EXPECT_EQ(structures[0].U, Rectangle(0, 0, 1, 1).U);
  EXPECT_EQ(structures[1].U, Rectangle(2, 0, 3, 1).U);
  EXPECT_TRUE(shared.Junctions.empty());
  EXPECT_EQ(shared.Sets, (StructureSets{ {}, { 0 }, { 1 } }));
  EXPECT_EQ(shared.Areas.OfStructure, (std::vector<double>{ 1.0, 1.0 }));
  EXPECT_EQ(shared.Union.Count(), 2);
}

/// A corner on the side of another structure becomes a vertex of both.
TEST(ShareBorders, VerticesOnCommonSidesAreCommon)
{
  std::vector<Contours> structures{ Rectangle(0, 0, 1, 3), Rectangle(1, 1, 2, 2) };
  const SharedBorders shared = Share(structures);
  EXPECT_TRUE(HasVertex(structures[0], { 1, 1 }));
  EXPECT_TRUE(HasVertex(structures[0], { 1, 2 }));
  EXPECT_EQ(structures[0].Cell[0], 0);
  EXPECT_EQ(structures[1].Size(0), 4);
  EXPECT_EQ(shared.Junctions, (std::set<Point3>{ { 1, 1, 1 }, { 1, 2, 1 } }));
  EXPECT_EQ(shared.Union.Count(), 1);
  EXPECT_DOUBLE_EQ(AreaOf(shared.Union), 4.0);
}

/// Narrow gaps and overlaps vanish, and the first structure stays as it is.
TEST(ShareBorders, SliversGoToTheLaterStructure)
{
  for (const double left : { 0.996, 1.0, 1.004 })
  {
    std::vector<Contours> structures{ Rectangle(0, 0, 1, 1), Rectangle(left, 0, 2, 1) };
    const SharedBorders shared = Share(structures);
    EXPECT_DOUBLE_EQ(AreaOf(structures[0]), 1.0) << left;
    EXPECT_DOUBLE_EQ(AreaOf(structures[1]), 1.0) << left;
    EXPECT_DOUBLE_EQ(AreaOf(shared.Union), 2.0) << left;
    EXPECT_EQ(shared.Areas.OfPair.size(), 0u) << left;
  }
}

TEST(ShareBorders, WideGapsAndOverlapsStay)
{
  for (const double left : { 0.9, 1.1 })
  {
    std::vector<Contours> structures{ Rectangle(0, 0, 1, 1), Rectangle(left, 0, 2, 1) };
    const SharedBorders shared = Share(structures);
    EXPECT_DOUBLE_EQ(AreaOf(structures[0]), 1.0);
    EXPECT_DOUBLE_EQ(AreaOf(structures[1]), 2.0 - left);
    EXPECT_EQ(shared.Areas.OfPair.size(), left < 1.0 ? 1u : 0u);
  }
}

/// What is outside of the first structure, or in two others at once, is not allowed and goes away;
/// what is in none of them but the first one goes to the last.
TEST(ShareBorders, SetsThatAreNotAllowedGoToNeighbours)
{
  const StructureSets allowed{ {}, { 0, 1 }, { 0, 2 } };
  for (const double left : { 0.8, 1.2 })
  {
    std::vector<Contours> structures{ Rectangle(0, 0, 2, 1), Rectangle(-0.1, 0, 1, 1),
      Rectangle(left, 0, 2.2, 1) };
    Share(structures, 0.0, allowed);
    EXPECT_DOUBLE_EQ(AreaOf(structures[0]), 2.0) << left;
    EXPECT_DOUBLE_EQ(AreaOf(structures[1]), 1.0) << left;
    EXPECT_DOUBLE_EQ(AreaOf(structures[2]), 1.0) << left;
  }
}

/// A structure within another one is not cut out of it.
TEST(ShareBorders, NestedStructuresStay)
{
  std::vector<Contours> structures{ Rectangle(0, 0, 4, 4), Rectangle(0, 1, 2, 2) };
  const SharedBorders shared = Share(structures);
  EXPECT_DOUBLE_EQ(AreaOf(structures[0]), 16.0);
  EXPECT_DOUBLE_EQ(AreaOf(structures[1]), 2.0);
  EXPECT_EQ(shared.Sets, (StructureSets{ {}, { 0 }, { 0, 1 } }));
}

/// A contour that is a sliver beside another structure's goes away, and is counted; so is one that
/// is moved onto that structure as a whole. What lies apart is none, however thin it is.
TEST(ShareBorders, WhatVanishesIsCounted)
{
  std::vector<Contours> structures{ Rectangle(0, 0, 1, 1), Rectangle(1, 0.2, 1.004, 0.8),
    Rectangle(2, 0, 2.004, 1) };
  AddContour({ { 1, 2 }, { 3, 2 }, { 3, 3 }, { 1, 3 } }, structures[1]);
  const SharedBorders shared = Share(structures);
  EXPECT_EQ(shared.Vanished, (std::vector<Index>{ 0, 1, 0 }));
  EXPECT_EQ(structures[1].Count(), 1);
  EXPECT_EQ(structures[2].Count(), 1);
}

namespace
{
/// A polygon turned by an angle that leaves no coordinate on those of others.
std::vector<Point2> Turn(std::vector<Point2> polygon)
{
  for (Point2& p : polygon)
  {
    p = { 0.8 * p[0] - 0.6 * p[1], 0.6 * p[0] + 0.8 * p[1] };
  }
  return polygon;
}

/// Squares in opposite quarters, whose corners in the middle are cut off.
Contours OppositeSquares()
{
  Contours contours;
  AddContour(Turn({ { 0.004, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, 0.004 } }), contours);
  AddContour(Turn({ { -0.004, 0 }, { -1, 0 }, { -1, -1 }, { 0, -1 }, { 0, -0.004 } }), contours);
  return contours;
}

Contours ContourOf(const std::vector<Point2>& polygon)
{
  Contours contours;
  AddContour(Turn(polygon), contours);
  return contours;
}

/// Sharing borders once more changes nothing: no structure lacks a vertex of another one.
SharedBorders ExpectShared(const std::vector<Contours>& structures)
{
  std::vector<Contours> again = structures;
  SharedBorders found = Share(again, 0.0);
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    EXPECT_EQ(again[i].U, structures[i].U) << i;
    EXPECT_EQ(again[i].V, structures[i].V) << i;
  }
  return found;
}

void ExpectParted(std::vector<Contours> structures, double thickness)
{
  const SharedBorders first = Share(structures, thickness);
  const SharedBorders second = ExpectShared(structures);
  EXPECT_TRUE(std::includes(first.Junctions.begin(), first.Junctions.end(),
    second.Junctions.begin(), second.Junctions.end()));
  EXPECT_GE(second.Junctions.size(), 4u + 4u); // outside, and where the corners were
}
}

/// Where a structure touches itself, as gaps between borders vanish, corners are cut off, and all
/// have the vertices there: where two touch themselves, and where one does.
TEST(ShareBorders, CornersThatTouchPartAlike)
{
  const Contours left = ContourOf({ { 0, 0 }, { 0, 1 }, { -1, 1 }, { -1, 0 } });
  const Contours right = ContourOf({ { 0, 0 }, { 0, -1 }, { 1, -1 }, { 1, 0 } });
  Contours both = left;
  AppendContours(right, both);
  for (const double thickness : { 0.002, 0.01 }) // corners do not move onto others, or do
  {
    ExpectParted({ left, right, OppositeSquares() }, thickness);
    ExpectParted({ both, OppositeSquares() }, thickness);
  }
}

/// Nor do corners of others within one that is cut off stay behind: holes whose corners touch, with
/// two structures in one of them.
TEST(ShareBorders, CornersWithinOthersArePartedToo)
{
  std::vector<Contours> structures{ ContourOf({ { 0, 0 }, { 1, 0 }, { 1, 1 } }),
    ContourOf({ { 0, 0 }, { 1, 1 }, { 0, 1 } }),
    ContourOf({ { -2, -2 }, { 2, -2 }, { 2, 2 }, { -2, 2 } }) };
  AddContour(Turn({ { 0.004, 0 }, { 0, 0.004 }, { 0, 1 }, { 1, 1 }, { 1, 0 } }), structures[2]);
  AddContour(Turn({ { 0, 0 }, { 0, -1 }, { -1, -1 }, { -1, 0 } }), structures[2]);
  Share(structures, 0.002);
  EXPECT_EQ(structures[2].Count(), 3);
  EXPECT_FALSE(HasVertex(structures[0], { 0, 0 }));
  EXPECT_FALSE(HasVertex(structures[1], { 0, 0 }));
  ExpectShared(structures);
}
