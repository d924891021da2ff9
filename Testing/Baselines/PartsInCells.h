// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the connected parts of a known surface in each cell of a spatial grid
 */

#ifndef OrthoSlicesPartsInCells_h
#define OrthoSlicesPartsInCells_h

#include "Core/Slices/SpatialGrid.h"
#include "Core/Slicing/SliceSurface.h"

#include <map>
#include <utility>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/**
 * A triangle meets a cell, which is convex, in one piece. Pieces of neighbouring triangles in one
 * cell are connected if the edge between them passes through that cell.
 */
class PartsInCells
{
public:
  /// REQUIRES: CloseSurface() found no problem.
  PartsInCells(const TriangleSurface& surface, const SpatialGrid& grid);

  /// Names the part of the surface in a cell that the piece of a triangle belongs to. Two pieces of
  /// one cell are connected if it is the same.
  Index PartOf(Index triangle, const std::array<Index, 3>& cell);

private:
  Index PieceOf(Index triangle, const std::array<Index, 3>& cell);
  Index Root(Index piece);
  void Connect(Index first, Index second, const Point3& from, const Point3& to);

  const SpatialGrid& Grid;
  std::map<std::pair<Index, std::array<Index, 3>>, Index> Pieces;
  std::vector<Index> Parent; ///< of each piece, in its part
};

} // namespace baselines
} // namespace orthoslices

#endif
