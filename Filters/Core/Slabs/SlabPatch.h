// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSlabPatch_h
#define OrthoSlicesSlabPatch_h

#include "Core/Cells/PatchMesh.h"
#include "Core/Slabs/InsertVertices.h"

#include <vector>

namespace orthoslices
{
/// What the patches of slabs are made from.
struct SlabSource
{
  const CycleGeometry& Geometry;
  int Axis; ///< of the slices
  const std::vector<SlabGroup>& Groups;
  const StitchedLoops& Stitched;
};

/// One piece of the overlay of a group as a patch. REQUIRES: the overlay is valid.
PatchMesh BuildSlabPatch(const SlabSource& source, std::size_t group, Index piece);
}

#endif
