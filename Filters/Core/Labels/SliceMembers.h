// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSliceMembers_h
#define OrthoSlicesSliceMembers_h

#include "Core/Base/Contours.h"

#include <utility>
#include <vector>

namespace orthoslices
{
/// A contour of one of several structures.
struct SliceMember
{
  Index Structure;
  Index Contour;
};

/// The contours of all structures by slice, ascending by axis and coordinate; those of one slice
/// ascend by structure.
std::vector<std::vector<SliceMember>> ListSlices(const std::vector<const Contours*>& structures);

/// The vertices of a contour.
std::vector<Point2> PolygonOf(const Contours& contours, Index contour);
}

#endif
