// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReconcileSlices_h
#define OrthoSlicesReconcileSlices_h

#include "Core/Crossings/RegisterCrossings.h"
#include "Core/Crossings/Repair.h"

#include <vector>

namespace orthoslices
{
/// How much the slices contradicted each other.
struct Reconciliation
{
  Index Vertices =
    0;             ///< vertices of M at which the three slices did not agree on inside or outside
  Index Edges = 0; ///< edges of M from which unmatched crossings of contours were taken
  std::vector<Repair> Repairs;
};

/**
 * Makes the slices agree (our own addition; the paper assumes that they do).
 *
 * At every vertex of M each of its three slices has a winding number, and they all get the label
 * that has the greater weight (with equal weights, the median; with two opposite halves, the
 * heaviest slice's): an infinitesimal loop around the vertex is inserted into the slice that
 * differs. Then both slices at an edge of M agree at its two ends, so their crossings, put in
 * alternating order, have the same first and last sign. They are matched so that the total length
 * on which the two slices disagree is least; what stays unmatched are pairs of neighbours, which
 * are *snipped*: on both faces beside the edge the two arcs that end there are joined.
 *
 * Afterwards every edge has the same number of crossings from both families, with alternating
 * signs, in the same order. Slices that agree are left as they are, bit for bit. Arcs that close
 * by the snipping are appended to `isolated` if they have three vertices or more.
 *
 * `background` is the winding number far away: 0, or 1 where the contours bound the outside.
 */
Reconciliation ReconcileSlices(const SpatialGrid& grid, GridCrossings& crossings,
  EdgeRegister& edges, std::vector<IsolatedLoop>& isolated,
  const AxisWeights& weights = { 1.0, 1.0, 1.0 }, int background = 0);
}

#endif
