// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSlabPieces_h
#define OrthoSlicesSlabPieces_h

#include "Core/Slabs/SlabGroup.h"

#include <vector>

namespace orthoslices
{
/// A connected piece of an overlay, by what it joins.
struct SlabPiece
{
  std::vector<Index> Loops; ///< members of the group that bound it, ascending
  Index Handles = 0;
  bool Across = false; ///< has loops of both slices
  bool Mixed = false;  ///< has outer contours and holes
};

/// The pieces of a valid overlay, in the order of their numbers.
std::vector<SlabPiece> DescribePieces(const SlabGroup& group);

/// Whether a loop bounds a hole: it runs clockwise.
bool IsHole(const SlabLoop& loop);

/// For each loop of a group the smallest one of its slice that has it inside; -1 without.
std::vector<Index> FindNesting(const std::vector<SlabLoop>& loops);

/// The area that is inside on both slices, as the overlay has it, as a share of the smaller one of
/// what the two slices have inside; of these loops, which bound whole pieces.
double CommonShare(const SlabGroup& group, const std::vector<Index>& loops);
}

#endif
