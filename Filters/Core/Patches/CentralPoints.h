// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCentralPoints_h
#define OrthoSlicesCentralPoints_h

#include "Core/Base/Execution.h"
#include "Core/Base/Ranks.h"
#include "Core/Graph/CycleGeometry.h"

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
 * meet nowhere else: the fan of a polygon without crossings has none either. A thousandth is far
 * more than floats need to resolve it, and less than the errors of central points.
 */
constexpr double CentralPointMargin = 1e-3;

/**
 * One central point for each cycle (the paper's section 5), x, y, z of each, inside the closed
 * cell. LeastSquares measures heights over a plane through the centroid of the arcs, weights the
 * points of the arcs by length, and falls back to the centroid where the polygon is no height
 * function. A loop gets the top of a dome as high as it is wide, at most half the cell's width.
 * Several processes locate a part of the points each, and exchange them.
 */
std::vector<double> LocateCentralPoints(CentralPointMethod method, const CycleGeometry& geometry,
  const std::vector<double>& nodeNormals, const Execution& execution, const Ranks& ranks = Ranks());
}

#endif
