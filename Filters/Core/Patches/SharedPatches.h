// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSharedPatches_h
#define OrthoSlicesSharedPatches_h

#include "Core/Patches/PatchBorder.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace orthoslices
{
/**
 * Patches of structures that were made before, by their borders, so that structures beside them
 * have the same patches where they have the same borders (our own addition). A border is the same
 * if its points are, to the last bit, wherever it starts and whichever way it runs: that of a
 * structure on the other side runs the other way.
 */
class SharedPatches
{
public:
  /**
   * The patch of a border, with its triangles and normals on the side where the border has them.
   * False if no structure had that border, or if its patch is none for this cell: a point of it is
   * not inside the room, or a side on a face. REQUIRES: the border was turned (PatchBorder::Turn),
   * as for Add.
   */
  bool Find(const PatchBorder& border, InnerPatch& patch) const;

  /// Keeps a patch, unless there is one of the same border.
  void Add(const PatchBorder& border, const InnerPatch& patch);

private:
  struct Entry
  {
    std::vector<Point3> Border; ///< from the least point towards the lesser one of its neighbours
    InnerPatch Patch;           ///< of the border in that direction
  };
  const Entry* FindEntry(const std::vector<Point3>& border) const;

  std::vector<Entry> Entries;
  std::unordered_multimap<std::uint64_t, std::size_t> ByHash;
};
}

#endif
