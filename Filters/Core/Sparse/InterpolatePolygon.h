// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesInterpolatePolygon_h
#define OrthoSlicesInterpolatePolygon_h

#include "Core/Slices/SpatialGrid.h"

#include <vector>

namespace orthoslices
{
double LengthOf(const std::vector<Point2>& polygon);

/// The mean of the vertices.
Point2 MiddleOf(const std::vector<Point2>& points);

/**
 * The polygon at a share of the way from one to another: points at equal parts of their lengths are
 * connected, starting where both fit best if their middles are laid on each other. It has as many
 * vertices as the one that has more of them, 512 at most, without repetitions; rounded as the grid
 * says. It may touch itself. REQUIRES: both run in the same sense and have a length.
 */
std::vector<Point2> InterpolatePolygon(const SpatialGrid& grid, const std::vector<Point2>& from,
  const std::vector<Point2>& to, double share);
}

#endif
