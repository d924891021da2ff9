// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesOrientContours_h
#define OrthoSlicesOrientContours_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"

#include <vector>

namespace orthoslices
{
/// How the interior of a contour is found.
enum class Orientation
{
  ByNesting, ///< a contour inside an even number of others of its slice is an outer boundary
  AsDrawn    ///< the interior is on the left as the vertices run
};

/**
 * Checks and orients the contours of every slice (section 3 of the paper: interior on the left).
 *
 * With `removeCrossing`, contours that cross themselves, or another one of their slice (of two that
 * cross, the one with the smaller area), are reported and removed. Contours may touch. With
 * ByNesting, contours are reversed where needed. Contours from `firstSettled` on stay as they are;
 * see ResolveLoops.
 */
void OrientContours(Orientation orientation, bool removeCrossing, Index firstSettled,
  const Execution& execution, Contours& contours, std::vector<Problem>& crossing);

/// Whether all contours together run clockwise: what they bound is the outside.
bool BoundOutside(const Contours& contours);
}

#endif
