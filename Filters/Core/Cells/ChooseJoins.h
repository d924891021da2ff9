// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesChooseJoins_h
#define OrthoSlicesChooseJoins_h

#include "Core/Cells/JoinEvidence.h"
#include "Core/Correspondence/PriorKnowledge.h"

#include <vector>

namespace orthoslices
{
/// How the cycles of a cell with several of them are filled.
enum class SeveralCycles
{
  ByEvidence, ///< discs, tubes and branchings, whichever the contours speak for
  Discs       ///< every cycle by a disc of its own, as in the paper
};

/// Components, and the genus of all of them together.
struct SurfaceTopology
{
  Index Components = 0;
  Index Genus = 0;
};

/**
 * Chooses among the joins that are not impossible, in descending order of evidence: first those
 * that connect two parts of the surface, which need evidence above 0, then those that make handles,
 * which need more than 0.3, because handles are rare. A part much smaller than the whole needs less
 * (down to -2.5, if no sheets pass through) to be connected, because a fragment of a thin part is
 * likelier than a small solid of its own. Given prior knowledge, as many
 * of either sort are chosen as are needed, in the same order. Cycles of one cell are never joined in
 * a ring. Returns what the surface is like if all of them can be made.
 */
SurfaceTopology ChooseJoins(
  const CycleGeometry& geometry, const PriorKnowledge& known, std::vector<CycleJoin>& joins);
}

#endif
