// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPlaneFit_h
#define OrthoSlicesPlaneFit_h

#include "Core/Base/Polylines.h"

namespace orthoslices
{
/// How points are scattered around their centre, or around those of several parts. Sums may be
/// added.
struct Scatter
{
  std::array<double, 6> Sums{}; ///< of squares and products: xx, yy, zz, yz, zx, xy
  Index Points = 0;

  void Add(const Point3& fromCenter);
  void Add(const Scatter& other);

  /// The root mean square along a unit vector, of the distances from the centre.
  double Along(const Point3& direction) const;
};

/// The plane of least squares through points. Lengths are root mean squares of distances from the
/// centre, so that a circle of radius 1 has a Length and a Width of 0.7.
struct PlaneFit
{
  Point3 Normal{ 0.0, 0.0, 0.0 };   ///< of unit length
  double Thickness = 0.0;           ///< along the normal; rounding shows as 1e-8 of the length
  double Width = 0.0, Length = 0.0; ///< along the shorter and the longer axis within the plane
};

PlaneFit FitPlane(const Scatter& scatter);

/// What the points of some polylines are scattered like; without points if any is not finite.
Scatter MeasureScatter(const Polylines& lines, const std::vector<Index>& members, Point3& center);
}

#endif
