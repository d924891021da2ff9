// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReconstructLabels_h
#define OrthoSlicesReconstructLabels_h

#include "Core/Labels/CommonCells.h"
#include "Core/ReconstructSorted.h"

#include <vector>

namespace orthoslices
{
/// The surfaces of several structures.
struct LabelSurfaces
{
  std::vector<Reconstruction> OfLabel; ///< one for each, of those of refused labels nothing
  CommonCellCounts Cells;
  bool Stopped = false; ///< Execution::Continue returned false
};

/**
 * ReconstructSorted for each of several structures, whose slices have common axes (see SplitByLabel).
 * Each has the surface that its own contours give, with the patches of structures before it where
 * borders are common (SharedPatches). Then SettleCommonCells has them pass through common cells
 * without crossing each other.
 */
LabelSurfaces ReconstructLabels(
  std::vector<SortedSlices>&& labels, const Options& options, const Execution& execution);
}

#endif
