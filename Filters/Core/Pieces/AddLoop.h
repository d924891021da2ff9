// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesAddLoop_h
#define OrthoSlicesAddLoop_h

#include "Core/Base/Contours.h"

/**
 * Adds a loop to contours vertex by vertex. The one that is being added has the vertices after the
 * last of Contours::Offsets; it becomes a contour when its end, its axis and so on are appended.
 */
namespace orthoslices
{
/// Appends a vertex, unless it repeats the last one.
void AddPoint(double u, double v, Contours& contours);

enum class LoopState
{
  Good,
  TooShort, ///< fewer than three vertices
  Flat ///< it encloses nothing: its vertices lie on one line to within the tolerance, or it goes back
       ///< the way it came
};

/// Takes repetitions of its first vertex from the end of the loop, and says what it is. Flat loops
/// are good unless they are asked for.
LoopState CheckLoop(bool alsoFlat, double tolerance, Contours& contours);

/// Gives up the loop.
void DropLoop(Contours& contours);
}

#endif
