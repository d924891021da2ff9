// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPairLoops_h
#define OrthoSlicesPairLoops_h

#include "Core/Cells/CycleJoin.h"
#include "Core/Correspondence/FindCorrespondences.h"
#include "Core/Graph/CycleGeometry.h"

#include <vector>

namespace orthoslices
{
/**
 * What a criterion for parallel slices says of the loops of G (the paper's section 2): the pairs of
 * cycles of loops that bound one patch. For ByEvidence, those that overlap. Ascending.
 */
std::vector<LoopPair> PairLoops(
  const CycleGeometry& geometry, CorrespondenceCriterion criterion, const PriorKnowledge& known);
}

#endif
