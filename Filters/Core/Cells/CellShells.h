// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCellShells_h
#define OrthoSlicesCellShells_h

#include "Core/Cells/PatchMesh.h"

#include <vector>

namespace orthoslices
{
/**
 * Disjoint patches for all cycles of one cell (our own addition): one for each of the groups, which
 * have all cycles [first, last) between them, ascending in each.
 *
 * Each cycle bounds a region on the boundary of the cell, the one away from a fixed place, so that
 * regions are nested or disjoint. The *shell* of a cycle goes from the cycle towards the middle of
 * the cell to a depth that grows with the number of regions nested within, and there covers a copy
 * of its region, shrunk about the middle. Shells of nested regions lie beneath each other; none
 * can meet. The shell of a group of several cycles covers the region between them: the region of
 * one cycle without those of the others. The fixed place is chosen so that this is possible for
 * as many groups as can be; the other groups get no triangles.
 *
 * Only rounding can spoil that, where arcs lie closer together than it moves the copies.
 */
std::vector<PatchMesh> BuildShells(const CycleGeometry& geometry, const Index* first,
  const Index* last, const std::vector<std::vector<Index>>& groups);
}

#endif
