// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSeparatePatches_h
#define OrthoSlicesSeparatePatches_h

#include "TraceCycles.h"

namespace orthoslices
{
/**
 * A patch that is not a fan. Corners of its triangles are places on the border of its polygon (see
 * GetBoundary), or -1 - i for Points[i].
 */
struct ShellPatch
{
  Index Cycle;
  std::vector<Point3> Points;
  std::vector<std::array<Index, 3>> Triangles;
};

/// The shells, ascending by cycle, and the cycles of the cells in which they may still touch.
struct SeparatedPatches
{
  Index SharedCells = 0; ///< cells with several cycles
  std::vector<ShellPatch> Shells;
  std::vector<Index> Unresolved;
};

/**
 * Makes the patches of cells with several cycles disjoint (our own addition).
 *
 * The fan of one cycle cannot touch itself, and fans of different cells meet in shared arcs only.
 * But two fans in one cell may cross. Where they may, all patches of the cell become *shells*:
 * each cycle bounds a region on the boundary of the cell, the one away from a fixed corner, so
 * that regions are nested or disjoint. The shell of a cycle goes from the cycle towards the
 * middle of the cell to a depth that grows with the number of regions nested within, and there
 * covers a copy of its region, shrunk about the middle. Shells of nested regions lie beneath each
 * other; none can meet.
 *
 * Only rounding can spoil that, where arcs lie closer together than it moves the copies. Such
 * cells are unresolved: EmbedArcs has to draw their arcs anew.
 */
SeparatedPatches SeparatePatches(const SpatialGrid& grid, const NodeGraph& graph,
  const Crossings& crossings, const NodePoints& nodes, const Cycles& cycles,
  const std::vector<double>& centralPoints, const Execution& execution);

/**
 * Triangulates a simple polygon that runs counter-clockwise by cutting off ears. Triangles are
 * places in the polygon.
 */
std::vector<std::array<Index, 3>> TriangulatePolygon(
  const std::vector<std::array<double, 2>>& polygon);
}

#endif
