// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRemoveTouching_h
#define OrthoSlicesRemoveTouching_h

#include "Core/Patches/InnerPatches.h"

#include <vector>

namespace orthoslices
{
/**
 * Takes out patches until none of those that are left touches another patch of its cell. In each
 * round, both patches of every contact go, if they are in `patches`. The fans that take their
 * places touch nothing; a mesh stays as it is. Ends after as many rounds as a cell has patches, at
 * most.
 *
 * `meshOf` has the number of each cycle's mesh in tables.Meshes, or -1.
 */
void RemoveTouching(const PatchTables& tables, const std::vector<Index>& meshOf,
  const Execution& execution, InnerPatches& patches);
}

#endif
