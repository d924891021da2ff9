// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesGuideEnds_h
#define OrthoSlicesGuideEnds_h

#include "Core/Base/Box.h"
#include "Core/Graph/NodeGraph.h"
#include "Core/Sparse/GuideCurves.h"

#include <vector>

namespace orthoslices
{
/**
 * For each point of the loops of a stack, how far the object goes beyond the slice there, in world
 * units, as the guides beyond the first and the last slice show it; -1 where there are none. A guide
 * belongs to the loops on which, or nearest to which, it ends; the greatest height counts for a loop.
 */
std::vector<double> FindEndHeights(const NodeGraph& graph, const GuideCurves& guides);

/// Extends a box to all guides.
void AddPoints(const GuideCurves& guides, Box3& box);
}

#endif
