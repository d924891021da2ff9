// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesJoinEvidence_h
#define OrthoSlicesJoinEvidence_h

#include "Core/Base/Execution.h"
#include "Core/Cells/CycleJoin.h"

#include <vector>

namespace orthoslices
{
/// Ascending by cell. `cells` are those of all cycles.
std::vector<CycleJoin> FindJoins(const CycleGeometry& geometry, const CellGroups& cells,
  const std::vector<double>& nodeNormals, const std::vector<double>& centralPoints,
  const KnownPairs& known, const Execution& execution);
}

#endif
