// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPressedPoints_h
#define OrthoSlicesPressedPoints_h

#include "Core/Slices/SpatialGrid.h"
#include "Core/Surface/CornerTable.h"

#include <vector>

namespace orthoslices
{
/// Points inside patches are placed within their cell, and where they would be beyond it, next to its
/// face: so near to a plane of the grid that triangles in it all but touch contours there. Such a
/// point is *pressed* onto the plane.
struct PressedPoint
{
  int Axis = -1;    ///< of the plane; -1: there is none
  double Way = 0.0; ///< 1 if the point is above it, -1 if it is below
};

/// How near that is, as a share of the tolerance inside plain patches.
constexpr double PressedShare = 0.003;

/// Looks for a plane that is nearer to a point than a distance, but not at it, from some axis on.
PressedPoint FindPressing(
  const SpatialGrid& grid, const Point3& place, double distance, int axis = 0);

/// The same, if one of the triangles at the point lies next to that plane, too.
PressedPoint FindPressing(const SpatialGrid& grid, const CornerTable& corners,
  const std::vector<Point3>& points, Index point, double distance);
}

#endif
