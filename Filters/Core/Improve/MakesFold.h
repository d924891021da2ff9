// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMakesFold_h
#define OrthoSlicesMakesFold_h

#include "Core/Improve/CrossingGuard.h"
#include "Core/Improve/SheetBorders.h"

#include <vector>

namespace orthoslices
{
/// How sharp folds are around a change: the least cosine of the angle between the normals of triangles
/// that have a side in common; -1 if they lie on each other.
struct FoldChange
{
  double Before, After;
};
FoldChange MeasureFolds(const CornerTable& corners, const std::vector<Point3>& points,
  const SurfaceChange& change, const SheetBorders& borders = SheetBorders::None());

/// Whether the triangles at a corner's edge enclose less than ten degrees.
bool IsFolded(const CornerTable& corners, const std::vector<Point3>& points, Index corner);

/**
 * Whether a change lets two triangles nearly lie on each other at their common side, enclosing less
 * than ten degrees, and less than any did there before. They do not cross then, but after rounding
 * they may, and mesh generators refuse them. Where sheets meet, all that have that side count.
 */
bool MakesFold(const CornerTable& corners, const std::vector<Point3>& points,
  const SurfaceChange& change, const SheetBorders& borders = SheetBorders::None());
}

#endif
