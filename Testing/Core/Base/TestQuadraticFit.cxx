// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/QuadraticFit.h"

#include "Core/Base/Vectors.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Height = 1.25;

double Paraboloid(double x, double y)
{
  return Height + 0.5 * x - 2.0 * y + 0.7 * x * x - 0.3 * x * y + 1.1 * y * y;
}

Point3 NormalOfParaboloid(double x, double y)
{
  return Unit({ -(0.5 + 1.4 * x - 0.3 * y), 2.0 + 0.3 * x - 2.2 * y, 1.0 });
}
}

//----------------------------------------------------------------------------
TEST(QuadraticFit, FindsAParaboloidFromPoints)
{
  Random random(1);
  QuadraticFit fit;
  for (int i = 0; i < 40; ++i)
  {
    const double x = random.Uniform(-1.0, 1.0), y = random.Uniform(-1.0, 1.0);
    fit.AddPoint(x, y, Paraboloid(x, y), random.Uniform(0.5, 2.0));
  }
  EXPECT_NEAR(fit.HeightAtOrigin(), Height, 1e-5);
}

//----------------------------------------------------------------------------
TEST(QuadraticFit, NormalsStandForPointsThatAreMissing)
{
  // Three points do not determine a paraboloid; with the normals there they do.
  QuadraticFit fit, withoutNormals;
  for (const Point2& p : { Point2{ 1.0, 0.2 }, { -0.7, 0.9 }, { -0.4, -1.0 } })
  {
    fit.AddPoint(p[0], p[1], Paraboloid(p[0], p[1]), 1.0);
    fit.AddNormal(p[0], p[1], NormalOfParaboloid(p[0], p[1]), 1.0);
    withoutNormals.AddPoint(p[0], p[1], Paraboloid(p[0], p[1]), 1.0);
  }
  EXPECT_NEAR(fit.HeightAtOrigin(), Height, 1e-4);
  EXPECT_GT(std::abs(withoutNormals.HeightAtOrigin() - Height), 0.1);
}

//----------------------------------------------------------------------------
TEST(QuadraticFit, WeightsDecideBetweenContradictions)
{
  QuadraticFit fit;
  for (const double x : { -1.0, 0.0, 1.0 })
  {
    for (const double y : { -1.0, 0.0, 1.0 })
    {
      fit.AddPoint(x, y, 1.0, 3.0);
      fit.AddPoint(x, y, 5.0, 1.0);
    }
  }
  EXPECT_NEAR(fit.HeightAtOrigin(), 2.0, 1e-5);
}

//----------------------------------------------------------------------------
TEST(QuadraticFit, IsZeroWithoutData) { EXPECT_EQ(QuadraticFit().HeightAtOrigin(), 0.0); }
