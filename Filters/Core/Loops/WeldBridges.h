// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesWeldBridges_h
#define OrthoSlicesWeldBridges_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"

namespace orthoslices
{
/**
 * Makes bridges exact: where an outline runs to a hole along one side, and back along another one
 * beside it, the second side is led along the first one, so that ResolveLoops takes the bridge out.
 *
 * Two sides of a contour are those of a bridge if they run in opposite directions, the outside
 * between them, the shorter one closer to the other than `share` of the contour's thickness (see
 * RemoveRedrawn) and longer than five times that distance; and if the hole behind them is thicker
 * than five times that distance: a slot that leads nowhere stays. The 64 longest sides of a contour
 * are considered; if it has more, of these the ones longer than twice the mean. Virtual contours
 * are not touched.
 */
void WeldBridges(double share, const Execution& execution, Contours& contours);
}

#endif
