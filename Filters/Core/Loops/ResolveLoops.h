// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesResolveLoops_h
#define OrthoSlicesResolveLoops_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"
#include "Core/Loops/LoopRule.h"

#include <vector>

namespace orthoslices
{
/**
 * Replaces the contours of slices on which they cross, overlap or run along each other or
 * themselves: simple loops that do not touch each other, with their interior on the left, bound
 * what is inside by the rule. So loops that overlap become their union, an outline and a hole that
 * are joined by a bridge drawn twice become two loops, and a figure eight becomes two. A loop that
 * meets no other keeps its vertices. What the rule leaves between loops and is thinner than 1e-4 of
 * the slice's extent is left out. Where two loops or lobes meet in a point, their corners there are
 * cut off by a little.
 *
 * Slices without such meetings are not changed. With `partTouching`, slices on which contours touch
 * in points are resolved, too: later stages would leave a corner out there. With Union,
 * nor are slices where contours meet by noise only (AreMeetingsSlight), which is reported: there,
 * EmbedArcs and EmbedIsolated take them apart, so that a crossing by a little leaves no crumbs.
 * With NonZero, slices of several contours are always resolved: there, the direction of holes
 * counts.
 *
 * `asDrawn`: the interior is on the left of contours as they are drawn; see LoopRegions. Else
 * directions do not count, but for NonZero. All is decided exactly. Virtual contours are not
 * touched.
 *
 * The contours that result stand at the end, with the cell of that contour which the greatest part
 * of their length is from. Returns the number of the first of them. What was done is appended to
 * `mended`.
 */
Index ResolveLoops(LoopRule rule, bool asDrawn, bool partTouching, const Execution& execution,
  Contours& contours, std::vector<Problem>& mended);
}

#endif
