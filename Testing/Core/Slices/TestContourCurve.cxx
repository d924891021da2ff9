// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/ContourCurve.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Points of an ellipse at given angles.
std::vector<Point2> Ellipse(double a, double b, const std::vector<double>& angles)
{
  std::vector<Point2> points;
  for (const double t : angles)
  {
    points.push_back({ a * std::cos(t), b * std::sin(t) });
  }
  return points;
}

std::vector<double> EqualAngles(int count)
{
  std::vector<double> angles;
  for (int i = 0; i < count; ++i)
  {
    angles.push_back(2.0 * Pi * i / count);
  }
  return angles;
}

std::vector<double> RandomAngles(int count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<double> angles = EqualAngles(count);
  for (double& angle : angles)
  {
    angle += random.Uniform(-0.45, 0.45) * 2.0 * Pi / count;
  }
  return angles;
}

/// Each side of the square from 0 to 1 in equal parts.
std::vector<Point2> Square(int parts)
{
  const Point2 corners[4] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  std::vector<Point2> points;
  for (int side = 0; side < 4; ++side)
  {
    const Point2 &p = corners[side], &q = corners[(side + 1) % 4];
    for (int i = 0; i < parts; ++i)
    {
      const double t = double(i) / parts;
      points.push_back({ p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]) });
    }
  }
  return points;
}

ContourCurve CurveOf(std::vector<Point2> points)
{
  ContourCurve curve;
  curve.Set(std::move(points));
  return curve;
}

/// The greatest angle between the tangents of fits and those of the ellipse.
double TangentError(
  const ContourCurve& curve, double a, double b, const std::vector<double>& angles, double window)
{
  double worst = 0.0;
  for (Index i = 0; i < curve.Count(); ++i)
  {
    const Point2 tangent = curve.FitAt(i, window).Tangent;
    EXPECT_NEAR(std::hypot(tangent[0], tangent[1]), 1.0, 1e-12);
    const double u = -a * std::sin(angles[i]), v = b * std::cos(angles[i]);
    worst = std::max(worst,
      std::abs(std::atan2(tangent[1] * u - tangent[0] * v, tangent[0] * u + tangent[1] * v)));
  }
  return worst;
}

std::vector<Point2> WithNoise(std::vector<Point2> points, double maximum, std::uint64_t seed)
{
  Random random(seed);
  for (Point2& p : points)
  {
    p[0] += random.Uniform(-maximum, maximum);
    p[1] += random.Uniform(-maximum, maximum);
  }
  return points;
}

std::vector<Index> CornersOf(const ContourCurve& curve)
{
  std::vector<Index> corners;
  for (Index i = 0; i < curve.Count(); ++i)
  {
    if (curve.IsCorner(i))
    {
      corners.push_back(i);
    }
  }
  return corners;
}
}

//----------------------------------------------------------------------------
TEST(ContourCurve, MeasuresLengths)
{
  const ContourCurve curve = CurveOf({ { 0, 0 }, { 3, 0 }, { 3, 4 } });
  ASSERT_EQ(curve.Count(), 3);
  EXPECT_EQ(curve.LengthTo(0), 0.0);
  EXPECT_EQ(curve.LengthTo(1), 3.0);
  EXPECT_EQ(curve.LengthTo(2), 7.0);
  EXPECT_EQ(curve.LengthTo(3), 12.0);
  EXPECT_EQ(curve[2], (Point2{ 3, 4 }));
  EXPECT_FALSE(curve.HasCorners());
}

//----------------------------------------------------------------------------
TEST(ContourCurve, TangentsOfACircleAreExact)
{
  const std::vector<double> angles = EqualAngles(80);
  const ContourCurve curve = CurveOf(Ellipse(2.0, 2.0, angles));
  EXPECT_LT(TangentError(curve, 2.0, 2.0, angles, 0.8), 1e-9);
}

//----------------------------------------------------------------------------
/// With half the window the error of a cubic's slope falls eightfold or more.
TEST(ContourCurve, ErrorOnAnEllipseFallsWithTheCubeOfTheWindow)
{
  for (const bool regular : { true, false })
  {
    const std::vector<double> angles = regular ? EqualAngles(1200) : RandomAngles(1200, 3);
    const ContourCurve curve = CurveOf(Ellipse(2.0, 1.0, angles));
    const double coarse = TangentError(curve, 2.0, 1.0, angles, 0.4);
    const double fine = TangentError(curve, 2.0, 1.0, angles, 0.2);
    EXPECT_GT(coarse, 7.0 * fine);
    EXPECT_LT(coarse, 0.03);
  }
}

