// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesOverlaySurface_h
#define OrthoSlicesOverlaySurface_h

#include "Core/Slabs/OverlayGraph.h"

namespace orthoslices
{
/**
 * Lifts the triangles of both regions of an overlay to the levels of their nodes. Edges between
 * nodes of one level would lie in a slice and get a point in their middle, at half height; between
 * the two vertices at a crossing of contours runs an edge. Where the solid is inside above only,
 * its surface is seen from below and triangles run the other way round.
 *
 * `displacement` is that of the upper loops in the graph and is taken out of the new points, by
 * half. The result is valid.
 */
SlabOverlay MakeOverlaySurface(const OverlayGraph& graph, const std::array<PlaneRegion, 2>& regions,
  const std::array<TriangleAdjacency, 2>& triangles, const Point2& displacement);
}

#endif
