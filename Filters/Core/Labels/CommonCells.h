// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCommonCells_h
#define OrthoSlicesCommonCells_h

#include "Core/Surface/LayOutTriangles.h"

#include <vector>

namespace orthoslices
{
/// The surface of one of several structures, its triangles laid out.
struct StructureSurface
{
  CycleGeometry Geometry;
  const SurfaceNormals& Normals; ///< empty if patches are not smooth
  Patches& Surface;
};

/// What SettleCommonCells did.
struct CommonCellCounts
{
  Index Common = 0;    ///< cells through which surfaces of several structures pass
  Index Settled = 0;   ///< of these, the ones whose patches were changed
  Index Unsettled = 0; ///< of these, the ones in which surfaces of structures may still cross
};

/**
 * Makes the surfaces of several structures pass through common cells of M without crossing each
 * other (our own addition). Within a cell the patches of all structures are compared:
 *
 *  - Borders that are the same in all points have the same patch; nothing is to be done.
 *  - Borders that have a part in common, where a common border of two structures ends, become fans
 *    around one common point. So do borders whose patches touch, and those that are the same but
 *    have patches that differ.
 *
 * On the boundary of a cell the borders of structures do not cross if their contours do not, and a
 * cell is convex: fans of such borders around one point meet in that point and in triangles over
 * what the borders have in common only. That is exact, whatever the borders are.
 *
 * The common point is the middle of the places where borders part, which lie on the curve in which
 * structures meet.
 *
 * Cells of structures are the same if the planes around them are, bit for bit; outermost slabs are
 * those beside their plane. Deterministic.
 */
CommonCellCounts SettleCommonCells(const std::vector<StructureSurface>& structures,
  const PatchOptions& options, const Execution& execution);
}

#endif
