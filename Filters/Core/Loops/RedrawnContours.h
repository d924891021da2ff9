// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRedrawnContours_h
#define OrthoSlicesRedrawnContours_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"

#include <vector>

namespace orthoslices
{
/**
 * Removes contours that repeat an earlier one of their slice, and reports them to `mended`.
 *
 * Copies pass the same vertices, from whatever start and in whichever direction. Contours that were
 * drawn once more run beside, within or across the first one, closer than `share` of its thickness
 * everywhere, in both directions, where the thickness is twice the area by the length: the radius
 * of a circle, the width of a long strip. With a share of 0 only copies are removed.
 *
 * A thin wall looks the same. What tells it is that slices across it have both of its sides, too:
 * about as many crossings with the slice beside the two contours as these have with those slices.
 * Without any slices across, it is a wall if its two contours run in opposite directions, as those
 * of a cut solid do, and those of a neighbouring slice do so, too. `directionsCount`: those in
 * opposite directions always are a wall. Else the sides of a wall do not cross each other. Virtual
 * contours do not count.
 */
void RemoveRedrawn(double share, bool directionsCount, const Execution& execution,
  Contours& contours, std::vector<Problem>& mended);
}

#endif
