// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCentralPoints_h
#define OrthoSlicesCentralPoints_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"
#include "Core/Cells/PatchMesh.h"

#include <vector>

namespace orthoslices
{
/// How the central point of a spatial polygon is found.
enum class CentralPointMethod
{
  LeastSquares, ///< quadratic height function through the arcs and the normals at the node points
  Centroid      ///< centroid of the arcs
};

/**
 * Least distance of a central point from the faces of its cell, as a part of the cell's width. A
 * cell is convex, so that the rays from a point strictly inside to the points of its boundary
 * meet nowhere else: the fan of a polygon without crossings has none either.
 */
constexpr double CentralPointMargin = 1e-3;

/// The direction to the right of a contour on a slice across `axis`, where outside lies.
Point3 RightOf(const Point3& along, int axis);

/// Normal from the tangents of two contours on slices across two axes; zero where these do not agree
/// on which side is outside.
Point3 OutwardNormal(const Point3& first, int firstAxis, const Point3& second, int secondAxis);

/**
 * Surface normals at the node points, x, y, z of each, pointing outwards. Two contours cross
 * there, so the normal is the cross product of their tangents: known, not estimated (our own
 * addition). Its length is the sine of the angle between the tangents, and 0 where a tangent is
 * unknown.
 */
std::vector<double> ComputeNodeNormals(const Contours& contours, const SpatialGrid& grid,
  const GridCrossings& crossings, const NodePoints& nodes, const Execution& execution);

/**
 * One central point for each cycle (the paper's section 5), x, y, z of each, inside the closed
 * cell. LeastSquares measures heights over a plane through the centroid of the arcs, weights the
 * points of the arcs by length, and falls back to the centroid where the polygon is no height
 * function. A loop gets the top of a dome as high as it is wide, at most half the cell's width.
 */
std::vector<double> LocateCentralPoints(CentralPointMethod method, const CycleGeometry& geometry,
  const std::vector<double>& nodeNormals, const Execution& execution);
}

#endif
