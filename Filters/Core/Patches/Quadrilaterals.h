// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesQuadrilaterals_h
#define OrthoSlicesQuadrilaterals_h

#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/**
 * The quadrilateral of one node point in a spatial polygon (the paper's section 5): from the
 * middle of the arc before the node along the border to the middle of the arc after it, and back
 * to the central point. First and Last are places on the border of the polygon; Last may exceed
 * the border's length by wrapping around. Middles are vertices of the arcs; an arc without
 * vertices belongs to the quadrilateral of the node at its start.
 */
struct Quadrilateral
{
  Index First, Last;
};

/**
 * One quadrilateral for each node of a polygon whose border has `borderSize` points, with the
 * nodes at the ascending `nodePlaces`. Together they cover the border once; so does the one of a
 * border without nodes. Reuses the memory of `quadrilaterals`.
 */
void SplitIntoQuadrilaterals(Index borderSize, const std::vector<Index>& nodePlaces,
  std::vector<Quadrilateral>& quadrilaterals);
}

#endif
