// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPatchMesh_h
#define OrthoSlicesPatchMesh_h

#include "Core/Base/Box.h"
#include "Core/Graph/CycleGeometry.h"

#include <algorithm>
#include <set>
#include <vector>

namespace orthoslices
{
/// Why a patch is not the fan of one cycle around its central point.
enum class PatchKind
{
  Shell, ///< it would have crossed another patch: see CellShells
  Joined ///< it is bounded by several cycles: see JoinPatch
};

/**
 * A patch that is not a fan. Corners of its triangles are places on the borders of its cycles (see
 * GetBoundary), one border after another, or -1 - i for Points[i].
 */
struct PatchMesh
{
  PatchKind Kind;
  std::vector<Index> Cycles; ///< ascending
  std::vector<Point3> Points;
  std::vector<std::array<Index, 3>> Triangles;
};

/// Where a cycle is in an ascending list.
inline std::size_t PlaceIn(const std::vector<Index>& cycles, Index cycle)
{
  return static_cast<std::size_t>(
    std::lower_bound(cycles.begin(), cycles.end(), cycle) - cycles.begin());
}

/// Euler characteristic of a patch.
Index EulerCharacteristic(const PatchMesh& mesh);

/// A triangle of a patch, its corners' places in a list of all points of the cell, and its box.
struct PatchTriangle
{
  PatchTriangle(Index patch, const std::array<Point3, 3>& corners, const std::array<Index, 3>& ids);

  Index Patch;
  std::array<Point3, 3> Corners;
  std::array<Index, 3> Ids;
  Box3 Extent;
};

/// What a patch is, for FindContacts.
enum class PatchShape : std::uint8_t
{
  Fan, ///< cannot touch itself
  Shell,
  Joined
};

/// Pairs of patches of which earlier calls of FindContacts have found out that they do not touch.
struct KnownApart
{
  std::vector<Index> Numbers; ///< of the patches of this call; another patch has another number
  std::set<std::pair<Index, Index>> Pairs; ///< of numbers, ascending
};

/**
 * Pairs of patches with triangles that do not certainly meet in common corners only; (p, p) for a
 * patch that may touch itself. Ascending, each pair once. Of two fans or shells that touch others
 * it may be left out that they touch each other, too. Sorts the triangles along x
 * and drops some. What is known to be apart is not tested again.
 */
std::vector<std::pair<Index, Index>> FindContacts(std::vector<PatchTriangle>& triangles,
  const std::vector<PatchShape>& shapes, KnownApart* known = nullptr);
}

#endif
