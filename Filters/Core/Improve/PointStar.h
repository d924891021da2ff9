// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPointStar_h
#define OrthoSlicesPointStar_h

#include "Core/Surface/CornerTable.h"

#include <vector>

namespace orthoslices
{
/// A triangle by the places of its corners.
using TriangleCorners = std::array<Point3, 3>;

/// Twice the area of a triangle, along its normal.
Point3 AreaOf(const TriangleCorners& t);

/// The squared sine of a triangle's smallest angle.
double SquaredSine(const TriangleCorners& t);

/// The same, if AreaOf the triangle is known.
double SquaredSine(const TriangleCorners& t, const Point3& area);

/// The cosine of the angle between two vectors; 0 if one has no length.
double CosineBetween(const Point3& a, const Point3& b);

/// How a point of a surface is to move.
struct StarChange
{
  Point3 Place;        ///< where it goes
  Index Left;          ///< triangles with this point vanish; -1: none
  double LeastQuality; ///< no triangle may have a SquaredSine that is not greater
  double LeastCosine;  ///< of the angle by which a triangle may turn
};

/// The triangles at a point, as they are and as they would be if it moved.
class PointStar
{
public:
  void Set(const CornerTable& corners, const std::vector<Point3>& points, Index point);

  /**
   * Looks at the triangles as they would be, and sets `quality` to the least SquaredSine of them.
   * False if the change may not be. Triangles that were slivers have normals that say nothing:
   * instead of the angle by which they turn, that against the normal of the star counts.
   */
  bool Try(const StarChange& change, double& quality);

  /// The middle of the points around it.
  Point3 Middle() const;

  Index Point = -1;
  Point3 Outwards{};                   ///< the direction of the normal
  double Quality = 0.0;                ///< the least SquaredSine of the triangles as they are
  std::vector<Index> Corners;          ///< at the point, counter-clockwise
  std::vector<TriangleCorners> Before; ///< the triangles of these
  std::vector<TriangleCorners> After;  ///< those that would not vanish
  std::vector<std::size_t> Places;     ///< of these among all

private:
  struct Shape
  {
    Point3 Area;    ///< AreaOf a triangle
    double Quality; ///< its SquaredSine
    Index Start;    ///< its corner after the point
  };
  std::vector<Shape> Shapes; ///< of the triangles as they are
};
}

#endif
