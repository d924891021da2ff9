// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCommonLines_h
#define OrthoSlicesCommonLines_h

#include "Core/Crossings/PairNodePoints.h"
#include "Core/Labels/ShareBorders.h"

namespace orthoslices
{
/// Where the contours of a structure cross the lines in which planes meet, as ReconcileSlices and
/// PairNodePoints leave them.
struct StructureCrossings
{
  SpatialGrid Grid;
  GridCrossings Crossings;
  NodePoints Nodes;
};

/**
 * Whether slices that were made to agree on each structure by itself agree on all of them together:
 * each place of a line in which planes meet has one of `sets`, and none, where both slices show
 * some, nowhere.
 */
bool DoStructuresAgree(
  const std::vector<StructureCrossings>& structures, const StructureSets& sets);
}

#endif
