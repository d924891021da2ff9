// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesStitchSlabs_h
#define OrthoSlicesStitchSlabs_h

#include "Core/Cells/PatchMesh.h"
#include "Core/Slabs/InsertVertices.h"

#include <vector>

namespace orthoslices
{
/// Patches between parallel slices, and the loops of G with the vertices that these need.
struct StitchedSlabs
{
  std::vector<PatchMesh> Patches; ///< ascending by their first cycle
  std::vector<GraphLoop> Loops;   ///< all loops of G, for SetLoops; none if nothing was stitched
};

/**
 * The surface between parallel slices (our own addition): if there are slices of one family only,
 * all contours are loops, and each slab between two slices is one cell. The contours of a slab are
 * joined by overlay, see OverlaySlab: all of them together, so that patches cannot meet, or those
 * that the criterion joins by themselves, sheared if they do not overlap. Loops get new vertices
 * where contours cross in projection; the patches are those of the loops returned. Slabs that
 * rounding spoils have no patches.
 */
StitchedSlabs StitchSlabs(const CycleGeometry& geometry, CorrespondenceCriterion criterion,
  const std::vector<LoopPair>& pairs, const Execution& execution);
}

#endif
