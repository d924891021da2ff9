// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCheckPatchMeshes_h
#define OrthoSlicesCheckPatchMeshes_h

#include "Core/Cells/PatchMesh.h"

#include <string>

namespace orthoslices
{
/**
 * An invariant of the patches that are no fans, and of a patch with points inside: its triangles
 * have each side of the borders of its cycles once, in their direction, and every other side once
 * in either direction. So it closes up with the patches beside it (G1 and G3). Returns what is
 * wrong first, or an empty string. O(n log n) in the number of triangles.
 */
std::string CheckPatchCoversBorders(const CycleGeometry& geometry, const std::vector<Index>& cycles,
  const std::vector<std::array<Index, 3>>& triangles);

/// Checks all patches of a list by CheckPatchCoversBorders, and that no cycle has two of them.
std::string CheckPatchMeshes(const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes);
}

#endif
