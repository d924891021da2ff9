// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEmptyPlanes_h
#define OrthoSlicesEmptyPlanes_h

#include "Core/Slices/SpatialGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace orthoslices
{
/// Which planes are added between all contours, if none are virtual.
enum class EmptyPlanes : std::uint8_t
{
  NotPassed, ///< those through which no contour of another axis passes
  All        ///< slices agree, so that nothing passes a plane but what ends on it
};

/**
 * Adds planes to a grid on which there are no contours, but those of other structures, so that
 * cells are the same for all (our own addition). Of the planes beside all contours, that is the
 * next one on each side; of those between them, all, or those through which no contour of another
 * axis passes. Without contours of other axes nobody knows that, and none of those is added. If the grid
 * has virtual planes, these are virtual, too, and all are added: whatever real slices show there is
 * more than what they do. Sets Contours::Plane. `planes` ascend on each axis.
 */
void AddEmptyPlanes(const std::array<std::vector<double>, 3>& planes, EmptyPlanes which,
  Contours& contours, SpatialGrid& grid);
}

#endif
