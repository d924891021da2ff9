// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Vectors.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(Vectors, InThePlane)
{
  const Point2 a{ 3, 4 }, b{ -2, 1 };
  EXPECT_EQ(a - b, (Point2{ 5, 3 }));
  EXPECT_EQ(a + b, (Point2{ 1, 5 }));
  EXPECT_EQ(2.0 * a, (Point2{ 6, 8 }));
  EXPECT_EQ(Dot(a, b), -2.0);
  EXPECT_EQ(Cross(a, b), 11.0); // b points to the left of a
  EXPECT_EQ(Cross(b, a), -11.0);
  EXPECT_EQ(Length(a), 5.0);
  EXPECT_DOUBLE_EQ(Length(1e200 * a), 5e200);
  EXPECT_EQ(SquaredDistance(a, b), 34.0);
  EXPECT_EQ(Distance(a, a + Point2{ 6, -8 }), 10.0);
  EXPECT_EQ(Between(a, b, 0.0), a);
  EXPECT_EQ(Between(a, b, 0.5), (Point2{ 0.5, 2.5 }));
  EXPECT_EQ(Between(a, b, 1.0), b);
}

//----------------------------------------------------------------------------
TEST(Vectors, InSpace)
{
  const Point3 a{ 1, 2, 2 }, b{ -2, 1, 5 };
  EXPECT_EQ(a - b, (Point3{ 3, 1, -3 }));
  EXPECT_EQ(a + b, (Point3{ -1, 3, 7 }));
  EXPECT_EQ(2.0 * a, (Point3{ 2, 4, 4 }));
  EXPECT_EQ(Dot(a, b), 10.0);
  EXPECT_EQ(Cross({ 1, 0, 0 }, Point3{ 0, 1, 0 }), (Point3{ 0, 0, 1 }));
  EXPECT_EQ(Cross(a, b), (Point3{ 8, -9, 5 }));
  EXPECT_EQ(Length(a), 3.0);
  EXPECT_EQ(SquaredDistance(a, b), 19.0);
  EXPECT_EQ(Between(a, b, 0.5), (Point3{ -0.5, 1.5, 3.5 }));
  EXPECT_EQ(Unit({ 0, 0, -4 }), (Point3{ 0, 0, -1 }));
  EXPECT_EQ(Unit({ 0, 0, 0 }), (Point3{ 0, 0, 0 }));
}

//----------------------------------------------------------------------------
TEST(Vectors, FramesAreRightHandedAndOfUnitVectors)
{
  Random random(1);
  for (int i = 0; i < 200; ++i)
  {
    const Point3 third = i < 3
      ? Point3{ double(i == 0), double(i == 1), double(i == 2) }
      : Unit({ random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0) });
    const std::array<Point3, 3> frame = CompleteFrame(third);
    EXPECT_EQ(frame[2], third);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(Length(frame[k]), 1.0, 1e-14);
      EXPECT_NEAR(
        SquaredDistance(Cross(frame[k], frame[(k + 1) % 3]), frame[(k + 2) % 3]), 0, 1e-28);
    }
  }
}

//----------------------------------------------------------------------------
TEST(Vectors, CentreOfACurveWeighsByLength)
{
  // A square with many points on one side: the centre stays in the middle.
  std::vector<Point3> points{ { 1, 0, 3 }, { 1, 1, 3 }, { 0, 1, 3 } };
  for (const double y : { 1.0, 0.9, 0.5, 0.4, 0.0 })
  {
    points.push_back({ 0, y, 3 });
  }
  points.erase(points.begin() + 3); // is there already
  std::vector<double> weights;
  const Point3 center = WeighByLength(points, weights);
  EXPECT_NEAR(SquaredDistance(center, { 0.5, 0.5, 3 }), 0.0, 1e-28);
  double sum = 0.0;
  for (const double weight : weights)
  {
    sum += weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-14);
  EXPECT_NEAR(weights[0], 0.25, 1e-14); // half of two sides, of four
  EXPECT_NEAR(weights[3], 0.5 * (0.1 + 0.4) / 4.0, 1e-14);

  const CurveCenter none({ 7, 8, 9 });
  EXPECT_EQ(none.Get(), (Point3{ 7, 8, 9 }));
  const std::vector<Point3> place(3, Point3{ 1, 2, 3 });
  EXPECT_EQ(WeighByLength(place, weights), place[0]);
  EXPECT_EQ(weights, std::vector<double>(3, 0.0));
}
