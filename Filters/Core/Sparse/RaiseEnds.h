// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRaiseEnds_h
#define OrthoSlicesRaiseEnds_h

#include "Core/Sparse/EndRims.h"
#include "Core/Surface/LayOutTriangles.h"

#include <vector>

namespace orthoslices
{
/// The triangles of a reconstructed surface, patch by patch. The points of G come first.
struct DraftMesh
{
  std::vector<Point3> Points;
  std::vector<std::array<Index, 3>> Triangles;
  std::vector<Index> Patch; ///< of each triangle
};

/// How a stack ends with its patches and beside its loops.
struct StackEnds
{
  std::vector<EndKind> OfPatch;      ///< Unknown, too, for those that go on to another slice
  std::vector<std::uint8_t> HasRim;  ///< of each loop
  std::vector<std::uint8_t> HasWall; ///< of each loop: straight on to a rim half a slab farther
  std::vector<double>
    Levels; ///< along the axis of the stack, where slices meet these walls near the rims
};

/**
 * Gives the patches of a stack that end on one side of a slice the shape that guides show: those
 * that end flat are moved into the slice, and those with a rim are moved out to it, with a wall of
 * triangles between the slice and the rim. The wall has a patch of its own: the number of patches
 * is added to that of the patch within the rim. Points on rims are appended. Guides are cut at
 * rims.
 *
 * With GuideCurves::HalfSliceEnds, all patches that end between two slices have a rim in the middle
 * between them.
 */
StackEnds RaiseEnds(
  const CycleGeometry& geometry, const Patches& patches, GuideCurves& guides, DraftMesh& draft);
}

#endif
