// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSelectContours_h
#define OrthoSlicesSelectContours_h

#include "Core/Base/Contours.h"
#include "Core/Crossings/Repair.h"

/// Parts and sums of contours, for surfaces from some of them or with virtual ones.
namespace orthoslices
{
/// Adds contours on virtual planes to real ones.
void AddVirtual(const Contours& others, Contours& contours);

/// The contours of an axis if `ofAxis`, else those of all others.
Contours SelectAxis(const Contours& contours, int axis, bool ofAxis);

/**
 * Takes away contours of virtual slices that do not go together with the real ones: all on planes
 * on which arcs were drawn anew, because a real slice has what the virtual one lacks; or, if there
 * are none, all on planes with any repair. `repairs` are those of virtual slices, by the planes of
 * `grid`. False if nothing is taken away.
 */
bool RemoveMended(const std::vector<Repair>& repairs, const SpatialGrid& grid, Contours& contours);
}

#endif
