// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSlicePart_h
#define OrthoSlicesSlicePart_h

#include "Core/Base/Contours.h"

#include <cmath>
#include <vector>

namespace orthoslices
{
/// A contour of the slices of one family.
struct SlicePart
{
  std::vector<Point2> Vertices;
  Index Plane = 0;
  double Area = 0.0; ///< positive if it runs counter-clockwise
  Point2 Low{ HUGE_VAL, HUGE_VAL }, High{ -HUGE_VAL, -HUGE_VAL }, Middle{};
};

SlicePart MakeSlicePart(const Contours& contours, Index contour);

/**
 * Whether two contours of parallel slices are of one part, as far as one sees along the axis: they
 * run in the same sense, and one of some vertices of one of them is inside the other one. Time is
 * linear in their vertices.
 */
bool DoOverlap(const SlicePart& a, const SlicePart& b);
}

#endif
