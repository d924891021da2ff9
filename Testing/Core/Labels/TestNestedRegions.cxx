// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/InsertedContours.h"
#include "Core/Labels/NestedRegions.h"

#include "Core/Base/EditContours.h"

#include <gtest/gtest.h>

using namespace orthoslices;

namespace
{
void AddRectangle(double left, double right, std::int64_t cell, double plane, Contours& contours)
{
  const std::vector<Point2> corners{ { left, 0 }, { right, 0 }, { right, 1 }, { left, 1 } };
  for (const Point2& p : corners)
  {
    contours.U.push_back(p[0]);
    contours.V.push_back(p[1]);
  }
  contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
  contours.Axis.push_back(2);
  contours.Coordinate.push_back(plane);
  contours.Plane.push_back(0);
  contours.Cell.push_back(cell);
}

Contours Rectangle(double left, double right, std::int64_t cell = 0)
{
  Contours contours;
  AddRectangle(left, right, cell, 1.0, contours);
  return contours;
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

const OrderedSets Sets{ {}, { 0 }, { 1 } };
const std::array<std::vector<double>, 3> NoPlanes;
}

TEST(NestedRegions, AreOneWithinTheOther)
{
  const Contours first = Rectangle(0, 2), second = Rectangle(2, 3);
  const std::vector<Contours> regions = NestRegions(Sets, Execution(), { &first, &second });
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_DOUBLE_EQ(AreaOf(regions[0]), 3.0);
  EXPECT_DOUBLE_EQ(AreaOf(regions[1]), 1.0);
}

TEST(NestedRegions, GiveTheStructuresBack)
{
  Contours first = Rectangle(0, 2, 7), second = Rectangle(2, 3, 8);
  const std::vector<Contours> regions = NestRegions(Sets, Execution(), { &first, &second });
  ASSERT_TRUE(PartRegions({ Sets, NoPlanes, 0.0 }, Execution(), regions, { &first, &second }));
  EXPECT_DOUBLE_EQ(AreaOf(first), 2.0);
  EXPECT_DOUBLE_EQ(AreaOf(second), 1.0);
  EXPECT_EQ(first.Cell, (std::vector<std::int64_t>{ 7 }));
  EXPECT_EQ(second.Cell, (std::vector<std::int64_t>{ 8 }));
}

/// Whatever regions have become, no place has two structures, and none is lost that the last
/// region has.
TEST(NestedRegions, PartWithoutOverlapOrGap)
{
  Contours first = Rectangle(0, 2), second = Rectangle(2, 3);
  const std::vector<Contours> regions{ Rectangle(0, 2.5), Rectangle(1.5, 3) };
  ASSERT_TRUE(PartRegions({ Sets, NoPlanes, 0.0 }, Execution(), regions, { &first, &second }));
  EXPECT_DOUBLE_EQ(AreaOf(first), 1.5);
  EXPECT_DOUBLE_EQ(AreaOf(second), 1.5);
}

TEST(InsertedContours, GiveWayToOthers)
{
  const Contours drawn = Rectangle(0, 2), inserted = Rectangle(1, 3, -1);
  const auto marked = FindContradictedInsertions(0.0, { &drawn, &inserted }, Execution());
  EXPECT_EQ(marked, (std::vector<std::vector<std::uint8_t>>{ { 0 }, { 1 } }));
}

TEST(InsertedContours, MayBeWhereNothingIs)
{
  const Contours drawn = Rectangle(0, 2), inserted = Rectangle(2, 3, -1);
  const auto marked = FindContradictedInsertions(0.0, { &drawn, &inserted }, Execution());
  EXPECT_EQ(marked, (std::vector<std::vector<std::uint8_t>>{ { 0 }, { 0 } }));
}

/// Structures that are drawn within each other on one slice may be so on another one.
TEST(InsertedContours, MayBeWithinWhatTheyAreWithinElsewhere)
{
  Contours outer = Rectangle(0, 3);
  AddRectangle(0, 3, 1, 2.0, outer);
  Contours inner = Rectangle(1, 2);
  AddRectangle(1, 2, -1, 2.0, inner);
  const auto marked = FindContradictedInsertions(0.0, { &outer, &inner }, Execution());
  EXPECT_EQ(marked, (std::vector<std::vector<std::uint8_t>>{ { 0, 0 }, { 0, 0 } }));
}
