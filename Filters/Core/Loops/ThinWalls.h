// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesThinWalls_h
#define OrthoSlicesThinWalls_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"

#include <vector>

namespace orthoslices
{
/// One contour, and a later one of its slice that may be the same.
struct Repetition
{
  Index First, Second;
  double Distance; ///< greatest one between them; 0 for copies
  double Limit;    ///< what the distance may be
  bool IsOpposite; ///< they run in opposite directions
};

/// Which of the repetitions are the two sides of thin walls instead; see RemoveRedrawn. Copies are
/// not.
std::vector<std::uint8_t> FindWalls(
  const Contours& contours, const std::vector<Repetition>& repetitions, const Execution& execution);

/// The distance of a point in its slice from a contour if it is less than the limit, or one that is
/// more. Begins to look at the segment `start`, and leaves there where it found it.
double DistanceToContour(
  const Contours& contours, Index contour, const Point2& x, double limit, Index& start);
}

#endif
