// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesStitchSlabs_h
#define OrthoSlicesStitchSlabs_h

#include "Core/Base/Execution.h"
#include "Core/Cells/CycleJoin.h"
#include "Core/Correspondence/FindCorrespondences.h"

#include <vector>

namespace orthoslices
{
/// What a criterion says of the loops of G, whose cycles are the last ones. ByEvidence: overlap.
std::vector<LoopPair> PairLoops(
  const CycleGeometry& geometry, CorrespondenceCriterion criterion, const PriorKnowledge& known);

/**
 * The surface between parallel slices (our own addition): if there are slices of one family only,
 * all contours are loops, and each slab between two slices is one cell. The contours of a slab are
 * joined by overlay, see OverlaySlab: all of them together, so that patches cannot meet, or those
 * that the criterion joins by themselves, sheared if they do not overlap. New vertices are
 * inserted into the loops of G where contours cross in projection.
 *
 * Returns the patches, ascending by their first cycle; slabs that rounding spoils have none.
 */
std::vector<PatchMesh> StitchSlabs(const SpatialGrid& grid, const CellCycles& cycles,
  CorrespondenceCriterion criterion, const std::vector<LoopPair>& pairs, const Execution& execution,
  NodeGraph& graph);
}

#endif
