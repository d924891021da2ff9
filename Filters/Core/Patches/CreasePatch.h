// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCreasePatch_h
#define OrthoSlicesCreasePatch_h

#include "Core/Patches/PatchBorder.h"

#include <vector>

namespace orthoslices
{
/**
 * The patch of a border with corners: a fan around the point that is closest to the tangent planes
 * of the border between the corners (T. Ju et al., "Dual Contouring of Hermite Data", 2002). So an
 * edge of the object that runs from corner to corner, and a vertex where edges meet, stay sharp,
 * which a smooth surface would round off and follow with waves. Returns the root mean square
 * distance of the point from the planes.
 */
double BuildCreasePatch(const SpatialGrid& grid, const PatchBorder& border,
  const std::vector<std::uint8_t>& corners, InnerPatch& patch);

/// Whether a contour has a corner on the border.
bool HasCorner(const PatchBorder& border, const std::vector<std::uint8_t>& corners);
}

#endif
