// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCoonsPatch_h
#define OrthoSlicesCoonsPatch_h

#include "Core/Patches/PatchBorder.h"

namespace orthoslices
{
/**
 * The paper's patch (its section 5): one quadrilateral for each node point, bounded by half of each
 * arc beside it and by straight lines from the middles of these arcs to the central point, and
 * filled by bilinear blending of its sides (S. A. Coons, 1967). Each quadrilateral has `parts` x
 * `parts` meshes; those at the arcs end in the vertices of the arcs. False if the patch is folded
 * as PatchView sees it.
 */
bool BuildCoonsPatch(const SpatialGrid& grid, const PatchBorder& border, const Point3& centralPoint,
  Index parts, InnerPatch& patch);
}

#endif
