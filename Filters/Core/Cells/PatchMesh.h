// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPatchMesh_h
#define OrthoSlicesPatchMesh_h

#include "Core/Graph/CycleGeometry.h"

#include <algorithm>
#include <vector>

namespace orthoslices
{
/// What a patch is, by the way in which it is made.
enum class PatchKind : std::uint8_t
{
  Fan,      ///< of one cycle around one point, seen from which it cannot touch itself
  Stitched, ///< of loops of parallel slices, by overlay: see StitchSlabs
  Joined,   ///< of several cycles, by a tube with a ring of points: see JoinPatch
  Grafted,  ///< of several cycles, by thin tubes between other patches: see GraftPatch
  Shell     ///< a shrunk copy of the boundary of the cell and a wall around it: see CellShells
};

/**
 * A patch of one or several cycles of a cell, by its triangles. Their corners are places on the
 * borders of its cycles (see GetBoundary), one border after another, or -1 - i for Points[i].
 */
struct PatchMesh
{
  PatchKind Kind = PatchKind::Fan;
  std::vector<Index> Cycles; ///< ascending
  std::vector<Point3> Points;
  std::vector<std::array<Index, 3>> Triangles;

  /// Whether this is a disc that gave way to other patches of its cell.
  bool IsSeparatedDisc() const
  {
    return this->Kind == PatchKind::Shell && this->Cycles.size() == 1;
  }
};

/// Where a cycle is in an ascending list.
inline std::size_t PlaceIn(const std::vector<Index>& cycles, Index cycle)
{
  return static_cast<std::size_t>(
    std::lower_bound(cycles.begin(), cycles.end(), cycle) - cycles.begin());
}

/// Vertices minus edges plus triangles: 1 for a disc, 0 for a tube, 2 less for each handle.
Index EulerCharacteristic(const PatchMesh& mesh);
}

#endif
