// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCommonPoint_h
#define OrthoSlicesCommonPoint_h

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
 * Where the curve in which three surfaces of a cell meet may pass the middle between its ends, which
 * lie on the boundary of the cell. Of the three surfaces, each with the two others as its border, one
 * is the smoothest: two parts of it continue one another, and the third surface ends on it. A
 * quadratic is fitted to the border of each, as a height over its mean plane, and the one that fits
 * best has the point. `surfaces` has the borders, of any number of surfaces, each with its sides in
 * one direction around it. The middle itself where none fits to within a quarter of its distance from the
 * ends.
 */
Point3 FindCommonPoint(
  const Point3& first, const Point3& last, const std::vector<std::vector<BorderSide>>& surfaces);
}

#endif
