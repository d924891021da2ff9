// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTraceRegion_h
#define OrthoSlicesTraceRegion_h

#include "Core/Planar/PlaneFaces.h"

#include <vector>

namespace orthoslices
{
/// A closed curve along half-edges of a plane graph.
struct TracedLoop
{
  std::vector<Index> HalfEdges;
  /// Where it passes from each half-edge to the next one: the nodes, but moved where loops touch.
  std::vector<Point2> Points;
  Index Walk; ///< which the greatest part of its length is from
};

/**
 * The border of what is inside, 1 for each face, as loops with the interior on their left. They are
 * simple polygons that neither cross nor touch: where several of them, or one several times, pass a
 * node, outlines part from each other, and holes from the outline. Corners there are cut off, each
 * at a distance of its own, by a quarter of what there is room for, and by 1 / 256 of the loop's
 * extent at most.
 */
std::vector<TracedLoop> TraceRegion(
  const PlaneWalks& walks, const PlaneFaces& faces, const std::vector<std::uint8_t>& inside);

/**
 * The same for several regions at once. Where one of them touches itself, corners of all are cut off
 * at the same places, and loops that run along each other get the same points: those of which a
 * corner lies within one that is cut off, or is the same corner, are cut off, too. So loops that did
 * not cross do not cross afterwards.
 */
std::vector<std::vector<TracedLoop>> TraceRegions(const PlaneWalks& walks, const PlaneFaces& faces,
  const std::vector<std::vector<std::uint8_t>>& insides);
}

#endif
