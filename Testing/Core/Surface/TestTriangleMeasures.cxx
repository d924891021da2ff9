// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/TriangleMeasures.h"

#include "Core/Base/Vectors.h"
#include "Support/Random.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;

using Triangle = std::array<Point3, 3>;

template <typename Coordinate = double, typename Id = std::int32_t>
TriangleQuality QualityOf(
  const std::vector<Triangle>& triangles, const Execution& execution = Execution())
{
  std::vector<Coordinate> points;
  std::vector<Id> ids;
  for (const Triangle& triangle : triangles)
  {
    for (const Point3& p : triangle)
    {
      ids.push_back(static_cast<Id>(points.size() / 3));
      for (const double x : p)
      {
        points.push_back(static_cast<Coordinate>(x));
      }
    }
  }
  return MeasureQuality(
    points.data(), ids.data(), static_cast<std::int64_t>(triangles.size()), execution);
}

Triangle Equilateral() { return { { { 0, 0, 1 }, { 1, 0, 1 }, { 0.5, std::sqrt(0.75), 1 } } }; }

/// With this angle between two sides of lengths 1.
Triangle Isosceles(double degrees)
{
  const double t = degrees * Pi / 180.0;
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { std::cos(t), 0, std::sin(t) } } };
}

/// A grid of parameters, closed in u, and in v if it is a torus; normals as given.
struct Mesh
{
  std::vector<double> Points;
  std::vector<float> Normals;
  std::vector<std::int32_t> Ids;
  std::vector<std::array<double, 2>> Parameters;

  template <typename Place, typename Normal>
  Mesh(int countU, int countV, bool closed, Place place, Normal normal)
  {
    const int rows = closed ? countV : countV + 1;
    for (int j = 0; j < rows; ++j)
    {
      for (int i = 0; i < countU; ++i)
      {
        const double u = 2.0 * Pi * i / countU, v = double(j) / countV;
        const Point3 p = place(u, v), n = normal(u, v);
        this->Points.insert(this->Points.end(), p.begin(), p.end());
        this->Normals.insert(this->Normals.end(), n.begin(), n.end());
        this->Parameters.push_back({ u, v });
      }
    }
    const auto id = [&](int i, int j) { return (j % rows) * countU + i % countU; };
    for (int j = 0; j < countV; ++j)
    {
      for (int i = 0; i < countU; ++i)
      {
        this->Ids.insert(this->Ids.end(), { id(i, j), id(i + 1, j), id(i + 1, j + 1) });
        this->Ids.insert(this->Ids.end(), { id(i, j), id(i + 1, j + 1), id(i, j + 1) });
      }
    }
  }

  void TurnInsideOut()
  {
    for (float& x : this->Normals)
    {
      x = -x;
    }
    for (std::size_t t = 0; t < this->Ids.size(); t += 3)
    {
      std::swap(this->Ids[t], this->Ids[t + 1]);
    }
  }

  Curvatures Measure() const
  {
    return MeasureCurvatures(this->Points.data(), this->Points.size() / 3, this->Normals.data(),
      this->Ids.data(), static_cast<std::int64_t>(this->Ids.size() / 3));
  }
};

/// Between 30 degrees south and north.
Mesh Zone(double radius)
{
  const auto normal = [](double u, double v) -> Point3
  {
    const double t = (v - 0.5) * Pi / 3.0;
    return { std::cos(t) * std::cos(u), std::cos(t) * std::sin(u), std::sin(t) };
  };
  return Mesh(
    60, 12, false, [&](double u, double v) { return radius * normal(u, v); }, normal);
}

Mesh Cylinder(double radius)
{
  return Mesh(
    80, 10, false,
    [&](double u, double v) -> Point3 {
      return { radius * std::cos(u), radius * std::sin(u), v };
    },
    [](double u, double) -> Point3 {
      return { std::cos(u), std::sin(u), 0.0 };
    });
}
}

//----------------------------------------------------------------------------
TEST(TriangleQuality, OfKnownTriangles)
{
  const TriangleQuality best = QualityOf({ Equilateral() });
  EXPECT_NEAR(best.SmallestAngle, 60.0, 1e-9);
  EXPECT_EQ(best.ShareAbove20Degrees, 1.0);
  EXPECT_NEAR(best.LargestAspectRatio, 2.0 / std::sqrt(3.0), 1e-12);

  const TriangleQuality right = QualityOf({ Isosceles(90.0) });
  EXPECT_NEAR(right.SmallestAngle, 45.0, 1e-9);
  EXPECT_NEAR(right.LargestAspectRatio, 2.0, 1e-12);

  const TriangleQuality obtuse = QualityOf({ Isosceles(150.0) });
  EXPECT_NEAR(obtuse.SmallestAngle, 15.0, 1e-9);
  EXPECT_EQ(obtuse.ShareAbove20Degrees, 0.0);
  EXPECT_NEAR(obtuse.LargestAspectRatio, 2.0 / std::tan(15.0 * Pi / 180.0), 1e-9);
}

//----------------------------------------------------------------------------
TEST(TriangleQuality, IsThatOfTheWorstAndTheShareOfTheGood)
{
  const TriangleQuality quality =
    QualityOf({ Equilateral(), Isosceles(21.0), Isosceles(19.0), Isosceles(10.0) });
  EXPECT_NEAR(quality.SmallestAngle, 10.0, 1e-9);
  EXPECT_EQ(quality.ShareAbove20Degrees, 0.5);
  EXPECT_NEAR(quality.LargestAspectRatio, 1.0 / std::sin(10.0 * Pi / 180.0), 1e-9);
}

