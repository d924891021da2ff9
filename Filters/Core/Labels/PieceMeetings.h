// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPieceMeetings_h
#define OrthoSlicesPieceMeetings_h

#include "Core/Base/Types.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace orthoslices
{
/// A side of a piece in the plane of its slice.
struct PieceSide
{
  int Axis;          ///< of its slice,
  double Coordinate; ///< and where that is
  Point2 From, To;
  Index Piece;
};

/// The pieces of which sides on one slice meet but in a common end, each with the lesser number
/// first; a piece with itself where it does. Exact. Sorts the sides.
std::vector<std::pair<Index, Index>> FindMeetings(std::vector<PieceSide>& sides);
}

#endif
