// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLoopMeetings_h
#define OrthoSlicesLoopMeetings_h

#include "Core/Base/Contours.h"

#include <vector>

namespace orthoslices
{
/// Where two contours, or one with itself, do more than touch: they cross, or run along each other.
struct LoopMeeting
{
  Index Contour, Other; ///< the same where it meets itself
  Point2 Where;
};

/**
 * The meetings of the contours of one slice, decided exactly. Contours that touch in a point
 * without crossing there do not count, and a contour that turns back along itself meets itself. Of
 * two contours, or one and itself, the first meeting that is found is listed.
 */
std::vector<LoopMeeting> FindLoopMeetings(
  const Contours& contours, const std::vector<Index>& members);
}

#endif
