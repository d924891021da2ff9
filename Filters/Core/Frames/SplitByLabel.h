// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSplitByLabel_h
#define OrthoSlicesSplitByLabel_h

#include "Core/Frames/SortByPlanes.h"

#include <vector>

namespace orthoslices
{
/// What has no label.
constexpr Index NoLabel = -1;

/**
 * The slices of each label by themselves, in the common axes, in the order of the input (our own
 * addition). `labels` has the label of each polyline: from 0 to `count` - 1, or NoLabel for what
 * belongs to none. A plane on which a label has no contours is no plane of that label.
 */
std::vector<SortedSlices> SplitByLabel(
  const SortedSlices& sorted, const std::vector<Index>& labels, Index count);

/// How many vertices the slices have.
std::size_t CountVertices(const SortedSlices& sorted);
}

#endif
