// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSidesOnPlanes_h
#define OrthoSlicesSidesOnPlanes_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"
#include "Core/Slices/SpatialGrid.h"

#include <vector>

namespace orthoslices
{
/**
 * Where structures end just on a plane, sides of their contours on slices across lie on it (our own
 * addition). They show what is below the plane and what is above it, and the slice on the plane
 * shows either, as it was drawn. A side on a plane lies above it by rule (SpatialGrid), so that the
 * other choice would be a contradiction. Hence sides that are nearer to a plane than `thickness` go
 * to the side of it that agrees with the slice there: all that hang together on a slice go as most
 * of their length wants, and all structures alike.
 *
 * Structures have the same vertices where they run along each other (ShareBorders). True if any
 * contour has changed; else all agree, or neither choice does.
 */
bool SettleSidesOnPlanes(const SpatialGrid& grid, double thickness, const Execution& execution,
  const std::vector<Contours*>& structures);
}

#endif
