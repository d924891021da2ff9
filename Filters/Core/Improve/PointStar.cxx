// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/PointStar.h"

#include "Core/Base/TriangleDistance.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Slivers have a smaller squared sine: 6 degrees.
constexpr double SliverQuality = 0.01;

/// The cosine between a triangle that was a sliver and the star, at least.
constexpr double MostTilt = 0.2;

/// The share of the tolerance up to which distances need not be known exactly.
constexpr double NearEnough = 0.1;

/// The distance of a place from triangles, or `enough` if it is less.
double DistanceTo(const std::vector<TriangleCorners>& triangles, const Point3& place, double enough)
{
  double nearest = HUGE_VAL;
  for (const TriangleCorners& t : triangles)
  {
    nearest = std::min(nearest, SquaredDistanceToTriangle(place, t[0], t[1], t[2]));
    if (nearest <= enough * enough)
    {
      return enough;
    }
  }
  return std::sqrt(nearest);
}
}

Point3 AreaOf(const TriangleCorners& t) { return Cross(t[1] - t[0], t[2] - t[0]); }

double SquaredSine(const TriangleCorners& t)
{
  // The two longer sides enclose the smallest angle.
  const Point3 area = AreaOf(t);
  const double a = SquaredDistance(t[0], t[1]);
  const double b = SquaredDistance(t[1], t[2]);
  const double c = SquaredDistance(t[2], t[0]);
  const double product = std::max({ a * b, b * c, c * a });
  return product > 0.0 ? Dot(area, area) / product : 0.0;
}

double CosineBetween(const Point3& a, const Point3& b)
{
  const double lengths = std::sqrt(Dot(a, a) * Dot(b, b));
  return lengths > 0.0 ? Dot(a, b) / lengths : 0.0;
}

void PointStar::Set(const CornerTable& corners, const std::vector<Point3>& points, Index point)
{
  this->Corners.clear();
  this->Before.clear();
  corners.ForCornersAt(point,
    [&](Index corner)
    {
      const Index first = corner - corner % 3;
      this->Corners.push_back(corner);
      this->Before.push_back({ points[corners.VertexOf(first)], points[corners.VertexOf(first + 1)],
        points[corners.VertexOf(first + 2)] });
    });
}

Point3 PointStar::Normal() const
{
  Point3 sum{ 0.0, 0.0, 0.0 };
  for (const TriangleCorners& triangle : this->Before)
  {
    sum = sum + AreaOf(triangle);
  }
  return Unit(sum);
}

bool PointStar::Try(const CornerTable& corners, const StarChange& change, double& quality)
{
  const Point3 normal = this->Normal();
  this->After.clear();
  quality = 1.0;
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    const Index corner = this->Corners[i];
    if (corners.StartOf(corner) == change.Left || corners.EndOf(corner) == change.Left)
    {
      continue;
    }
    TriangleCorners triangle = this->Before[i];
    triangle[corner % 3] = change.Place;
    quality = std::min(quality, SquaredSine(triangle));
    if (!(quality > change.LeastQuality))
    {
      return false;
    }
    const Point3 area = AreaOf(triangle);
    if (SquaredSine(this->Before[i]) < SliverQuality
        ? CosineBetween(area, normal) < MostTilt
        : CosineBetween(area, AreaOf(this->Before[i])) < change.LeastCosine)
    {
      return false;
    }
    this->After.push_back(triangle);
  }
  return !this->After.empty();
}

double PointStar::Shift(const Point3& place, double tolerance) const
{
  const double enough = NearEnough * tolerance;
  double shift = DistanceTo(this->After, place, enough);
  for (std::size_t i = 0; i < this->Corners.size() && shift <= tolerance; ++i)
  {
    const Point3& end = this->Before[i][(this->Corners[i] + 1) % 3];
    shift = std::max(shift, DistanceTo(this->After, Between(place, end, 0.5), enough));
  }
  return shift;
}
}
