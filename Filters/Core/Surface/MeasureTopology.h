// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMeasureTopology_h
#define OrthoSlicesMeasureTopology_h

#include "Core/Cells/ChooseJoins.h"
#include "Core/Cells/PatchMesh.h"

#include <vector>

namespace orthoslices
{
/// The connected parts of the surface, numbered from 0, and its topology.
struct SurfaceComponents
{
  std::vector<Index> OfPart; ///< the component of each node of G, then of each loop
  SurfaceTopology Topology;
};

/**
 * Numbers the components of the surface by their least node or loop, and counts its handles: parts
 * of G hang together by arcs, and by patches of several cycles. `meshes` are the patches that are
 * not fans.
 */
SurfaceComponents MeasureTopology(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes);
}

#endif
