// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLayOutTriangles_h
#define OrthoSlicesLayOutTriangles_h

#include "Core/Base/Execution.h"
#include "Core/Patches/InnerPatches.h"

#include <vector>

namespace orthoslices
{
/// Triangles that took the place of those of all patches, in the order of the patches, and their
/// points. Those of a part of all patches, once KeepPart has left others out.
struct ImprovedTriangles
{
  std::vector<double> Points;       ///< x, y, z of each
  std::vector<std::int64_t> Origin; ///< of each point, ascending: its id before; new ones: -1, last
  std::vector<Index> Corners;       ///< three points of each triangle

  bool IsPart = false;
  /// Of a part: the number of each point among those of all, ascending; where else it has triangles,
  /// as bits of PartsOfPoint; and how many triangles are before the part.
  std::vector<std::int64_t> Ids{};
  std::vector<std::uint8_t> OtherParts{};
  std::int64_t TrianglesBefore = 0;

  bool Any() const { return this->IsPart || !this->Corners.empty(); }
};

/**
 * The patches of all cycles. Those in Meshes (ascending by their first cycle) join several cycles
 * or are shells; those in Inner have points inside; the others are fans around the central point.
 * Patch i has the triangles Offsets[i] to Offsets[i + 1] - 1; a mesh of several cycles is the patch
 * of the first one, and the others have none.
 *
 * Point ids: first the points of G; then one point for each cycle, which is the central point, or,
 * for cycle k of a mesh, its point k, or the first point of its patch in Inner; then the other
 * points of the meshes, from MeshOffsets[m] on for mesh m; then those of Inner.
 */
struct Patches
{
  std::vector<double> CentralPoints;
  std::vector<PatchMesh> Meshes;
  InnerPatches Inner;
  std::vector<std::int64_t> Offsets{ 0 };
  std::vector<std::int64_t> MeshOffsets; ///< and where the points of Inner begin
  /// If there are any, Offsets are those of these triangles.
  ImprovedTriangles Improved;

  /// The id of the second point of a patch in Inner; its other points follow.
  std::int64_t InnerPointId(Index patch) const
  {
    return this->MeshOffsets.back() + this->Inner.PointOffsets[patch] - patch;
  }
  std::int64_t TriangleCount() const { return this->Offsets.back(); }
};

/// Sets the offsets, and the first points of the meshes and of Inner among the central points. With
/// `part`, only its cycles have triangles.
void LayOutTriangles(const NodeGraph& graph, const CellCycles& cycles, Patches& patches,
  const Portion* part = nullptr);

/// The points after those of G and the one of each cycle: x, y, z of each. See Patches.
std::vector<double> ListOtherPoints(const Patches& patches);

/// Writes three point ids for each triangle, counter-clockwise seen from outside.
template <typename Id>
void WriteTriangles(const Patches& patches, const CycleGeometry& geometry,
  const Execution& execution, Id* connectivity);

extern template void WriteTriangles(
  const Patches&, const CycleGeometry&, const Execution&, std::int32_t*);
extern template void WriteTriangles(
  const Patches&, const CycleGeometry&, const Execution&, long long*);

/// Triangles of points that they may share.
struct SurfaceTriangles
{
  std::vector<Point3> Points;
  std::vector<std::array<Index, 3>> Triangles; ///< counter-clockwise seen from outside
};

/// REQUIRES: the patches are laid out as triangles, which are not a part of all.
SurfaceTriangles ListTriangles(
  const CycleGeometry& geometry, const Patches& patches, const Execution& execution);
}

#endif
