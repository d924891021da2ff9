// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCommonLines_h
#define OrthoSlicesCommonLines_h

#include "Core/Crossings/PairNodePoints.h"
#include "Core/Labels/ShareBorders.h"

namespace orthoslices
{
/// Where the contours of a structure cross the lines in which planes meet, as ReconcileSlices and
/// PairNodePoints leave them.
struct StructureCrossings
{
  SpatialGrid Grid;
  GridCrossings Crossings;
  NodePoints Nodes;
};

/**
 * Whether slices that were made to agree on each structure by itself agree on all of them together:
 * each place of a line in which planes meet has one of `sets`, and none, where both slices show
 * some, nowhere.
 */
bool DoStructuresAgree(
  const std::vector<StructureCrossings>& structures, const StructureSets& sets);

/**
 * What places become that have several structures on a slice where the slices across have one of
 * them: where one structure ends and another one begins just on a slice, both may be drawn there.
 * Of the sets that are `doubtful`, those are contradicted that slices seldom have in common on the
 * lines in which they meet, of what is drawn on both. On each slice such a set becomes the part of
 * it, among `sets`, that most slices across show there, or the first of its structures.
 */
SetReplacements FindContradictedSets(const std::vector<StructureCrossings>& crossings,
  const StructureSets& doubtful, const StructureSets& sets);
}

#endif
