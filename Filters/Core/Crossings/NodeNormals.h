// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesNodeNormals_h
#define OrthoSlicesNodeNormals_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"
#include "Core/Crossings/PairNodePoints.h"

#include <vector>

namespace orthoslices
{
/// The direction to the right of a contour on a slice across `axis`, where outside lies.
Point3 RightOf(const Point3& along, int axis);

/// Normal from the tangents of two contours on slices across two axes; zero where these do not
/// agree on which side is outside.
Point3 OutwardNormal(const Point3& first, int firstAxis, const Point3& second, int secondAxis);

/**
 * Surface normals at the node points, x, y, z of each, pointing outwards. Two contours cross
 * there, so the normal is the cross product of their tangents: known, not estimated (our own
 * addition). Its length is the sine of the angle between the tangents, and 0 where a tangent is
 * unknown.
 */
std::vector<double> ComputeNodeNormals(const Contours& contours, const SpatialGrid& grid,
  const GridCrossings& crossings, const NodePoints& nodes, const Execution& execution);
}

#endif
