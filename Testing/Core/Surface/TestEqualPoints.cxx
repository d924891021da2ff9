// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/EqualPoints.h"

#include <gtest/gtest.h>

using namespace orthoslices;

TEST(EqualPoints, CountsThoseThatFloatDoesNotTellApart)
{
  const double points[] = { 1.0, 2.0, 3.0, 1.0 + 1e-12, 2.0, 3.0, 1.001, 2.0, 3.0, 1.0, 2.0,
    3.0 - 1e-12 };
  EXPECT_EQ(CountEqualInFloat(points, 4), 2);
  EXPECT_EQ(CountEqualInFloat(points, 1), 0);
  const float floats[] = { 1.0f, 2.0f, 3.0f, 1.0000001f, 2.0f, 3.0f };
  EXPECT_EQ(CountEqualInFloat(floats, 2), 0);
}