//----------------------------------------------------------------------------
TEST(TriangleQuality, OfNothingAndOfDegenerateTriangles)
{
  const TriangleQuality none = QualityOf({});
  EXPECT_EQ(none.SmallestAngle, 0.0);
  EXPECT_EQ(none.ShareAbove20Degrees, 0.0);
  EXPECT_EQ(none.LargestAspectRatio, 0.0);
  for (const Triangle& flat : { Triangle{ { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } } },
         Triangle{ { { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } } } })
  {
    const TriangleQuality worst = QualityOf({ Equilateral(), flat });
    EXPECT_EQ(worst.SmallestAngle, 0.0);
    EXPECT_EQ(worst.ShareAbove20Degrees, 0.5);
    EXPECT_TRUE(std::isinf(worst.LargestAspectRatio));
  }
}

//----------------------------------------------------------------------------
TEST(TriangleQuality, SameForAnyNumberOfThreadsAndAnyType)
{
  Random random(1);
  std::vector<Triangle> triangles(20000);
  for (Triangle& triangle : triangles)
  {
    for (Point3& p : triangle)
    {
      for (double& x : p)
      {
        x = static_cast<float>(random.Uniform(-1.0, 1.0));
      }
    }
  }
  const TriangleQuality one = QualityOf(triangles);
  EXPECT_GT(one.SmallestAngle, 0.0);
  for (const TriangleQuality& other : { QualityOf(triangles, ManyThreads()),
         QualityOf<float>(triangles), QualityOf<float, long long>(triangles, ManyThreads()),
         QualityOf<double, long long>(triangles) })
  {
    EXPECT_EQ(one.SmallestAngle, other.SmallestAngle);
    EXPECT_EQ(one.ShareAbove20Degrees, other.ShareAbove20Degrees);
    EXPECT_EQ(one.LargestAspectRatio, other.LargestAspectRatio);
  }
}

//----------------------------------------------------------------------------
TEST(Curvatures, OfASphere)
{
  for (const double radius : { 0.5, 1.0, 40.0 })
  {
    const Mesh mesh = Zone(radius);
    const Curvatures curvatures = mesh.Measure();
    ASSERT_EQ(curvatures.Mean.size(), mesh.Parameters.size());
    for (std::size_t i = 0; i < mesh.Parameters.size(); ++i)
    {
      EXPECT_NEAR(radius * curvatures.Mean[i], 1.0, 0.01);
      EXPECT_NEAR(radius * radius * curvatures.Gaussian[i], 1.0, 0.02);
    }
  }
}

//----------------------------------------------------------------------------
TEST(Curvatures, OfACylinder)
{
  const Curvatures curvatures = Cylinder(2.0).Measure();
  for (std::size_t i = 0; i < curvatures.Mean.size(); ++i)
  {
    EXPECT_NEAR(curvatures.Mean[i], 0.25, 0.001);
    EXPECT_NEAR(curvatures.Gaussian[i], 0.0, 0.001);
  }
}

//----------------------------------------------------------------------------
TEST(Curvatures, OfATorus)
{
  constexpr double major = 2.0, minor = 0.5;
  const auto normal = [](double u, double v) -> Point3
  {
    const double t = 2.0 * Pi * v;
    return { std::cos(t) * std::cos(u), std::cos(t) * std::sin(u), std::sin(t) };
  };
  const Mesh mesh(
    120, 60, true,
    [&](double u, double v) -> Point3
    {
      const Point3 n = normal(u, v);
      return { major * std::cos(u) + minor * n[0], major * std::sin(u) + minor * n[1],
        minor * n[2] };
    },
    normal);
  const Curvatures curvatures = mesh.Measure();
  for (std::size_t i = 0; i < mesh.Parameters.size(); ++i)
  {
    const double c = std::cos(2.0 * Pi * mesh.Parameters[i][1]);
    const double around = c / (major + minor * c);
    EXPECT_NEAR(curvatures.Mean[i], 0.5 * (1.0 / minor + around), 0.02);
    EXPECT_NEAR(curvatures.Gaussian[i], around / minor, 0.03);
  }
}

//----------------------------------------------------------------------------
TEST(Curvatures, MeanIsNegativeInsideOut)
{
  Mesh mesh = Zone(1.0);
  mesh.TurnInsideOut();
  const Curvatures curvatures = mesh.Measure();
  for (std::size_t i = 0; i < curvatures.Mean.size(); ++i)
  {
    EXPECT_NEAR(curvatures.Mean[i], -1.0, 0.01);
    EXPECT_NEAR(curvatures.Gaussian[i], 1.0, 0.02);
  }
}

//----------------------------------------------------------------------------
TEST(Curvatures, PointsOfNoTriangleAndOfDegenerateOnesHaveNone)
{
  const std::vector<double> points{ 0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 5, 5 };
  const std::vector<float> normals{ 0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 1 };
  const std::vector<std::int32_t> ids{ 0, 1, 2, 1, 1, 2 };
  const Curvatures curvatures = MeasureCurvatures(points.data(), 4, normals.data(), ids.data(), 2);
  EXPECT_EQ(curvatures.Mean, std::vector<float>(4, 0.0f));
  EXPECT_EQ(curvatures.Gaussian, std::vector<float>(4, 0.0f));
}
