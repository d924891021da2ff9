// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/LeastSquares.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(LeastSquares, SolvesPositiveDefiniteSystems)
{
  Random random(1);
  for (int round = 0; round < 100; ++round)
  {
    // The matrix is the square of a random one, and a little more on the diagonal.
    constexpr int N = 5;
    double root[N][N], matrix[N][N], solution[N], right[N];
    for (int i = 0; i < N; ++i)
    {
      solution[i] = random.Uniform(-3.0, 3.0);
      for (int j = 0; j < N; ++j)
      {
        root[i][j] = random.Uniform(-1.0, 1.0);
      }
    }
    for (int i = 0; i < N; ++i)
    {
      for (int j = 0; j < N; ++j)
      {
        matrix[i][j] = i == j ? 0.1 : 0.0;
        for (int k = 0; k < N; ++k)
        {
          matrix[i][j] += root[i][k] * root[j][k];
        }
      }
    }
    for (int i = 0; i < N; ++i)
    {
      right[i] = 0.0;
      for (int j = 0; j < N; ++j)
      {
        right[i] += matrix[i][j] * solution[j];
      }
    }
    ASSERT_TRUE(Factorize(matrix));
    Substitute(matrix, right);
    for (int i = 0; i < N; ++i)
    {
      EXPECT_NEAR(right[i], solution[i], 1e-9);
    }
  }
}

//----------------------------------------------------------------------------
TEST(LeastSquares, RefusesWhatIsNotPositiveDefinite)
{
  double indefinite[2][2] = { { 1, 2 }, { 2, 1 } };
  EXPECT_FALSE(Factorize(indefinite));
  double singular[2][2] = { { 1, 1 }, { 1, 1 } };
  EXPECT_FALSE(Factorize(singular));
  double notANumber[1][1] = { { NAN } };
  EXPECT_FALSE(Factorize(notANumber));
}
