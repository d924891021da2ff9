// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSlabGroup_h
#define OrthoSlicesSlabGroup_h

#include "Core/Cells/CycleJoin.h"
#include "Core/Correspondence/FindCorrespondences.h"
#include "Core/Graph/CycleGeometry.h"
#include "Core/Slabs/OverlaySlab.h"

#include <vector>

namespace orthoslices
{
/// Loops of G on the two slices of a slab that are overlaid together, and the outcome.
struct SlabGroup
{
  Index Slab;
  std::vector<Index> Loops; ///< of G
  std::vector<SlabLoop> Outlines;
  Point2 Shift{ 0.0, 0.0 }; ///< of the upper slice against the lower one, see OverlaySlab
  SlabOverlay Overlay;
};

/// The cycle of a loop of G in the cell below its slice, or in the one above.
Index CycleOfLoop(const CycleGeometry& geometry, Index loop, bool above);

/// A loop of G in the axes of its slice.
std::vector<Point2> OutlineOf(const NodeGraph& graph, Index loop);

/**
 * All loops of a slab together for ByEvidence and Overlap; for other criteria, those of a slab that
 * the pairs connect. The groups have no overlay yet.
 */
std::vector<SlabGroup> FormSlabGroups(const CycleGeometry& geometry,
  CorrespondenceCriterion criterion, const std::vector<LoopPair>& pairs);

/**
 * Overlays the loops of a group: straight or, if it `mayShear` and the straight overlay has several
 * pieces, so that the middles of both slices lie above each other.
 */
void OverlayGroup(bool mayShear, SlabGroup& group);

/// The middle of the loops of one slice, by their length.
Point2 MiddleOfCurves(const std::vector<SlabLoop>& loops, bool upper);

/// The middle of the box around the loops of one slice. REQUIRES: there are some.
Point2 MiddleOfBox(const std::vector<SlabLoop>& loops, bool upper);

/// The number of patches that an overlay consists of.
Index CountPieces(const SlabOverlay& overlay);
}

#endif