//----------------------------------------------------------------------------
TEST(ContourCurve, PlacesLieOnTheCurve)
{
  const std::vector<double> angles = RandomAngles(200, 1);
  const ContourCurve curve = CurveOf(Ellipse(1.0, 1.0, angles));
  for (Index i = 0; i < curve.Count(); ++i)
  {
    const ContourCurve::Fit fit = curve.FitAt(i, 0.2);
    EXPECT_NEAR(std::hypot(fit.Place[0], fit.Place[1]), 1.0, 2e-4);
    EXPECT_NEAR(std::hypot(fit.Place[0] - curve[i][0], fit.Place[1] - curve[i][1]), 0.0, 2e-4);
    EXPECT_LT(fit.Residual, 2e-4);
  }
}

//----------------------------------------------------------------------------
TEST(ContourCurve, ResidualIsTheNoise)
{
  constexpr double maximum = 0.01; // in each coordinate, root mean square most / sqrt(3)
  const ContourCurve curve = CurveOf(WithNoise(Ellipse(1.0, 1.0, EqualAngles(800)), maximum, 1));
  double sum = 0.0;
  for (Index i = 0; i < curve.Count(); ++i)
  {
    const double residual = curve.FitAt(i, 0.4).Residual;
    sum += residual * residual;
  }
  EXPECT_NEAR(std::sqrt(sum / curve.Count()), maximum * std::sqrt(2.0 / 3.0), 0.15 * maximum);
}

//----------------------------------------------------------------------------
TEST(ContourCurve, NoiseIsTheMedianResidual)
{
  constexpr double maximum = 0.01;
  std::vector<Point2> points = WithNoise(Ellipse(1.0, 1.0, EqualAngles(800)), maximum, 3);
  points[100] = { 3.0, 3.0 }; // one bad point says nothing of the others
  EXPECT_NEAR(
    CurveOf(std::move(points)).FindNoise(0.4), maximum * std::sqrt(2.0 / 3.0), 0.25 * maximum);
  EXPECT_LT(CurveOf(Ellipse(1.0, 1.0, RandomAngles(300, 2))).FindNoise(0.2), 1e-4);
}

//----------------------------------------------------------------------------
MeasuredCurve Measure(std::vector<Point2> points, double spacing)
{
  MeasuredCurve measured;
  measured.Set(std::move(points), spacing, 1.05);
  return measured;
}

//----------------------------------------------------------------------------
/// However few vertices there are: without corners, these would be noise.
TEST(MeasuredCurve, FindsTheCornersOfASquare)
{
  for (const int parts : { 1, 2, 3, 10, 40 })
  {
    const MeasuredCurve measured = Measure(Square(parts), 0.3);
    EXPECT_EQ(CornersOf(measured.Curve), (std::vector<Index>{ 0, parts, 2 * parts, 3 * parts }))
      << parts;
    EXPECT_LT(measured.Noise, 1e-6);
  }
}

//----------------------------------------------------------------------------
TEST(MeasuredCurve, NoiseMakesNoCorners)
{
  for (const double noise : { 0.001, 0.01, 0.03 })
  {
    for (const int count : { 40, 400 })
    {
      const MeasuredCurve measured =
        Measure(WithNoise(Ellipse(1.0, 0.8, EqualAngles(count)), noise, 8), 0.3);
      EXPECT_LE(CornersOf(measured.Curve).size(), 2u) << noise << ", " << count;
      EXPECT_FALSE(measured.Curve.IsExact());
    }
  }
}

//----------------------------------------------------------------------------
TEST(MeasuredCurve, PointsOfASmoothCurveAreExact)
{
  EXPECT_TRUE(Measure(Ellipse(1.0, 0.8, EqualAngles(200)), 0.3).Curve.IsExact());
  EXPECT_FALSE(Measure(Ellipse(1.0, 0.8, EqualAngles(12)), 0.3).Curve.IsExact()); // too few to tell
}

//----------------------------------------------------------------------------
TEST(MeasuredCurve, WindowIsTheLeastWithoutNoise)
{
  const std::vector<Point2> points = Ellipse(1.0, 1.0, RandomAngles(2000, 2));
  EXPECT_DOUBLE_EQ(Measure(points, 0.2).Window, Measure(Square(1000), 0.2).Window);
}

//----------------------------------------------------------------------------
TEST(MeasuredCurve, WindowGrowsWithTheNoiseToTheMost)
{
  constexpr double spacing = 0.2;
  const auto window = [&](double noise)
  { return Measure(WithNoise(Ellipse(1.0, 1.0, EqualAngles(800)), noise, 4), spacing).Window; };
  EXPECT_LT(window(0.0), window(0.001));
  EXPECT_LT(window(0.001), window(0.004));
  EXPECT_LE(window(0.004), window(0.02));
  EXPECT_DOUBLE_EQ(window(0.02), window(0.03));
  EXPECT_LE(window(0.03), 2.0 * spacing);
}

