// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesNestedRegions_h
#define OrthoSlicesNestedRegions_h

#include "Core/Labels/ShareBorders.h"

#include <vector>

/**
 * Several structures as regions one within the other (our own addition). Every place of a slice
 * belongs to one of some sets of structures, the empty one for outside; these have an order, and
 * region i is where the set has a number of i + 1 or more. So the numbers of the sets become
 * thresholds, as in the decomposition of a median filter: where slices that disagree vote for each
 * region by itself, what comes out is the median of the sets, one of those that were voted for, and
 * the regions are still one within the other. A vote for each structure by itself would leave
 * places without a structure, and others with several.
 */
namespace orthoslices
{
/// The sets in the order of their numbers.
using OrderedSets = std::vector<std::vector<Index>>;

/// The regions of structures. Places of sets that are not listed become like a neighbour, as in
/// ShareBorders. Empty if the contours of a slice could not be split where they meet.
std::vector<Contours> NestRegions(const OrderedSets& sets, const Execution& execution,
  const std::vector<const Contours*>& structures);

/// Gives contours that were drawn anew the cells of those before which have most of their vertices
/// on their slice; -1 if none has any.
void TakeCells(const Contours& before, Contours& contours);

/// What parts regions.
struct RegionParting
{
  const OrderedSets& Sets;
  /// All planes of each axis, ascending: where they meet, slices agree, and nothing is changed.
  const std::array<std::vector<double>, 3>& Planes;
  double Thickness; ///< slivers, as in ShareBorders, go to neighbours
};

/// The structures of regions, of which each may have another border than before: a place has the
/// set of the last region that it is in, whether or not it is in those before. False if the contours
/// of a slice could not be split; then the structures stay as they are.
bool PartRegions(const RegionParting& parting, const Execution& execution,
  const std::vector<Contours>& regions, const std::vector<Contours*>& structures);
}

#endif
