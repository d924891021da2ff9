// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/PointStar.h"

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
}

Point3 AreaOf(const TriangleCorners& t) { return Cross(t[1] - t[0], t[2] - t[0]); }

double SquaredSine(const TriangleCorners& t) { return SquaredSine(t, AreaOf(t)); }

double SquaredSine(const TriangleCorners& t, const Point3& area)
{
  // The two longer sides enclose the smallest angle.
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
  this->Point = point;
  this->Corners.clear();
  this->Before.clear();
  this->Shapes.clear();
  this->Outwards = { 0.0, 0.0, 0.0 };
  this->Quality = 1.0;
  corners.ForCornersAt(point,
    [&](Index corner)
    {
      const Index first = corner - corner % 3;
      this->Corners.push_back(corner);
      this->Before.push_back({ points[corners.VertexOf(first)], points[corners.VertexOf(first + 1)],
        points[corners.VertexOf(first + 2)] });
      const Point3 area = AreaOf(this->Before.back());
      const double quality = SquaredSine(this->Before.back(), area);
      this->Shapes.push_back({ area, quality, corners.StartOf(corner) });
      this->Outwards = this->Outwards + area;
      this->Quality = std::min(this->Quality, quality);
    });
}

Point3 PointStar::Middle() const
{
  Point3 middle{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    const Point3& next = this->Before[i][(this->Corners[i] + 1) % 3];
    middle = middle + (1.0 / this->Corners.size()) * next;
  }
  return middle;
}

bool PointStar::Try(const StarChange& change, double& quality)
{
  const std::size_t count = this->Corners.size();
  this->After.clear();
  this->Places.clear();
  quality = 1.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    // The triangles come counter-clockwise.
    if (this->Shapes[i].Start == change.Left || this->Shapes[(i + 1) % count].Start == change.Left)
    {
      continue;
    }
    TriangleCorners triangle = this->Before[i];
    triangle[this->Corners[i] % 3] = change.Place;
    const Point3 area = AreaOf(triangle);
    quality = std::min(quality, SquaredSine(triangle, area));
    if (!(quality > change.LeastQuality))
    {
      return false;
    }
    const bool wasSliver = this->Shapes[i].Quality < SliverQuality;
    if (wasSliver ? CosineBetween(area, this->Outwards) < std::min(MostTilt, change.LeastCosine)
                  : CosineBetween(area, this->Shapes[i].Area) < change.LeastCosine)
    {
      return false;
    }
    this->After.push_back(triangle);
    this->Places.push_back(i);
  }
  return !this->After.empty();
}
}
