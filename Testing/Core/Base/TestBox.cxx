// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Box.h"

#include <gtest/gtest.h>

using namespace orthoslices;

//----------------------------------------------------------------------------
TEST(Box, GrowsAroundPoints)
{
  Box3 box;
  EXPECT_FALSE(std::isfinite(box.Diagonal()));
  box.Add(Point3{ 1, 5, 2 });
  EXPECT_EQ(box.Diagonal(), 0.0);
  box.Add(Point3{ 3, 2, 8 });
  EXPECT_EQ(box.Low, (Point3{ 1, 2, 2 }));
  EXPECT_EQ(box.High, (Point3{ 3, 5, 8 }));
  EXPECT_EQ(box.Diagonal(), 7.0);
  box.Add(1, -4.0);
  EXPECT_EQ(box.Low, (Point3{ 1, -4, 2 }));
  EXPECT_EQ(box.High, (Point3{ 3, 5, 8 }));
  Box3 around;
  around.Add(Point3{ 2, 9, 2 });
  around.Add(box);
  EXPECT_EQ(around.Low, box.Low);
  EXPECT_EQ(around.High, (Point3{ 3, 9, 8 }));
}

//----------------------------------------------------------------------------
TEST(Box, MeetsWhatItTouchesAlongAllAxes)
{
  Box3 box;
  box.Add(Point3{ 0, 0, 0 });
  box.Add(Point3{ 1, 1, 1 });
  for (int axis = 0; axis < 3; ++axis)
  {
    Point3 place{ 0.5, 0.5, 0.5 };
    for (const auto& [x, meets] :
      { std::pair{ -0.1, false }, { 0.0, true }, { 1.0, true }, { 1.1, false } })
    {
      place[axis] = x;
      Box3 other;
      other.Add(place);
      EXPECT_EQ(box.Meets(other), meets);
      EXPECT_EQ(other.Meets(box), meets);
      EXPECT_EQ(box.Meets(other, axis), meets);
      EXPECT_TRUE(box.Meets(other, (axis + 1) % 3));
    }
  }
  EXPECT_FALSE(box.Meets(Box3()));
}
