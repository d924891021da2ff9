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

struct StructureTables
{
  const std::vector<StructureSurface>& Structures;
  std::vector<std::vector<Index>> MeshOf; ///< of each cycle, its number in Meshes, or -1
  const PatchOptions& Options;
};

/// Settles one cell, whose cycles of all structures are given; see SettleCommonCells.
SettledCell SettleCell(const StructureTables& tables, const std::vector<StructureCycle>& cycles);
}

#endif
