// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCellOfStructures_h
#define OrthoSlicesCellOfStructures_h

#include "Core/Labels/CommonCells.h"
#include "Core/Patches/PatchBorder.h"

#include <vector>

namespace orthoslices
{
/// A cycle of one of several structures.
struct StructureCycle
{
  Index Structure;
  Index Cycle;
};

/// What a cycle gets in place of its patch.
struct NewPatch
{
  StructureCycle Cycle;
  InnerPatch Patch;
};

struct SettledCell
{
  std::vector<NewPatch> Patches;
  bool IsSettled = true; ///< no patches of the cell touch each other now
};

/// Settles one cell, whose cycles of all structures are given; see SettleCommonCells. `meshOf` has, for
/// each structure, the number of each cycle's mesh in its Patches, or -1.
SettledCell SettleCell(const std::vector<StructureSurface>& structures,
  const std::vector<std::vector<Index>>& meshOf, const std::vector<StructureCycle>& cycles);
}

#endif
