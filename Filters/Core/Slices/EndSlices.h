// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEndSlices_h
#define OrthoSlicesEndSlices_h

#include "Core/Base/Box.h"
#include "Core/Base/Contours.h"
#include "Core/Slices/SpatialGrid.h"

namespace orthoslices
{
/// The last contours of a stack once more, where it ends half a slice farther.
struct EndSlices
{
  Contours Copies;            ///< without their planes in a grid; none if there is nothing to add
  Box3 Bounds = Everywhere(); ///< of the surface, along the axis of the stack
};

/**
 * Copies the contours of the first and the last slice of an only family half a slice farther out:
 * by half the distance of the two slices there, or half of SpacingAtEnds if that is less (which it
 * is for a single slice). Walls between a slice and its copy are at right angles to it, and beyond
 * the copy the surface ends flat, on the bounds: between a copy and the bound a thousandth of
 * SpacingAtEnds is left, for what is placed in the cells there.
 *
 * Nothing is added at an end where the grid's bounds or the precision leave no room, and with
 * several families, as these show the ends themselves. `tolerance` is that of planes.
 */
EndSlices CopyEndSlices(const Contours& contours, const SpatialGrid& grid, double tolerance);

/// What is left between a virtual slice at the end of an object and the bound of the surface: a
/// thousandth of SpacingAtEnds, or what the precision needs.
double RoomBeyondEnd(const SpatialGrid& grid, int axis);

/// Takes the bounds along all axes into those of the grid.
void LimitBoundsTo(const Box3& bounds, SpatialGrid& grid);

/// Whether a slab lies between the first or the last slice of an axis and its copy.
bool IsBesideEndSlice(const SpatialGrid& grid, int axis, Index slab);
}

#endif
