// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/ContourEllipse.h"

#include "Support/ContourStacks.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;

ContourEllipse Fit(const std::string& text) { return FitEllipses(ParseStack("z=0: " + text))[0]; }
}

//----------------------------------------------------------------------------
TEST(ContourEllipse, OfAnEllipseIsItself)
{
  ContourStack stack = EmptyStack(1);
  std::vector<Point2> vertices;
  const double angle = 0.4;
  for (int i = 0; i < 500; ++i)
  {
    const double u = 3.0 * std::cos(Pi * i / 250.0), v = 0.5 * std::sin(Pi * i / 250.0);
    vertices.push_back({ 1e4 + u * std::cos(angle) - v * std::sin(angle),
      -7.0 + u * std::sin(angle) + v * std::cos(angle) });
  }
  AddContour(stack, 0, vertices);
  const ContourEllipse ellipse = FitEllipses(stack)[0];
  EXPECT_NEAR(ellipse.Center[0], 1e4, 1e-9);
  EXPECT_NEAR(ellipse.Center[1], -7.0, 1e-9);
  EXPECT_NEAR(ellipse.Major, 3.0, 1e-3);
  EXPECT_NEAR(ellipse.Minor, 0.5, 1e-3);
  EXPECT_NEAR(std::abs(ellipse.Direction[0]), std::cos(angle), 1e-9);
  EXPECT_NEAR(ellipse.Direction[0] * ellipse.Direction[1], std::cos(angle) * std::sin(angle), 1e-9);
  EXPECT_LT(ellipse.Misfit, 1e-3);
}

//----------------------------------------------------------------------------
// Moments a^2 / 12 of a rectangle are those of an ellipse with semi-axis a / sqrt(3). In units of
// the semi-axes, its corners reach beyond the circle where |x| > sqrt(1 - 3 / 4) = 1 / 2.
TEST(ContourEllipse, OfARectangle)
{
  const ContourEllipse ellipse = Fit("0,0 4,0 4,1 0,1");
  EXPECT_NEAR(ellipse.Center[0], 2.0, 1e-12);
  EXPECT_NEAR(ellipse.Center[1], 0.5, 1e-12);
  EXPECT_NEAR(ellipse.Major, 4.0 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(ellipse.Minor, 1.0 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(ellipse.Direction[1], 0.0, 1e-12);
  const double half = std::sqrt(3.0) / 2.0;
  // Four caps of the circle beyond the sides, each with the angle 2 acos(half) = Pi / 3.
  const double caps = 4.0 * 0.5 * (Pi / 3.0 - std::sin(Pi / 3.0));
  const double area = 4.0 * half * half;
  EXPECT_NEAR(ellipse.Misfit, (area + Pi - 2.0 * (Pi - caps)) / area, 1e-12);
  EXPECT_NEAR(ellipse.Misfit, 0.19, 0.005);
}

//----------------------------------------------------------------------------
TEST(ContourEllipse, DoesNotDependOnDirectionOrStart)
{
  const ContourEllipse one = Fit("0,0 4,0 5,3 0,1");
  const ContourEllipse other = Fit("5,3 4,0 0,0 0,1");
  EXPECT_NEAR(one.Center[0], other.Center[0], 1e-12);
  EXPECT_NEAR(one.Major, other.Major, 1e-12);
  EXPECT_NEAR(one.Minor, other.Minor, 1e-12);
  EXPECT_NEAR(one.Misfit, other.Misfit, 1e-12);
}

//----------------------------------------------------------------------------
TEST(ContourEllipse, ComplexContoursFitBadly)
{
  EXPECT_GT(Fit("0,0 3,0 3,3 0,3 0,2 2,2 2,1 0,1").Misfit, 0.3); // the letter C
  EXPECT_TRUE(std::isinf(Fit("0,0 1,0 2,0").Misfit));            // no area
}

//----------------------------------------------------------------------------
TEST(ContourEllipse, ShapeGivesTheEllipseBack)
{
  const ContourEllipse ellipse = Fit("0,0 4,0 5,3 0,1");
  const ContourEllipse again = EllipseOfShape(ellipse.Center, ellipse.Shape());
  EXPECT_NEAR(again.Major, ellipse.Major, 1e-12);
  EXPECT_NEAR(again.Minor, ellipse.Minor, 1e-12);
  EXPECT_NEAR(again.Direction[0], ellipse.Direction[0], 1e-12);
  EXPECT_EQ(EllipseOfShape({ 0, 0 }, { 1, 0, -1 }).Minor, 0.0);
}

//----------------------------------------------------------------------------
TEST(ContourEllipse, Overlap)
{
  const auto ellipse = [](double u, double v, double a, double b) {
    return EllipseOfShape({ u, v }, { a, 0, b });
  };
  EXPECT_TRUE(DoOverlap(ellipse(0, 0, 1, 1), ellipse(1.9, 0, 1, 1)));
  EXPECT_FALSE(DoOverlap(ellipse(0, 0, 1, 1), ellipse(2.1, 0, 1, 1)));
  EXPECT_FALSE(DoOverlap(ellipse(0, 0, 1, 1), ellipse(1.6, 1.6, 1, 1))); // boxes overlap
  EXPECT_TRUE(DoOverlap(ellipse(0, 0, 5, 5), ellipse(1, 1, 0.1, 0.1)));  // one in the other
  EXPECT_TRUE(DoOverlap(ellipse(1, 1, 0.1, 0.1), ellipse(0, 0, 5, 5)));
  EXPECT_TRUE(DoOverlap(ellipse(0, 0, 5, 0.2), ellipse(0, 0, 0.2, 5))); // a cross
}
