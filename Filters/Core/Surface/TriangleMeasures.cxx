// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/TriangleMeasures.h"

#include "Core/Base/LeastSquares.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
constexpr double DegreesPerRadian = 57.29577951308232;

/// Below 20 degrees triangles count as thin; see TriangleQuality::ShareAbove20Degrees.
constexpr double Sine20Degrees = 0.3420201433256687;

template <typename Coordinate, typename Id>
std::array<Point3, 3> CornersOf(const Coordinate* points, const Id* triangle)
{
  std::array<Point3, 3> corners;
  for (int k = 0; k < 3; ++k)
  {
    const Coordinate* p = points + 3 * static_cast<std::size_t>(triangle[k]);
    corners[k] = { double(p[0]), double(p[1]), double(p[2]) };
  }
  return corners;
}

/// Triangles that one thread measures at a time: how sums are put together does not depend on the
/// number of threads. Some thousand of them take about 0.1 ms, more than handing them out does.
constexpr std::int64_t BlockSize = 4096;

struct QualitySums
{
  double SmallestSine = 1.0; ///< of the angle over the shortest side, which is below 90 degrees
  std::int64_t Above = 0;
  double LargestRatio = 0.0;
};

void Add(const std::array<Point3, 3>& p, QualitySums& sums)
{
  std::array<double, 3> sides{ SquaredDistance(p[0], p[1]), SquaredDistance(p[1], p[2]),
    SquaredDistance(p[2], p[0]) };
  std::sort(sides.begin(), sides.end());
  const double twice = Length(Cross(p[1] - p[0], p[2] - p[0]));
  // The least angle lies between the two longer sides.
  const double product = std::sqrt(sides[1] * sides[2]);
  const double sine = product > 0.0 ? twice / product : 0.0;
  sums.SmallestSine = std::min(sums.SmallestSine, sine);
  sums.Above += sine > Sine20Degrees ? 1 : 0;
  sums.LargestRatio = std::max(sums.LargestRatio, twice > 0.0 ? sides[2] / twice : HUGE_VAL);
}

/// Mean and Gaussian curvature of a triangle from the normals at its corners.
bool CurvaturesOf(
  const std::array<Point3, 3>& p, const std::array<Point3, 3>& n, double& mean, double& gaussian)
{
  const Point3 normal = Unit(Cross(p[1] - p[0], p[2] - p[0]));
  if (Dot(normal, normal) == 0.0)
  {
    return false;
  }
  const std::array<Point3, 3> frame = CompleteFrame(normal);
  // The form (e, f; f, g) with which the normals change along the sides.
  double matrix[3][3] = {};
  double form[3] = {};
  for (int k = 0; k < 3; ++k)
  {
    const Point3 along = p[(k + 1) % 3] - p[k], change = n[(k + 1) % 3] - n[k];
    const double u = Dot(along, frame[0]), v = Dot(along, frame[1]);
    const double rows[2][3] = { { u, v, 0.0 }, { 0.0, u, v } };
    for (int r = 0; r < 2; ++r)
    {
      for (int i = 0; i < 3; ++i)
      {
        for (int j = 0; j < 3; ++j)
        {
          matrix[i][j] += rows[r][i] * rows[r][j];
        }
        form[i] += rows[r][i] * Dot(change, frame[r]);
      }
    }
  }
  if (!Factorize(matrix))
  {
    return false;
  }
  Substitute(matrix, form);
  mean = 0.5 * (form[0] + form[2]);
  gaussian = form[0] * form[2] - form[1] * form[1];
  return std::isfinite(mean) && std::isfinite(gaussian);
}
}

