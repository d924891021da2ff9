// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTriangles_h
#define OrthoSlicesTriangles_h

#include "PatchMesh.h"

namespace orthoslices
{
/**
 * The patches of all cycles. Each quadrilateral of a polygon is a fan around the central point;
 * the patches in Meshes (ascending by their first cycle) are no fans. Patch i has the triangles
 * Offsets[i] to Offsets[i + 1] - 1; a mesh of several cycles is the patch of the first one, and the
 * others have none.
 *
 * Point ids: first the points of G; then one point for each cycle, which is the central point, or,
 * for cycle k of a mesh, its point k; then the other points of the meshes, from MeshOffsets[m] on
 * for mesh m.
 */
struct Patches
{
  std::vector<double> CentralPoints;
  std::vector<PatchMesh> Meshes;
  std::vector<std::int64_t> Offsets{ 0 };
  std::vector<Index> MeshOffsets;

  std::int64_t TriangleCount() const { return this->Offsets.back(); }
};

/// Sets the offsets, and the first points of the meshes among the central points.
void LayOutTriangles(const NodeGraph& graph, const Cycles& cycles, Patches& patches);

/// Writes three point ids for each triangle, counter-clockwise seen from outside.
template <typename Id>
void WriteTriangles(const Patches& patches, const CycleGeometry& geometry,
  const Execution& execution, Id* connectivity);

extern template void WriteTriangles(
  const Patches&, const CycleGeometry&, const Execution&, std::int32_t*);
extern template void WriteTriangles(
  const Patches&, const CycleGeometry&, const Execution&, long long*);
}

#endif
