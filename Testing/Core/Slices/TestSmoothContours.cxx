// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/SmoothContours.h"

#include "Support/Random.h"
#include "Support/TextContours.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double CornerAngle = 1.05;

/// Contours on planes one apart along each axis.
struct Drawing
{
  Contours Set;
  SpatialGrid Grid;

  explicit Drawing(
    const std::vector<std::vector<std::array<double, 2>>>& contours, bool singlePrecision = false)
  {
    std::string text;
    for (const char axis : { 'x', 'y', 'z' })
    {
      for (const char* plane : { "=0:", "=1:", "=2:" })
      {
        text += axis + std::string(plane) + " 0,0 2,0 0,2\n";
      }
    }
    this->Set = ParseContours(text);
    for (const auto& contour : contours)
    {
      for (const auto& p : contour)
      {
        this->Set.U.push_back(p[0]);
        this->Set.V.push_back(p[1]);
      }
      this->Set.Offsets.push_back(static_cast<Index>(this->Set.U.size()));
      this->Set.Axis.push_back(2);
      this->Set.Coordinate.push_back(1.0);
      this->Set.Plane.push_back(1);
      this->Set.Cell.push_back(static_cast<std::int64_t>(this->Set.Cell.size()));
    }
    this->Grid = BuildSpatialGrid(this->Set, 1e-9, singlePrecision);
  }

  void Smooth(double length, const Execution& execution = Execution())
  {
    SmoothContours(this->Grid, length, CornerAngle, execution, this->Set);
  }

  /// The vertices of the last contour.
  std::vector<std::array<double, 2>> Last() const
  {
    std::vector<std::array<double, 2>> vertices;
    const Index last = this->Set.Count() - 1;
    for (Index i = this->Set.Offsets[last]; i < this->Set.Offsets[last + 1]; ++i)
    {
      vertices.push_back({ this->Set.U[i], this->Set.V[i] });
    }
    return vertices;
  }
};

std::vector<std::array<double, 2>> Circle(int count, double noise, std::uint64_t seed)
{
  Random random(seed);
  std::vector<std::array<double, 2>> vertices;
  for (int i = 0; i < count; ++i)
  {
    const double t = 2.0 * Pi * i / count;
    const double radius = 1.0 + random.Uniform(-noise, noise);
    vertices.push_back({ 1.0 + radius * std::cos(t), 1.0 + radius * std::sin(t) });
  }
  return vertices;
}

/// Root mean square distance from the circle.
double ErrorOf(const std::vector<std::array<double, 2>>& vertices)
{
  double sum = 0.0;
  for (const auto& p : vertices)
  {
    const double distance = std::hypot(p[0] - 1.0, p[1] - 1.0) - 1.0;
    sum += distance * distance;
  }
  return std::sqrt(sum / static_cast<double>(vertices.size()));
}

bool HasDoubleVertex(const std::vector<std::array<double, 2>>& vertices)
{
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    if (vertices[i] == vertices[(i + 1) % vertices.size()])
    {
      return true;
    }
  }
  return false;
}
}

//----------------------------------------------------------------------------
TEST(SmoothContours, NothingChangesWithoutLength)
{
  Drawing drawing({ Circle(50, 0.1, 1) });
  const Contours before = drawing.Set;
  for (const double length : { 0.0, -1.0, std::nan("") })
  {
    drawing.Smooth(length);
    EXPECT_EQ(drawing.Set.U, before.U);
    EXPECT_EQ(drawing.Set.V, before.V);
    EXPECT_EQ(drawing.Set.Offsets, before.Offsets);
  }
}

//----------------------------------------------------------------------------
TEST(SmoothContours, TakesNoiseOutOfACircle)
{
  double before = 1.0;
  for (const double length : { 0.2, 0.4, 0.8 })
  {
    Drawing drawing({ Circle(200, 0.03, 2) });
    const double noise = ErrorOf(drawing.Last());
    drawing.Smooth(length);
    const double left = ErrorOf(drawing.Last()) / noise;
    EXPECT_LT(left, 0.8 * before);
    EXPECT_EQ(drawing.Last().size(), 200u);
    before = left;
  }
  EXPECT_LT(before, 0.3);
}

