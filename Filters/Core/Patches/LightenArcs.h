// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLightenArcs_h
#define OrthoSlicesLightenArcs_h

#include "Core/Base/Execution.h"
#include "Core/Cells/PatchMesh.h"
#include "Core/Patches/EstimateNormals.h"
#include "Core/Patches/LightCurve.h"

#include <vector>

namespace orthoslices
{
/// G with fewer vertices, for triangles. Only the points of G are others.
struct LightGraph
{
  NodeGraph Graph;
  std::vector<double> Positions; ///< of its nodes along their edges
  SurfaceNormals Normals;        ///< at the points of Graph

  bool Any() const { return !this->Positions.empty(); }
};

/// What arcs are lightened by.
struct ArcSurface
{
  const CycleGeometry& Geometry;
  const CellGroups& Cells;
  const std::vector<PatchMesh>& Meshes;
  const SurfaceNormals& Normals;
};

/**
 * Draws all arcs with few vertices, and moves vertices and node points towards the side to which
 * the contours bulge, by about the distance that sides leave between them and the contours: so the
 * surface lies as much outside of the contours as inside, and is as accurate with a third of the
 * triangles.
 *
 * `accuracy` is the tolerance as a share of MeanSpacingInSlices of each slice: no vertex of a
 * contour is farther from the arcs in its plane. Corners of contours stay. Node points stay on
 * their edges, in their order. Arcs around patches of several cycles, or in cells with several
 * patches, and loops keep all vertices, as these patches are known to be apart as they are; so do
 * faces whose arcs would cross. Arcs are embedded in their faces, and both patches beside an arc
 * have what is left of it: no cracks.
 */
LightGraph LightenArcs(const ArcSurface& surface, double accuracy, const Execution& execution);
}

#endif
