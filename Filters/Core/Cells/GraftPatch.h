// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesGraftPatch_h
#define OrthoSlicesGraftPatch_h

#include "Core/Cells/PatchMesh.h"

#include <vector>

namespace orthoslices
{
/**
 * One patch of several, by thin tubes between them (our own addition): where BuildJoinedPatch,
 * which builds all anew, crosses itself or others, much of what is there can stay as it is.
 *
 * `parts` are patches and, without triangles, single cycles; `joins` are pairs of cycles of
 * different parts, the most important one first, a tree on the parts. From a patch a triangle is
 * taken out that is near the other one and faces it, another one at each `attempt` from 0; a single
 * cycle is an end of the tube itself. At least one of two parts that are joined has
 * triangles, when its turn comes.
 *
 * The result may cross itself or others; see FindContacts. It is empty if no triangle faces the
 * other part.
 */
PatchMesh GraftPatches(const CycleGeometry& geometry, const std::vector<PatchMesh>& parts,
  const std::vector<std::pair<Index, Index>>& joins, std::size_t attempt);
}

#endif
