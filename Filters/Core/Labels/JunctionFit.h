// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesJunctionFit_h
#define OrthoSlicesJunctionFit_h

#include "Core/Base/QuadraticFit.h"
#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/// A side of the border of a surface in a cell.
struct BorderSide
{
  Point3 From, To;
};

/**
 * Where the curve runs in which three surfaces of a cell meet, from one point on the boundary of
 * the cell to another one. Of the three surfaces, each with the two others as its border, one is
 * the smoothest: two parts of it continue one another, and the third surface ends on it. A
 * quadratic is fitted to the border of each, as a height over its mean plane; the curve is on the
 * one that fits best, over the straight line between its ends.
 */
class JunctionFit
{
public:
  JunctionFit(const Point3& first, const Point3& last)
    : First(first)
    , Last(last)
  {
  }

  /// One of the surfaces, by the sides of its border, in one direction around it. False if another
  /// one fits better, or if it does not fit to within a quarter of the distance of the ends from
  /// their middle.
  bool Try(const std::vector<BorderSide>& border);

  /// The place of the curve after a share of its way, and the normal of the surface that it is on;
  /// zero if there is none.
  void Evaluate(double share, Point3& place, Point3& normal) const;
  /// The same for the curve on the surface between two other points.
  void EvaluateBetween(
    const Point3& first, const Point3& last, double share, Point3& place, Point3& normal) const;
  /// Moves a place onto the surface; its normal there. REQUIRES: there is a surface.
  Point3 Project(Point3& place) const;

private:
  Point3 ToLocal(const Point3& place) const;
  double HeightOver(const Point3& place) const;
  Point3 NormalAt(const Point3& place) const;

  Point3 First, Last;
  bool HasSurface = false;
  double Residual = 0.0;
  Point3 Origin{}; ///< the middle between the ends
  double Unit = 1.0;
  std::array<Point3, 3> Axes{};
  QuadraticFit Heights;
};
}

#endif
