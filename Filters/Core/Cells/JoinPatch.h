// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesJoinPatch_h
#define OrthoSlicesJoinPatch_h

#include "Core/Cells/TubePatch.h"

#include <vector>

namespace orthoslices
{
/**
 * One patch bounded by several cycles of a cell: a tube, or a branching if there are more than two
 * (our own addition). `joins` are the pairs that are joined, a tree on `cycles`, which ascend.
 *
 * The cycles at even and at odd distance in the tree become one closed curve each, by bridges
 * that are passed in both directions, and a tube connects the two: see TubePatch. The patch
 * touches the boundary of its cell in its cycles only. It may cross itself or others; see
 * FindContacts.
 */
class JoinedPatchBuilder
{
public:
  JoinedPatchBuilder(const CycleGeometry& geometry, const std::vector<Index>& cycles,
    const std::vector<std::pair<Index, Index>>& joins);
  /// The patch with its ring this share of the way from the first curve to the second. What takes
  /// time, the pairs, does not depend on the share: another one costs little.
  PatchMesh Build(double share) const;

private:
  TubePatch Bridged;        ///< without the tube
  PatchCurve First, Second; ///< of the cycles at even and at odd distance
  std::vector<PointPair> Pairs;
};

/// The joined patch with its ring at one share of the way only.
PatchMesh BuildJoinedPatch(const CycleGeometry& geometry, const std::vector<Index>& cycles,
  const std::vector<std::pair<Index, Index>>& joins, double share);
}

#endif
