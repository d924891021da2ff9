// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/MakesFold.h"

#include "Core/Base/Vectors.h"
#include "Core/Improve/PointStar.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// The cosine of the angle between the normals of triangles that enclose five degrees.
constexpr double FoldCosine = -0.9962;

/// A side of a triangle, by the numbers of its ends, the smaller one first.
struct Side
{
  std::array<Index, 2> Ends;
  Point3 Normal; ///< of the triangle, of any length
};

void AddSides(const std::array<Index, 3>& triangle, const Point3& normal, std::vector<Side>& sides)
{
  for (int i = 0; i < 3; ++i)
  {
    const Index a = triangle[i], b = triangle[(i + 1) % 3];
    sides.push_back({ { std::min(a, b), std::max(a, b) }, normal });
  }
}

std::array<Index, 3> CornersOf(const CornerTable& corners, Index triangle)
{
  return { corners.VertexOf(3 * triangle), corners.VertexOf(3 * triangle + 1),
    corners.VertexOf(3 * triangle + 2) };
}

/// One side of each triangle around those that are removed: the one at which they meet.
void AddSidesAround(const CornerTable& corners, const std::vector<Point3>& points,
  const SurfaceChange& change, std::vector<Side>& sides)
{
  const auto& removed = change.Removed;
  for (const Index triangle : removed)
  {
    for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
    {
      const Index across = corners.OppositeOf(corner) / 3;
      if (std::find(removed.begin(), removed.end(), across) != removed.end())
      {
        continue;
      }
      const Index a = corners.StartOf(corner), b = corners.EndOf(corner);
      const auto [p, q, r] = CornersOf(corners, across);
      sides.push_back(
        { { std::min(a, b), std::max(a, b) }, AreaOf({ points[p], points[q], points[r] }) });
    }
  }
}

/// The least cosine of the angle between normals at a side.
double SharpestOf(std::vector<Side>& sides)
{
  std::stable_sort(
    sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.Ends < b.Ends; });
  double sharpest = 1.0;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    if (sides[i].Ends == sides[i + 1].Ends)
    {
      sharpest = std::min(sharpest, CosineBetween(sides[i].Normal, sides[i + 1].Normal));
    }
  }
  return sharpest;
}

double SharpestBefore(
  const CornerTable& corners, const std::vector<Point3>& points, const SurfaceChange& change)
{
  std::vector<Side> sides;
  AddSidesAround(corners, points, change, sides);
  for (const Index triangle : change.Removed)
  {
    const std::array<Index, 3> ends = CornersOf(corners, triangle);
    AddSides(ends, AreaOf({ points[ends[0]], points[ends[1]], points[ends[2]] }), sides);
  }
  return SharpestOf(sides);
}

double SharpestAfter(
  const CornerTable& corners, const std::vector<Point3>& points, const SurfaceChange& change)
{
  const auto placeOf = [&](Index point) -> const Point3&
  { return point == change.Point ? change.Place : points[point]; };
  std::vector<Side> sides;
  AddSidesAround(corners, points, change, sides);
  for (const auto& triangle : change.Added)
  {
    AddSides(triangle, AreaOf({ placeOf(triangle[0]), placeOf(triangle[1]), placeOf(triangle[2]) }),
      sides);
  }
  return SharpestOf(sides);
}
}

bool MakesFold(
  const CornerTable& corners, const std::vector<Point3>& points, const SurfaceChange& change)
{
  const double after = SharpestAfter(corners, points, change);
  return after < FoldCosine && after < SharpestBefore(corners, points, change);
}
}
