// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPartTouching_h
#define OrthoSlicesPartTouching_h

#include "Core/Loops/TraceRegion.h"

namespace orthoslices
{
/**
 * Cuts off corners of loops where several of them meet in a node, so that they do not touch; see
 * TraceRegion. REQUIRES: no loop passes a node twice, no two pass the same half-edge, and none
 * cross.
 */
void PartTouching(const PlaneWalks& walks, const PlaneFaces& faces, std::vector<TracedLoop>& loops);
}

#endif
