// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesJoinPieces_h
#define OrthoSlicesJoinPieces_h

#include "Core/Base/Contours.h"

#include <vector>

namespace orthoslices
{
/// Pieces joined end to end. Chain i has the links Offsets[i] to Offsets[i + 1] - 1.
struct PieceChains
{
  struct Link
  {
    Index Piece;
    bool IsForward; ///< as the piece was drawn
  };
  std::vector<Link> Links;
  std::vector<Index> Offsets{ 0 };
  std::vector<std::uint8_t> Closed;

  Index Count() const { return static_cast<Index>(this->Closed.size()); }
  /// Whether an open chain is one piece.
  bool IsSingle(Index chain) const { return this->Offsets[chain + 1] - this->Offsets[chain] == 1; }
};

/**
 * Joins the pieces of one axis where their ends meet, those of them for which `isUsable` is set.
 *
 * End points that coincide exactly are joined; what is still loose is joined to the nearest loose
 * end within `tolerance`. Where more than two ends meet, the pieces are paired so that they do not
 * cross. Of segments that were given twice, one is left out. The chains are in the order of their
 * first pieces, and a closed one begins with it.
 */
PieceChains JoinPieces(
  const Pieces& pieces, const std::vector<std::uint8_t>& isUsable, double tolerance);
}

#endif
