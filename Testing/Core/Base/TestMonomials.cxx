// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Monomials.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;

//----------------------------------------------------------------------------
TEST(Monomials, AreNumberedByDegree)
{
  EXPECT_EQ(MonomialCount(0), 1);
  EXPECT_EQ(MonomialCount(4), 15);
  int expected = 0;
  ForMonomials(4,
    [&](int number, int i, int j)
    {
      EXPECT_EQ(number, expected++);
      EXPECT_EQ(number, MonomialNumber(i, j));
      EXPECT_GE(number, MonomialCount(i + j - 1));
      EXPECT_LT(number, MonomialCount(i + j));
    });
  EXPECT_EQ(expected, MonomialCount(4));
}

//----------------------------------------------------------------------------
TEST(Monomials, AreProductsOfPowers)
{
  double values[MonomialCount(5)];
  EvaluateMonomials(1.7, -0.6, 3.0, values);
  ForMonomials(5,
    [&](int number, int i, int j)
    { EXPECT_NEAR(values[number], 3.0 * std::pow(1.7, i) * std::pow(-0.6, j), 1e-12); });
}
