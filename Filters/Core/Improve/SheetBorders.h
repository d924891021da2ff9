// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSheetBorders_h
#define OrthoSlicesSheetBorders_h

#include "Core/Surface/CornerTable.h"

#include <vector>

namespace orthoslices
{
/**
 * Where sheets of surfaces meet. A corner table has closed surfaces only; a sheet has borders, along
 * which others continue it. So each sheet has points of its own, also where others have points at
 * the same place, and each of its borders is closed by a fan around a point that stands for what is
 * beyond it. Borders are curves of the table, and their points stay where they are. Empty for a
 * surface that is closed by itself.
 */
struct SheetBorders
{
  Index Beyond = 0; ///< the first so many points are none: they stand for what is beyond
  std::vector<Index>
    Site; ///< of points: the least one at the same place; of all others: that point
  std::vector<Index> Next; ///< the next point at the same place, in a circle

  /// There are none.
  static const SheetBorders& None()
  {
    static const SheetBorders none;
    return none;
  }

  Index SiteOf(Index point) const { return this->Has(point) ? this->Site[point] : point; }
  bool HasCopies(Index point) const { return this->Has(point) && this->Next[point] != point; }
  bool AreCopies(Index a, Index b) const { return this->SiteOf(a) == this->SiteOf(b); }

  /// Calls visit(point) for all points at the place of a point, that one first.
  template <typename Visit>
  void ForCopiesOf(Index point, Visit&& visit) const
  {
    Index copy = point;
    do
    {
      visit(copy);
      copy = this->Has(copy) ? this->Next[copy] : copy;
    } while (copy != point);
  }

  /// Whether a triangle is none, but stands for what is beyond a border.
  bool IsBeyond(const CornerTable& corners, Index triangle) const
  {
    for (Index corner = 3 * triangle; this->Beyond > 0 && corner < 3 * triangle + 3; ++corner)
    {
      if (corners.IsAlive(corner) && corners.VertexOf(corner) < this->Beyond)
      {
        return true;
      }
    }
    return false;
  }

private:
  bool Has(Index point) const { return static_cast<std::size_t>(point) < this->Site.size(); }
};
}

#endif