//----------------------------------------------------------------------------
TEST(SmoothContours, HardlyMovesASmoothCurve)
{
  Drawing drawing({ Circle(200, 0.0, 0) });
  const auto before = drawing.Last();
  drawing.Smooth(0.5);
  const auto after = drawing.Last();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i)
  {
    EXPECT_NEAR(after[i][0], before[i][0], 2e-3);
    EXPECT_NEAR(after[i][1], before[i][1], 2e-3);
  }
}

//----------------------------------------------------------------------------
TEST(SmoothContours, CornersOfASquareStay)
{
  std::vector<std::array<double, 2>> square;
  for (int i = 0; i < 80; ++i)
  {
    const double s = (i % 20) / 10.0;
    square.push_back(i < 20 ? std::array<double, 2>{ s, 0 }
        : i < 40            ? std::array<double, 2>{ 2, s }
        : i < 60            ? std::array<double, 2>{ 2 - s, 2 }
                            : std::array<double, 2>{ 0, 2 - s });
  }
  Drawing drawing({ square });
  drawing.Smooth(0.7);
  const auto smooth = drawing.Last();
  ASSERT_EQ(smooth.size(), square.size());
  for (std::size_t i = 0; i < square.size(); ++i)
  {
    EXPECT_NEAR(smooth[i][0], square[i][0], 1e-6);
    EXPECT_NEAR(smooth[i][1], square[i][1], 1e-6);
    EXPECT_TRUE(i % 20 != 0 || smooth[i] == square[i]);
  }
}

//----------------------------------------------------------------------------
TEST(SmoothContours, ContoursStayContours)
{
  Random random(3);
  std::vector<std::vector<std::array<double, 2>>> contours;
  for (int i = 0; i < 300; ++i)
  {
    std::vector<std::array<double, 2>> contour;
    const double size = i % 3 == 0 ? 1e-6 : 1.0;
    for (std::size_t n = 3 + random.Below(12); contour.size() < n;)
    {
      const std::array<double, 2> p{ 0.2 + size * random.Uniform(0.0, 1.0),
        0.2 + size * random.Uniform(0.0, 1.0) };
      contour.push_back({ static_cast<float>(p[0]), static_cast<float>(p[1]) });
      if (contour.size() > 1 &&
        (contour.back() == contour[contour.size() - 2] ||
          (contour.size() == n && contour.back() == contour.front())))
      {
        contour.pop_back();
      }
    }
    contours.push_back(contour);
  }
  for (const double length : { 0.01, 0.3, 5.0 })
  {
    Drawing drawing(contours, true);
    const Index count = drawing.Set.Count();
    drawing.Smooth(length);
    ASSERT_EQ(drawing.Set.Count(), count);
    ASSERT_EQ(drawing.Set.Offsets.size(), count + 1u);
    EXPECT_EQ(static_cast<std::size_t>(drawing.Set.Offsets.back()), drawing.Set.U.size());
    for (Index c = 0; c < count; ++c)
    {
      std::vector<std::array<double, 2>> vertices;
      for (Index i = drawing.Set.Offsets[c]; i < drawing.Set.Offsets[c + 1]; ++i)
      {
        vertices.push_back({ drawing.Set.U[i], drawing.Set.V[i] });
        EXPECT_EQ(static_cast<float>(drawing.Set.U[i]), drawing.Set.U[i]); // as in the result
        EXPECT_EQ(static_cast<float>(drawing.Set.V[i]), drawing.Set.V[i]);
      }
      EXPECT_GE(vertices.size(), 3u);
      EXPECT_FALSE(HasDoubleVertex(vertices));
    }
  }
}

//----------------------------------------------------------------------------
TEST(SmoothContours, SameForAnyNumberOfThreads)
{
  std::vector<std::vector<std::array<double, 2>>> contours;
  for (std::uint64_t seed = 0; seed < 30; ++seed)
  {
    contours.push_back(Circle(20 + static_cast<int>(seed), 0.05, seed));
  }
  Drawing one(contours), many(contours);
  one.Smooth(0.3);
  many.Smooth(0.3, ManyThreads());
  EXPECT_EQ(one.Set.U, many.Set.U);
  EXPECT_EQ(one.Set.V, many.Set.V);
  EXPECT_EQ(one.Set.Offsets, many.Set.Offsets);
}
