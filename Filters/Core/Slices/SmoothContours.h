// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSmoothContours_h
#define OrthoSlicesSmoothContours_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"
#include "Core/Slices/SpatialGrid.h"

namespace orthoslices
{
/**
 * Takes noise out of contours: each vertex moves, within its plane, onto the cubic curve that fits
 * the contour best up to `length` before and after it (the filter of A. Savitzky and M. J. E.
 * Golay, 1964). Long sides get vertices in addition. Corners stay, where a contour turns by more than
 * `cornerAngle` (radians) both on the spot and from `length` before to `length` after it: the steps
 * of an outline of pixels are none. `length` is in mean plane spacings; 0 leaves everything as it
 * is. Contours may cross each other afterwards.
 */
void SmoothContours(const SpatialGrid& grid, double length, double cornerAngle,
  const Execution& execution, Contours& contours);
}

#endif
