// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSplitPolygons_h
#define OrthoSlicesSplitPolygons_h

#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/// Closed walks through numbered nodes in a plane. No two nodes lie at one place, and neighbours on
/// a walk (the first one follows the last one) are two nodes.
struct PlaneWalks
{
  std::vector<Point2> Nodes;
  std::vector<std::vector<Index>> Walks;
};

/**
 * Splits the sides of polygons, which may cross, touch and overlap as they like, so that two sides
 * of the walks that result have nothing in common but nodes, or are the same. This is exact,
 * although crossings are rounded: where that makes sides meet anew, they are split again. Corners
 * stay where they are, in their order. `walks` has one walk for each polygon; it has fewer than two
 * nodes if all of the polygon's corners are at one place.
 *
 * A crossing closer to a node than the resolution is moved there, and a side that passes a node
 * closer than half of that passes through it. The resolution is 2^-40 of the greatest extent, but
 * at least eight steps of double at the largest coordinate; so the splitting ends. It becomes
 * coarser if that takes many rounds. False if even so it did not end.
 */
bool SplitPolygons(const std::vector<std::vector<Point2>>& polygons, PlaneWalks& walks);
}

#endif
