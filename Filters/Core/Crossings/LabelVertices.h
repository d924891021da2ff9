// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLabelVertices_h
#define OrthoSlicesLabelVertices_h

#include "Core/Base/Execution.h"
#include "Core/Crossings/CrossingTables.h"
#include "Core/Crossings/Repair.h"

#include <vector>

namespace orthoslices
{
/**
 * The first step of ReconcileSlices: at every vertex of M its three slices get the winding number
 * of the label, inside or outside, that has the greater weight; with equal weights, the median;
 * with two opposite halves, that of the heaviest slice. Windings beyond 0 and 1, of contours that
 * cross themselves, become 0 or 1, too. Into a slice that differs, infinitesimal loops around the
 * vertex are inserted: four crossings at the vertex each.
 *
 * Of a real slice and virtual ones (see SpatialGrid) only the real one is asked; a virtual one has
 * the casting vote between two real ones of the same weight, and the majority among virtual ones.
 *
 * Returns the number of vertices on which the real slices did not agree, and appends a repair for
 * each real slice that was overruled at one. Where they agree everywhere, nothing is changed.
 * `background` is the winding number far away.
 */
Index LabelVertices(const CrossingTables& tables, const AxisWeights& weights, int background,
  std::vector<Repair>& repairs, const Execution& execution = Execution());
}

#endif
