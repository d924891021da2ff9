// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesImproveStructures_h
#define OrthoSlicesImproveStructures_h

#include "Core/Improve/ImprovableMesh.h"
#include "Core/Labels/CommonCells.h"

#include <vector>

namespace orthoslices
{
/**
 * ImproveSurface for several structures. What they have in common stays in common: it is changed
 * once, for all of them (CommonSheets). Triangles of different structures do not meet afterwards
 * but where they did before, as each change is tested against all of them. Curves along which
 * structures meet or part stay as they are. With `keepContours` all points of contours do, and
 * limits.Kept does not count.
 */
void ImproveStructures(const std::vector<StructureSurface>& structures,
  const ImprovementLimits& limits, bool keepContours, const Execution& execution);
}

#endif
