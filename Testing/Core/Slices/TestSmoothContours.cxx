// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/SmoothContours.h"

#include "Support/Random.h"
#include "Support/TextContours.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

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
namespace
{
/// The outline of the pixels, of that size, of which the centres are within; it has one part. Only
/// corners are vertices.
std::vector<std::array<double, 2>> OutlineOfPixels(
  double size, const std::function<bool(double, double)>& isWithin)
{
  const auto isIn = [&](int i, int j) { return isWithin((i + 0.5) * size, (j + 0.5) * size); };
  constexpr int steps[4][2] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
  int i = 0, j = 0, direction = 0;
  for (j = 0; !isIn(i, j); i = i < 1000 ? i + 1 : 0, j += i == 0 ? 1 : 0)
  {
  }
  const int first[2] = { i, j };
  std::vector<std::array<double, 2>> outline;
  do
  {
    // The pixel to the left is within, the one to the right is not.
    const int* d = steps[direction];
    i += d[0];
    j += d[1];
    const int left[2] = { i + (d[0] - d[1] - 1) / 2, j + (d[0] + d[1] - 1) / 2 };
    const int right[2] = { i + (d[0] + d[1] - 1) / 2, j + (d[1] - d[0] - 1) / 2 };
    const int turn = !isIn(left[0], left[1]) ? 1 : isIn(right[0], right[1]) ? 3 : 0;
    direction = (direction + turn) % 4;
    if (turn != 0)
    {
      outline.push_back({ i * size, j * size });
    }
  } while (i != first[0] || j != first[1]);
  return outline;
}
}

TEST(SmoothContours, StepsOfPixelsAreNoCorners)
{
  const double size = 0.1;
  double before = 1.0;
  for (const double length : { 0.2, 0.4 })
  {
    Drawing drawing({ OutlineOfPixels(
      size, [](double x, double y) { return std::hypot(x - 1.0, y - 1.0) < 1.0; }) });
    const double raw = ErrorOf(drawing.Last());
    EXPECT_GT(raw, 0.3 * size);
    drawing.Smooth(length);
    const double left = ErrorOf(drawing.Last()) / raw;
    EXPECT_LT(left, 0.8 * before) << length;
    before = left;
  }
  EXPECT_LT(before, 0.35);
}

//----------------------------------------------------------------------------
/// A square on its corner: its sides are steps, and it has four corners that stay.
TEST(SmoothContours, CornersBetweenStepsStay)
{
  const double size = 0.1;
  Drawing drawing({ OutlineOfPixels(
    size, [](double x, double y) { return std::abs(x - 1.0) + std::abs(y - 1.0) < 0.96; }) });
  drawing.Smooth(0.5);
  double farthest[2] = { 0.0, 0.0 };
  for (const auto& p : drawing.Last())
  {
    const double x = std::abs(p[0] - 1.0), y = std::abs(p[1] - 1.0);
    farthest[0] = std::max(farthest[0], x);
    farthest[1] = std::max(farthest[1], y);
    EXPECT_LT(std::abs(x + y - 0.96), size);
  }
  EXPECT_GT(farthest[0], 0.85);
  EXPECT_GT(farthest[1], 0.85);
}

//----------------------------------------------------------------------------
TEST(SmoothContours, HardlyAnyLengthTakesNoMemory)
{
  Drawing drawing({ Circle(50, 0.1, 1) });
  const auto before = drawing.Last();
  drawing.Smooth(1e-12);
  EXPECT_LE(drawing.Last().size(), 100 * before.size());
  EXPECT_NEAR(ErrorOf(drawing.Last()), ErrorOf(before), 0.02);
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
