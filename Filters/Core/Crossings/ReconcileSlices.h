// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReconcileSlices_h
#define OrthoSlicesReconcileSlices_h

#include "Core/Base/Execution.h"
#include "Core/Crossings/CrossingTables.h"
#include "Core/Crossings/Repair.h"

#include <vector>

namespace orthoslices
{
/// How much the slices contradicted each other.
struct Reconciliation
{
  Index Vertices = 0; ///< vertices of M at which the real slices did not agree on inside or outside
  Index Edges = 0;    ///< edges of M from which unmatched crossings of real contours were taken
  std::vector<Repair> Repairs; ///< of real slices
};

/**
 * Makes the slices agree (our own addition; the paper assumes that they do), in two steps:
 *
 *   LabelVertices  at every vertex of M, all slices get the label, inside or outside, that has the
 *                  greater weight, by infinitesimal loops around the vertex;
 *   SnipEdges      then both slices at an edge of M agree at its two ends: their crossings are
 *                  matched, and those are taken out that stay unmatched.
 *
 * Afterwards every edge has the same number of crossings from both families, with alternating
 * signs, in the same order. Virtual slices give way to real ones. Slices that agree are left as
 * they are, bit for bit. Arcs that close by the snipping are appended to tables.Isolated if they
 * have three vertices or more.
 *
 * `background` is the winding number far away: 0, or 1 where the contours bound the outside.
 */
Reconciliation ReconcileSlices(const CrossingTables& tables,
  const AxisWeights& weights = { 1.0, 1.0, 1.0 }, int background = 0,
  const Execution& execution = Execution());
}

#endif