//----------------------------------------------------------------------------
TEST(MeasuredCurve, WindowMeasuresNoisyTangentsBetter)
{
  const std::vector<double> angles = EqualAngles(300);
  const MeasuredCurve measured = Measure(WithNoise(Ellipse(1.0, 1.0, angles), 0.01, 5), 0.3);
  EXPECT_LT(TangentError(measured.Curve, 1.0, 1.0, angles, measured.Window),
    0.6 * TangentError(measured.Curve, 1.0, 1.0, angles, 0.1));
}

//----------------------------------------------------------------------------
TEST(ContourCurve, FindsTheCornersOfASquare)
{
  for (const int parts : { 1, 2, 3, 10, 40 })
  {
    ContourCurve curve = CurveOf(Square(parts));
    curve.FindCorners(1.0, 0.0, 1.05);
    EXPECT_EQ(CornersOf(curve), (std::vector<Index>{ 0, parts, 2 * parts, 3 * parts })) << parts;
    EXPECT_TRUE(curve.HasCorners());
    curve.FindCorners(1.0, 0.0, 1.6); // more than a right angle
    EXPECT_FALSE(curve.HasCorners());
  }
}

//----------------------------------------------------------------------------
TEST(ContourCurve, NewPointsHaveNoCorners)
{
  ContourCurve curve = CurveOf(Square(4));
  curve.FindCorners(1.0, 0.0, 1.05);
  ASSERT_TRUE(curve.HasCorners());
  curve.Set(Square(4));
  EXPECT_FALSE(curve.HasCorners());
  EXPECT_FALSE(curve.IsCorner(0));
}

//----------------------------------------------------------------------------
TEST(ContourCurve, SmoothAndNoisyCurvesHaveNoCorners)
{
  ContourCurve smooth = CurveOf(Ellipse(1.0, 0.6, RandomAngles(100, 6)));
  smooth.FindCorners(1.0, 0.0, 1.05);
  EXPECT_FALSE(smooth.HasCorners());
  // Points closer together than the noise turn sharply, but not over the reach.
  ContourCurve noisy = CurveOf(WithNoise(Ellipse(1.0, 0.6, EqualAngles(1000)), 0.006, 7));
  noisy.FindCorners(1.0, noisy.FindNoise(0.4), 1.05);
  EXPECT_FALSE(noisy.HasCorners());
}

//----------------------------------------------------------------------------
TEST(ContourCurve, TangentsDoNotReachAcrossCorners)
{
  constexpr int parts = 20;
  ContourCurve curve = CurveOf(Square(parts));
  curve.FindCorners(1.0, 0.0, 1.05);
  const Point2 directions[4] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
  for (Index i = 0; i < curve.Count(); ++i)
  {
    if (curve.IsCorner(i))
    {
      continue;
    }
    const ContourCurve::Fit fit = curve.FitAt(i, 0.4);
    EXPECT_NEAR(fit.Tangent[0], directions[i / parts][0], 1e-9);
    EXPECT_NEAR(fit.Tangent[1], directions[i / parts][1], 1e-9);
    EXPECT_NEAR(fit.Residual, 0.0, 1e-7);
  }
}

//----------------------------------------------------------------------------
TEST(ContourCurve, FewPointsDo)
{
  const ContourCurve triangle = CurveOf({ { 0, 0 }, { 1, 0 }, { 0, 1 } });
  for (Index i = 0; i < 3; ++i)
  {
    for (const double window : { 1e-6, 0.1, 100.0 })
    {
      const ContourCurve::Fit fit = triangle.FitAt(i, window);
      EXPECT_NEAR(std::hypot(fit.Tangent[0], fit.Tangent[1]), 1.0, 1e-12);
      const Point2 &p = triangle[(i + 2) % 3], &q = triangle[(i + 1) % 3];
      EXPECT_GT((q[0] - p[0]) * fit.Tangent[0] + (q[1] - p[1]) * fit.Tangent[1], 0.0);
    }
  }
}

//----------------------------------------------------------------------------
TEST(ContourCurve, OnePlaceHasNoTangent)
{
  const ContourCurve::Fit fit = CurveOf({ { 2, 1 }, { 2, 1 }, { 2, 1 } }).FitAt(0, 0.1);
  EXPECT_EQ(fit.Tangent, (Point2{ 0, 0 }));
  EXPECT_EQ(fit.Place, (Point2{ 2, 1 }));
  EXPECT_EQ(fit.Residual, 0.0);
}
