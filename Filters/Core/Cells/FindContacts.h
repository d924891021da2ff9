// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFindContacts_h
#define OrthoSlicesFindContacts_h

#include "Core/Base/Box.h"
#include "Core/Cells/PatchMesh.h"

#include <set>
#include <vector>

namespace orthoslices
{
/// A triangle of a patch and its box. Corners of one cell are the same point if their ids are.
struct PatchTriangle
{
  PatchTriangle(Index patch, const std::array<Point3, 3>& corners, const std::array<Index, 3>& ids);

  Index Patch;
  std::array<Point3, 3> Corners;
  std::array<Index, 3> Ids;
  Box3 Extent;
};

/// A patch in flat arrays that belong to others; corners are as in PatchMesh.
struct PatchArrays
{
  const double* Points; ///< x, y, z of each
  std::size_t PointCount;
  const Index* Corners; ///< three of each triangle
  std::size_t TriangleCount;

  Point3 PointAt(Index i) const
  {
    const double* p = this->Points + 3 * static_cast<std::size_t>(i);
    return { p[0], p[1], p[2] };
  }
};

/**
 * The triangles of all patches of one cell, for FindContacts. Patches are numbered from 0 in the
 * order in which they are added. Points of G have their own numbers as ids, points inside the cell
 * numbers below zero.
 */
class CellTriangles
{
public:
  explicit CellTriangles(const CycleGeometry& geometry);

  /// The fan of a cycle around a point.
  void AddFan(Index cycle, const Point3& center);
  void AddMesh(const PatchMesh& mesh);
  /// A patch of these cycles, which ascend.
  void AddPatch(PatchKind kind, const std::vector<Index>& cycles, const PatchArrays& arrays);

  std::vector<PatchTriangle> Triangles;
  std::vector<PatchKind> Kinds; ///< of each patch

private:
  const CycleGeometry& Geometry;
  Index LastId = 0; ///< the least that is in use
  std::vector<Index> Border, NodePlaces;
};

/// Pairs of patches of which earlier calls of FindContacts have found out that they do not touch.
struct KnownApart
{
  std::vector<Index> Numbers; ///< of the patches of this call; another patch has another number
  std::set<std::pair<Index, Index>> Pairs; ///< of numbers, ascending
};

/**
 * Pairs of patches with triangles that do not certainly meet in common corners only; (p, p) for a
 * patch that may touch itself, which a fan cannot. Ascending, each pair once. Of two fans or shells
 * that touch others it may be left out that they touch each other, too: both have to make room
 * anyway. Sorts the triangles along x and drops some. What is known to be apart is not tested
 * again.
 */
std::vector<std::pair<Index, Index>> FindContacts(std::vector<PatchTriangle>& triangles,
  const std::vector<PatchKind>& kinds, KnownApart* known = nullptr);
}

#endif
