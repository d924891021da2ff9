// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/InterpolatePolygon.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
double LengthOf(const std::vector<Point2>& polygon)
{
  double length = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return length;
}

Point2 MiddleOf(const std::vector<Point2>& points)
{
  Point2 sum{ 0.0, 0.0 };
  for (const Point2& p : points)
  {
    sum = { sum[0] + p[0], sum[1] + p[1] };
  }
  const double count = static_cast<double>(points.size());
  return { sum[0] / count, sum[1] / count };
}

namespace
{
/// The least and the greatest number of vertices of a new contour: all pairs of them are compared.
constexpr std::size_t MinVertices = 16, MaxVertices = 512;

using Polygon = std::vector<Point2>;

/// That many points at equal distances along a polygon, from its first vertex on.
Polygon Resample(const Polygon& polygon, std::size_t count)
{
  const double step = LengthOf(polygon) / static_cast<double>(count);
  Polygon points;
  double before = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double side = std::hypot(b[0] - a[0], b[1] - a[1]);
    while (points.size() < count && step * static_cast<double>(points.size()) < before + side)
    {
      const double t = (step * static_cast<double>(points.size()) - before) / side;
      points.push_back({ a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) });
    }
    before += side;
  }
  points.resize(count, polygon.back());
  return points;
}

/// Starts the second at the point that suits the first one best, their middles on each other.
void TurnToFit(const Polygon& first, Polygon& second)
{
  const std::size_t n = first.size();
  const Point2 m = MiddleOf(first), k = MiddleOf(second);
  double least = HUGE_VAL;
  std::size_t best = 0;
  for (std::size_t shift = 0; shift < n; ++shift)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < n && sum < least; ++i)
    {
      const Point2 &a = first[i], &b = second[(i + shift) % n];
      const double x = a[0] - m[0] - b[0] + k[0], y = a[1] - m[1] - b[1] + k[1];
      sum += x * x + y * y;
    }
    best = sum < least ? shift : best;
    least = std::min(least, sum);
  }
  std::rotate(second.begin(), second.begin() + static_cast<std::ptrdiff_t>(best), second.end());
}
}

std::vector<Point2> InterpolatePolygon(const SpatialGrid& grid, const std::vector<Point2>& from,
  const std::vector<Point2>& to, double share)
{
  const std::size_t count =
    std::min(MaxVertices, std::max({ MinVertices, from.size(), to.size() }));
  const Polygon first = Resample(from, count);
  Polygon second = Resample(to, count);
  TurnToFit(first, second);
  Polygon points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point2& a = first[i];
    const Point2& b = second[i];
    const Point2 p{ grid.Round(a[0] + share * (b[0] - a[0])),
      grid.Round(a[1] + share * (b[1] - a[1])) };
    if (points.empty() || (p != points.back() && p != points.front()))
    {
      points.push_back(p);
    }
  }
  return points;
}
}
