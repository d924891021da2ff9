// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSlightMeetings_h
#define OrthoSlicesSlightMeetings_h

#include "Core/Loops/LoopWindings.h"

namespace orthoslices
{
/**
 * Whether loops meet as noise makes them meet. What a loop surrounds several times or in the other
 * direction than most is in faces of at most 2 % of the rest, and less than a quarter of it in all;
 * no loop has several parts. Of two loops at most 2 % of the smaller one is common to both, or in
 * only one of them, and no more of a loop's length is on another one; what is common is no single
 * face with an eighth of a loop's length around it: that is a neck. Or there are so many faces,
 * sixteen more than two for each loop, that nobody can have meant them.
 */
bool AreMeetingsSlight(const LoopWindings& windings);

/// Whether any loop crosses itself or another one, or runs along it, in the plane graph, where what
/// rounding has parted is one. If none does, loops that meet touch in points.
bool DoLoopsCross(const LoopWindings& windings);
}

#endif
