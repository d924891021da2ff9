// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMeshBlock_h
#define OrthoSlicesMeshBlock_h

#include "Core/Improve/BlockGrid.h"
#include "Core/Improve/ImprovableMesh.h"

#include <vector>

namespace orthoslices
{
/**
 * A part of a surface, that can be improved by itself: copies of all triangles that meet some
 * cells of a block. Those *inside*, with all corners in these cells and strictly inside of the block,
 * may change, and only so that their boxes remain there: whatever is done in several blocks is
 * independent of each other. All that they may meet, and all triangles around their corners, are
 * there, too. Points that have triangles that are not inside are *frozen*: they stay where they are.
 *
 * Points are numbered in this order: those that stand for what is beyond borders of sheets, those
 * outside, frozen ones inside, others that are to be kept, and those that may move.
 */
struct MeshBlock
{
  /// Triangles: those whose boxes meet the cells. The first `kept` points of the whole are to be kept.
  MeshBlock(const ImprovableMesh& whole, const Box3& box, const BlockCells& cells,
    const Index* begin, const Index* end, Index kept);

  bool HasInside(const Point3& place) const
  {
    return this->Box.HasInside(place) && this->Cells.Has(place);
  }
  /// Whether a triangle that is there is inside.
  bool IsInner(Index triangle) const { return this->HasCornersFrom(triangle, this->FirstInner); }
  /// Whether nothing around a triangle that is there is frozen.
  bool IsFree(Index triangle) const { return this->HasCornersFrom(triangle, this->FirstFree); }

  ImprovableMesh Mesh;
  Box3 Box;
  BlockCells Cells;
  std::vector<Index> Triangles, Points; ///< their numbers in the whole
  Index FirstInner = 0;                 ///< points from there on are inside,
  Index FirstFree = 0;                  ///< not frozen,
  Index Kept = 0;                       ///< and may move

private:
  bool HasCornersFrom(Index triangle, Index first) const;
  void NumberPoints(const ImprovableMesh& whole, Index kept);
  void CopyPoints(const ImprovableMesh& whole);
  void MarkCurves(const ImprovableMesh& whole);
  void CopyBorders(const SheetBorders& borders);
};
}

#endif
