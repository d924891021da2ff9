// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPartTouching_h
#define OrthoSlicesPartTouching_h

#include "Core/Loops/TraceRegion.h"

namespace orthoslices
{
/**
 * Cuts off corners of loops where several of one region meet in a node, so that they do not touch;
 * see TraceRegions. REQUIRES: in each region, no loop passes a node twice, no two pass the same
 * half-edge, and none cross.
 */
void PartTouching(
  const PlaneWalks& walks, const PlaneFaces& faces, std::vector<std::vector<TracedLoop>>& regions);
}

#endif
