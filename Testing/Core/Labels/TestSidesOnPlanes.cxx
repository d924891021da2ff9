// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/SidesOnPlanes.h"

#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;

namespace
{
/// Adds a rectangle to the contours of a structure.
void Add(int axis, double plane, const Point2& low, const Point2& high, Contours& contours)
{
  const Point2 corners[] = { low, { high[0], low[1] }, high, { low[0], high[1] } };
  for (const Point2& p : corners)
  {
    contours.U.push_back(p[0]);
    contours.V.push_back(p[1]);
  }
  contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
  contours.Axis.push_back(static_cast<std::int8_t>(axis));
  contours.Coordinate.push_back(plane);
  contours.Plane.push_back(0);
  contours.Cell.push_back(0);
}

/// On the slice x = 0, a structure from z = 0 to `end` and another one on it. The slice z = 1 shows
/// one of them, or none.
struct Stack
{
  Stack(double end, int drawn)
  {
    Add(0, 0.0, { 0, 0 }, { 4, end }, this->Lower);
    Add(0, 0.0, { 0, end }, { 4, 2 }, this->Upper);
    if (drawn >= 0)
    {
      Add(2, 1.0, { -1, 0 }, { 1, 4 }, drawn == 0 ? this->Lower : this->Upper);
    }
    this->Grid.Planes = { { { 0.0 }, {}, { 1.0 } } };
    this->Grid.Step = { 1e-15, 1e-15, 1e-15 };
  }

  bool Settle() { return SettleSidesOnPlanes(this->Grid, 0.01, Execution(), { &Lower, &Upper }); }
  /// Where the first structure ends.
  double End() const { return *std::max_element(this->Lower.V.begin(), this->Lower.V.begin() + 4); }

  SpatialGrid Grid;
  Contours Lower, Upper;
};
}

TEST(SidesOnPlanes, StayWhereTheyAgree)
{
  EXPECT_FALSE(Stack(1.0, 0).Settle());   // above the plane by rule
  EXPECT_FALSE(Stack(0.999, 1).Settle()); // below
  EXPECT_FALSE(Stack(0.9, 0).Settle());   // not on the plane
}

TEST(SidesOnPlanes, GoWhereTheyAgree)
{
  Stack below(1.0, 1);
  EXPECT_TRUE(below.Settle());
  EXPECT_LT(below.End(), 1.0);
  EXPECT_GT(below.End(), 0.999);
  EXPECT_EQ(below.Upper.V[0], below.End()); // the same for both
  Stack above(0.999, 0);
  EXPECT_TRUE(above.Settle());
  EXPECT_EQ(above.End(), 1.0);
}

/// Where the slice shows none, one of them contradicts it on either side.
TEST(SidesOnPlanes, StayWhereNeitherSideAgrees) { EXPECT_FALSE(Stack(1.0, -1).Settle()); }
