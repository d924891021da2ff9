// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLoopMeetings_h
#define OrthoSlicesLoopMeetings_h

#include "Core/Base/Contours.h"

#include <vector>

namespace orthoslices
{
/// Where two contours, or one with itself, meet.
struct LoopMeeting
{
  Index Contour, Other; ///< the same where it meets itself
  Point2 Where;
  bool IsTouch; ///< they touch in points only; else they cross, or run along each other
};

/**
 * The meetings of the contours of one slice, decided exactly. A contour that turns back along itself
 * meets itself; one that touches itself counts if both of the loops between are more than crumbs.
 * Of two contours, or one and itself, one meeting is listed: the first that is no touch, if there is
 * any.
 */
std::vector<LoopMeeting> FindLoopMeetings(
  const Contours& contours, const std::vector<Index>& members);
}

#endif