template <typename Coordinate, typename Id>
TriangleQuality MeasureQuality(
  const Coordinate* points, const Id* triangles, std::int64_t count, const Execution& execution)
{
  std::vector<QualitySums> blocks(static_cast<std::size_t>((count + BlockSize - 1) / BlockSize));
  execution.For(blocks.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t b = begin; b < end; ++b)
      {
        const std::int64_t first = static_cast<std::int64_t>(b) * BlockSize;
        for (std::int64_t t = first; t < std::min(count, first + BlockSize); ++t)
        {
          Add(CornersOf(points, triangles + 3 * t), blocks[b]);
        }
      }
    });
  QualitySums sums;
  for (const QualitySums& block : blocks)
  {
    sums.SmallestSine = std::min(sums.SmallestSine, block.SmallestSine);
    sums.Above += block.Above;
    sums.LargestRatio = std::max(sums.LargestRatio, block.LargestRatio);
  }
  TriangleQuality quality;
  if (count > 0)
  {
    quality.SmallestAngle = DegreesPerRadian * std::asin(std::min(1.0, sums.SmallestSine));
    quality.ShareAbove20Degrees = static_cast<double>(sums.Above) / static_cast<double>(count);
    quality.LargestAspectRatio = sums.LargestRatio;
  }
  return quality;
}

TriangleQuality JoinQualities(const TriangleQuality& own, std::int64_t count, const Ranks& ranks)
{
  if (!ranks.AreSeveral())
  {
    return own;
  }
  const double triangles = static_cast<double>(count);
  // The share of `count` is a rounded quotient of whole numbers: this is the number again.
  const double above = std::round(own.ShareAbove20Degrees * triangles);
  const std::vector<double> values{ own.SmallestAngle, above, own.LargestAspectRatio, triangles };
  TriangleQuality quality;
  double sumAbove = 0.0, sum = 0.0;
  for (const std::vector<double>& of : GatherValues(ranks, values))
  {
    if (of[3] > 0.0)
    {
      quality.SmallestAngle = sum > 0.0 ? std::min(quality.SmallestAngle, of[0]) : of[0];
      quality.LargestAspectRatio = std::max(quality.LargestAspectRatio, of[2]);
      sumAbove += of[1];
      sum += of[3];
    }
  }
  quality.ShareAbove20Degrees = sum > 0.0 ? sumAbove / sum : 0.0;
  return quality;
}

template <typename Coordinate, typename Id>
Curvatures MeasureCurvatures(const Coordinate* points, std::size_t pointCount, const float* normals,
  const Id* triangles, std::int64_t count)
{
  std::vector<double> areas(pointCount, 0.0), means(pointCount, 0.0), products(pointCount, 0.0);
  for (const Id* t = triangles; t != triangles + 3 * count; t += 3)
  {
    const std::array<Point3, 3> corners = CornersOf(points, t);
    double mean, gaussian;
    if (!CurvaturesOf(corners, CornersOf(normals, t), mean, gaussian))
    {
      continue;
    }
    const double area = Length(Cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (int k = 0; k < 3; ++k)
    {
      const std::size_t point = static_cast<std::size_t>(t[k]);
      areas[point] += area;
      means[point] += area * mean;
      products[point] += area * gaussian;
    }
  }
  Curvatures result;
  result.Mean.resize(pointCount);
  result.Gaussian.resize(pointCount);
  for (std::size_t i = 0; i < pointCount; ++i)
  {
    const double inverse = areas[i] > 0.0 ? 1.0 / areas[i] : 0.0;
    result.Mean[i] = static_cast<float>(inverse * means[i]);
    result.Gaussian[i] = static_cast<float>(inverse * products[i]);
  }
  return result;
}

#define ORTHOSLICES_INSTANTIATE(Coordinate, Id)                    \
  template TriangleQuality MeasureQuality(                         \
    const Coordinate*, const Id*, std::int64_t, const Execution&); \
  template Curvatures MeasureCurvatures(                           \
    const Coordinate*, std::size_t, const float*, const Id*, std::int64_t);
ORTHOSLICES_INSTANTIATE(float, std::int32_t)
ORTHOSLICES_INSTANTIATE(float, long long)
ORTHOSLICES_INSTANTIATE(double, std::int32_t)
ORTHOSLICES_INSTANTIATE(double, long long)
#undef ORTHOSLICES_INSTANTIATE
}
