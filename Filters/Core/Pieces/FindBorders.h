// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFindBorders_h
#define OrthoSlicesFindBorders_h

#include "Core/Base/Box.h"
#include "Core/Pieces/ImageBorder.h"

namespace orthoslices
{
/**
 * Finds the sides of the border: where the contours of an axis reach farthest along u or v, and two
 * or more loose ends lie, at which contours do not run along it. An end lies at one side only, the
 * one that has most. Ends of the other axis that sees the same side count, too.
 *
 * `borders` has, for each axis, what all contours of that axis reach; the curves are those of all
 * axes.
 */
void FindBorders(const std::vector<OpenCurve>& curves, std::array<ImageBorder, 3>& borders);

/// Sets the sides that are given, instead of those that were found: both of each axis along which
/// the box is not empty, but for infinite ones. At a given side one end is enough.
void GiveBorders(const Box3& given, std::array<ImageBorder, 3>& borders);
}

#endif
