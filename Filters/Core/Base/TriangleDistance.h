// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTriangleDistance_h
#define OrthoSlicesTriangleDistance_h

#include "Core/Base/Types.h"

/// Distances of a point from the nearest point of a closed segment or triangle. Rounded.
namespace orthoslices
{
/// Distance of p from the segment ab in the plane. A segment of no length is a point.
double DistanceToSegment(const Point2& p, const Point2& a, const Point2& b);

/// Squared distance of p from the segment ab in space. A segment of no length is a point.
double SquaredDistanceToSegment(const Point3& p, const Point3& a, const Point3& b);

/**
 * Squared distance of p from the triangle abc, by the part of space that p lies in: beyond a
 * corner, beyond a side, above or below the face (C. Ericson, "Real-Time Collision Detection",
 * 2005, section 5.1.5). The corners may lie on one line, or at one place.
 */
double SquaredDistanceToTriangle(
  const Point3& p, const Point3& a, const Point3& b, const Point3& c);
}

#endif
