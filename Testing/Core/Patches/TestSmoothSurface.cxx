// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/SmoothSurface.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// A border over a square or a curve around the origin, with weights.
struct Border
{
  std::vector<Point3> Zeros, Gradients;
  std::vector<double> Weights;

  void Add(const Point3& zero, const Point3& gradient)
  {
    this->Zeros.push_back(zero);
    this->Gradients.push_back(gradient);
    this->Weights.assign(this->Zeros.size(), 1.0 / this->Zeros.size());
  }
  bool FitTo(SmoothSurface& surface) const
  {
    return surface.Fit(this->Zeros, this->Gradients, this->Weights);
  }
};

/// A height and its derivatives.
using Height = std::array<double, 3> (*)(double x, double y);

Point2 OnSquare(int i, int count)
{
  const double t = 4.0 * i / count;
  const int side = static_cast<int>(t);
  const double s = 2.0 * (t - side) - 1.0;
  return side == 0 ? Point2{ s, -1 }
    : side == 1    ? Point2{ 1, s }
    : side == 2    ? Point2{ -s, 1 }
                   : Point2{ -1, -s };
}

Border OfHeight(Height height, int count = 60)
{
  Border border;
  for (int i = 0; i < count; ++i)
  {
    const Point2 p = OnSquare(i, count);
    const auto h = height(p[0], p[1]);
    border.Add({ p[0], p[1], h[0] }, { -h[1], -h[2], 1.0 });
  }
  return border;
}

/// The greatest value of the function on the graph of the height, inside the border.
double ErrorOf(const SmoothSurface& surface, Height height)
{
  Random random(1);
  double worst = 0.0;
  for (int i = 0; i < 500; ++i)
  {
    const double x = random.Uniform(-0.95, 0.95), y = random.Uniform(-0.95, 0.95);
    const auto h = height(x, y);
    Point3 gradient;
    worst = std::max(worst, std::abs(surface({ x, y, h[0] }, gradient)));
    worst = std::max(worst, std::abs(surface.Polynomial({ x, y, h[0] }, gradient)));
    const Point3 expected{ -h[1], -h[2], 1.0 };
    worst = std::max(worst, 0.3 * Length(gradient - expected));
  }
  return worst;
}

/// No surface that a polynomial could follow.
Border Wavy(std::uint64_t seed)
{
  Random random(seed);
  Border border;
  for (int i = 0; i < 24; ++i)
  {
    const double t = 2.0 * Pi * i / 24;
    const Point3 normal{ random.Uniform(-0.4, 0.4), random.Uniform(-0.4, 0.4), 1.0 };
    border.Add({ std::cos(t), std::sin(t), random.Uniform(-0.2, 0.2) }, Unit(normal));
  }
  return border;
}
}

//----------------------------------------------------------------------------
TEST(SmoothSurface, ReproducesPlanes)
{
  const Height height = [](double x, double y) -> std::array<double, 3> {
    return { 0.1 + 0.3 * x - 0.2 * y, 0.3, -0.2 };
  };
  SmoothSurface surface;
  ASSERT_TRUE(OfHeight(height).FitTo(surface));
  EXPECT_LT(ErrorOf(surface, height), 1e-9);
  EXPECT_LT(surface.Deviation(), 1e-9);
}

//----------------------------------------------------------------------------
TEST(SmoothSurface, ReproducesQuadratics)
{
  const Height height = [](double x, double y) -> std::array<double, 3> {
    return { 0.3 * x * x - 0.2 * x * y, 0.6 * x - 0.2 * y, -0.2 * x };
  };
  SmoothSurface surface;
  ASSERT_TRUE(OfHeight(height).FitTo(surface));
  EXPECT_LT(ErrorOf(surface, height), 1e-6);
}

//----------------------------------------------------------------------------
/// But for the little by which high degrees are held back.
TEST(SmoothSurface, ReproducesQuartics)
{
  const Height height = [](double x, double y) -> std::array<double, 3>
  {
    return { 0.2 * x * x * x * y - 0.1 * y * y * y + 0.1 * y * y * y * y, 0.6 * x * x * y,
      0.2 * x * x * x - 0.3 * y * y + 0.4 * y * y * y };
  };
  SmoothSurface surface;
  ASSERT_TRUE(OfHeight(height).FitTo(surface));
  EXPECT_LT(ErrorOf(surface, height), 1e-3);
  EXPECT_LT(surface.Deviation(), 1e-4);
}

