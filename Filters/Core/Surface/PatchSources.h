// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPatchSources_h
#define OrthoSlicesPatchSources_h

#include "Core/Base/Execution.h"
#include "Core/Cells/PatchMesh.h"

#include <vector>

namespace orthoslices
{
/**
 * For each cycle, the source of its patch: of all sources of the arcs and loops around the patch
 * (all cycles of it together), the one with the longest part of its border; of equally long ones
 * the lowest. A patch around which nothing has a source has that of the nearest patch that has one,
 * in steps from patch to patch across arcs.
 *
 * `sources` has a number for each arc and then each loop of G, negative for those without a source.
 * The result is negative only if no source can be reached.
 */
std::vector<std::int64_t> FindPatchSources(const CycleGeometry& geometry,
  const std::vector<PatchMesh>& meshes, const std::vector<std::int64_t>& sources,
  const Execution& execution);
}

#endif
