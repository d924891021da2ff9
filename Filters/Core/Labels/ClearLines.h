// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesClearLines_h
#define OrthoSlicesClearLines_h

#include "Core/Base/Execution.h"
#include "Core/Slices/SpatialGrid.h"

#include <vector>

namespace orthoslices
{
/**
 * Gives contours of several structures the room beside the lines in which planes meet that a graph
 * gives those of one (our own addition), for all structures alike: so that drawing the graph of each
 * by itself changes nothing, and contours that were common stay so.
 *
 * Beside each line, on a slice, lie two strips as wide as the grid's Margin. Nothing is left within
 * them but sides straight across: what a contour does in a strip is moved to its outer rim, and from
 * there a side leads to the line. Where contours part on a line they part on the rims after that,
 * and those that pass have a side in common. Places on one edge of M at which contours pass, and
 * that are closer to each other than the Margin, or to the end of the edge, become one: what lies
 * between them ends on the rims. That is the limit of maps of the slice that neither tear nor fold,
 * so that contours touch each other or themselves afterwards, but cross nowhere but by rounding;
 * ShareBorders has to trace them anew. Where contours pass straight, and clear of all others that do
 * not, they stay as they are.
 *
 * `grid` has the planes and the coarsest precision of all structures. REQUIRES: contours cross
 * lines at the same places on both slices. Contours of which nothing is left are taken out.
 */
void ClearLines(
  const SpatialGrid& grid, const Execution& execution, const std::vector<Contours*>& structures);
}

#endif
