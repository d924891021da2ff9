// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReconstructLabels_h
#define OrthoSlicesReconstructLabels_h

#include "Core/Labels/CommonCells.h"
#include "Core/ReconstructSorted.h"

#include <vector>

namespace orthoslices
{
/// Two labels whose contours overlap, although neither is within the other one.
struct LabelOverlap
{
  Index First, Second;
  double Share; ///< of the area of the smaller one, on all slices together
};

/// What a label has lost where others are close.
struct LabelLoss
{
  Index Label;
  Index Contours; ///< that are thinner than what counts as a gap between labels, and are left out
  Index Parts;    ///< of its surface that hang together without the other labels, but not with them
};

/// The surfaces of several structures.
struct LabelSurfaces
{
  std::vector<Reconstruction> OfLabel; ///< one for each, of those of refused labels nothing
  CommonCellCounts Cells;
  std::vector<LabelOverlap> Overlaps; ///< the greatest one first
  std::vector<LabelLoss> Losses;      ///< of labels that have any, ascending
  bool Stopped = false;               ///< Execution::Continue returned false
};

/**
 * ReconstructSorted for several structures at once, whose slices have common axes (see
 * SplitByLabel). Those of which no two come near to each other have the surfaces of runs of their
 * own. Else
 *
 *   ShareBorders        contours get the same vertices where they run along each other
 *   SettleSidesOnPlanes where labels end just on a slice, those across agree with it
 *   FindRest            labels that slices lack get what the others leave there
 *   NestRegions, PartRegions  where slices contradict each other, each place gets the labels that
 *                       the median of all slices has
 *   AddEmptyPlanes      all have the same planes, so that cells are common
 *   SharedPatches       borders that are the same around a cell have the same patch
 *   SettleCommonCells   surfaces pass through common cells without crossing each other
 *
 * so that surfaces do not cross where contours do not. Where slices are too few, as SliceDensity
 * says of all together, all are bent and cut on the same virtual planes, and so is their union; of
 * a few slices of several families, virtual ones are those of a field, or of the surfaces as they
 * are. Virtual slices of the union are divided as the real ones are: what is outside of it belongs
 * to none, and no two have in common what real slices do not show them to have. ShareBorders does
 * that, and once more after the virtual slices agree with the real ones, by the same vote.
 */
LabelSurfaces ReconstructLabels(
  std::vector<SortedSlices>&& labels, const Options& options, const Execution& execution);
}

#endif
