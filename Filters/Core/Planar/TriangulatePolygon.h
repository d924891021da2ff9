// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTriangulatePolygon_h
#define OrthoSlicesTriangulatePolygon_h

#include "Core/Base/Predicates.h"

#include <vector>

namespace orthoslices
{
/**
 * Triangulates a simple polygon that runs counter-clockwise by cutting off ears. Triangles are
 * places in the polygon.
 */
std::vector<std::array<Index, 3>> TriangulatePolygon(const std::vector<Point2>& polygon);

/**
 * Triangulates what lies on the left of disjoint simple rings: counter-clockwise rings enclose
 * parts, clockwise ones holes in them. Rings are places in `points`, and so are the triangles. Each
 * hole is joined to its part by a bridge from its rightmost point (D. Eberly, "Triangulation by
 * Ear Clipping", 2002).
 */
std::vector<std::array<Index, 3>> TriangulateRings(
  const std::vector<Point2>& points, const std::vector<std::vector<Index>>& rings);
}

#endif
