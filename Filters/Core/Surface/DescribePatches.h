// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesDescribePatches_h
#define OrthoSlicesDescribePatches_h

#include "Core/Patches/EstimateNormals.h"
#include "Core/Surface/LayOutTriangles.h"

#include <vector>

namespace orthoslices
{
/// What was done to a patch, to be added. The numbers are part of the output.
enum PatchRepair : unsigned char
{
  NodesDisagree = 1, ///< a node point of its cycles disagrees by more than the tolerance
  ArcsChanged = 2,   ///< an arc of its cycles was changed so that it crosses no other
  PatchSeparated = 4 ///< it was separated from another patch
};

/// The sum of PatchRepair for each cycle; a patch of several cycles has those of all at the first
/// one. `tolerance` is in world units.
std::vector<unsigned char> FindPatchRepairs(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes, double tolerance);

/// Node points around the patch of each cycle, none around loops; a patch of several cycles has
/// those of all at the first one.
std::vector<Index> CountNodePoints(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes);

/**
 * Normals of the smooth surface at all points of the surface: x, y, z of each, zero where there is
 * none (at corners of contours and in patches that are not smooth). Empty if there are none at all.
 * `graphPoints` is the number of points of G, `points` that of all; see Patches for their order.
 */
std::vector<float> ListSmoothNormals(const SurfaceNormals& normals, const Patches& patches,
  Index graphPoints, std::int64_t points, const Execution& execution = Execution());
}

#endif
