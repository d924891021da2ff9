// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSnipEdges_h
#define OrthoSlicesSnipEdges_h

#include "Core/Base/Execution.h"
#include "Core/Crossings/CrossingTables.h"
#include "Core/Crossings/Repair.h"

#include <vector>

namespace orthoslices
{
/**
 * The second step of ReconcileSlices. REQUIRES: both slices at an edge of M have the same winding
 * numbers, 0 or 1, at its ends (LabelVertices).
 *
 * Then the crossings of both families, put in alternating order, have the same first and last sign.
 * They are matched so that the total length on which the two slices disagree is least
 * (MatchAlternating). What stays unmatched are pairs of neighbours, which are *snipped*: on both
 * faces beside the edge, the two arcs of the contour that end there are joined. An arc that closes
 * in itself by that is appended to tables.Isolated, if it has three vertices or more. Of structures
 * (SpatialGrid::BothWays), contours that were drawn anew have vertices on grid lines; one that only
 * touches a line in a vertex keeps that.
 *
 * Where a real slice meets a virtual one (see SpatialGrid), nothing is taken from the real one: the
 * virtual one gets a loop of two crossings for each pair that it lacks. So a contour of a real
 * slice that meets no real slice of another family stays as it is. What is taken from virtual
 * slices is neither reported nor counted.
 *
 * Returns the number of edges from which crossings of contours were taken, and appends a repair for
 * each pair of them. Afterwards every edge has the same number of crossings from both families,
 * with alternating signs, in the same order. `background` is the winding number far away.
 */
Index SnipEdges(const CrossingTables& tables, int background, std::vector<Repair>& repairs,
  const Execution& execution = Execution());
}

#endif