//----------------------------------------------------------------------------
/// The border is that of a square; a circle, as the only curve, says nothing of the fourth degree.
TEST(SmoothSurface, ErrorOnASphereFallsWithMoreThanTheFourthPowerOfTheSize)
{
  const auto errorOf = [](double size)
  {
    // A piece of a unit sphere in units of its size.
    const auto depth = [size](double x, double y)
    { return (1.0 - std::sqrt(1.0 - size * size * (x * x + y * y))) / size; };
    Border border;
    for (int i = 0; i < 80; ++i)
    {
      const Point2 p = OnSquare(i, 80);
      const double z = depth(p[0], p[1]);
      border.Add({ p[0], p[1], -z }, { size * p[0], size * p[1], 1.0 - size * z });
    }
    SmoothSurface surface;
    EXPECT_TRUE(border.FitTo(surface));
    double worst = 0.0;
    for (double x = -0.9; x < 1.0; x += 0.1)
    {
      for (double y = -0.9; y < 1.0; y += 0.1)
      {
        Point3 gradient;
        worst = std::max(worst, size * std::abs(surface({ x, y, -depth(x, y) }, gradient)));
      }
    }
    return worst;
  };
  EXPECT_LT(errorOf(0.3), 2e-3);
  EXPECT_GT(errorOf(0.4), 16.0 * errorOf(0.2));
}

//----------------------------------------------------------------------------
TEST(SmoothSurface, HasTheGivenZerosAndGradients)
{
  for (std::uint64_t seed = 0; seed < 10; ++seed)
  {
    const Border border = Wavy(seed);
    SmoothSurface surface;
    ASSERT_TRUE(border.FitTo(surface));
    EXPECT_GT(surface.Deviation(), 1e-3);
    for (std::size_t i = 0; i < border.Zeros.size(); ++i)
    {
      Point3 gradient;
      EXPECT_NEAR(surface(border.Zeros[i], gradient), 0.0, 1e-9);
      EXPECT_LT(Length(gradient - border.Gradients[i]), 1e-9);
    }
  }
}

//----------------------------------------------------------------------------
TEST(SmoothSurface, GradientIsThatOfTheFunction)
{
  constexpr double step = 1e-6;
  Random random(2);
  SmoothSurface surface;
  ASSERT_TRUE(Wavy(1).FitTo(surface));
  for (int i = 0; i < 300; ++i)
  {
    const Point3 p{ random.Uniform(-0.6, 0.6), random.Uniform(-0.6, 0.6),
      random.Uniform(-0.3, 0.3) };
    Point3 gradient, ofPolynomial, unused;
    surface(p, gradient);
    surface.Polynomial(p, ofPolynomial);
    for (int axis = 0; axis < 3; ++axis)
    {
      Point3 a = p, b = p;
      a[axis] -= step;
      b[axis] += step;
      EXPECT_NEAR(gradient[axis], (surface(b, unused) - surface(a, unused)) / (2.0 * step), 1e-6);
      EXPECT_NEAR(ofPolynomial[axis],
        (surface.Polynomial(b, unused) - surface.Polynomial(a, unused)) / (2.0 * step), 1e-6);
    }
  }
}

//----------------------------------------------------------------------------
TEST(SmoothSurface, IsPositiveOutside)
{
  SmoothSurface surface;
  ASSERT_TRUE(Wavy(3).FitTo(surface));
  Point3 gradient;
  EXPECT_GT(surface({ 0.0, 0.0, 1.0 }, gradient), 0.5);
  EXPECT_LT(surface({ 0.0, 0.0, -1.0 }, gradient), -0.5);
}

//----------------------------------------------------------------------------
/// No peaks of the residual's making: it is a mean of what is given around.
TEST(SmoothSurface, CreaseIsNoSurfaceOfDegreeFour)
{
  Border border;
  for (int i = 0; i < 80; ++i)
  {
    const Point2 p = OnSquare(i, 80);
    const double slope = p[0] < 0.0 ? -1.0 : 1.0;
    border.Add({ p[0], p[1], -std::abs(p[0]) }, Unit({ slope, 0.0, 1.0 }));
  }
  SmoothSurface surface;
  ASSERT_TRUE(border.FitTo(surface));
  EXPECT_GT(surface.Deviation(), 0.02);
}
