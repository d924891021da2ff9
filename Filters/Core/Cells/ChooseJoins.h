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

  bool operator==(const SurfaceTopology& other) const
  {
    return this->Components == other.Components && this->Genus == other.Genus;
  }
};

/**
 * Evidence that a join needs that makes a handle, because handles are rare: odds of 1.35 to 1. With
 * 0.3 instead of 0, of 224 sets of contours, cut from known surfaces at other positions than those
 * to which the weights were fitted, 155 instead of 149 got the right components and genus.
 */
constexpr double HandleEvidence = 0.3;
/**
 * A fragment, much smaller than the whole, needs up to so much less than 0 to be connected, unless
 * both cycles are flat: it is likelier to be a piece of a thin part than a solid of its own. Chosen
 * by hand: joins are made up to odds of 12 to 1 against them.
 */
constexpr double FragmentAllowance = 2.5;
/// The size, as a part of that of all contours, up to which a part counts as a fragment; the
/// allowance grows from here to size 0. Chosen by hand.
constexpr double LargestFragment = 0.5;

/**
 * Chooses among the joins that are not impossible, in descending order of evidence: first those
 * that connect two parts of the surface, which need evidence above 0, then those that make handles,
 * which need more than HandleEvidence. Fragments need less to be connected, down to
 * -FragmentAllowance. Given prior knowledge, as many of either sort are chosen as are needed, in
 * the same order. Cycles of one cell are never joined in a ring. Returns what the surface is like
 * if all of them can be made.
 */
SurfaceTopology ChooseJoins(
  const CycleGeometry& geometry, const PriorKnowledge& known, std::vector<CycleJoin>& joins);
}

#endif
