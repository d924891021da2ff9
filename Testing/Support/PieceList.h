// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   pieces of contours one by one, for what changes them
 */

#ifndef OrthoSlicesPieceList_h
#define OrthoSlicesPieceList_h

#include "Support/TextContours.h"

#include <vector>

namespace orthoslices
{
namespace support
{

/// Pieces one by one, to be put together in another way.
struct Piece
{
  std::vector<Point3> Vertices; ///< u, v, w
  std::uint8_t Closed;
};

inline std::vector<Piece> TakeApart(const Pieces& pieces)
{
  std::vector<Piece> list;
  for (Index i = 0; i < pieces.Count(); ++i)
  {
    list.push_back({ {}, pieces.Closed[i] });
    for (Index vertex = pieces.Offsets[i]; vertex < pieces.Offsets[i + 1]; ++vertex)
    {
      list.back().Vertices.push_back({ pieces.U[vertex], pieces.V[vertex], pieces.W[vertex] });
    }
  }
  return list;
}

inline void PutTogether(const std::vector<Piece>& list, Pieces& pieces)
{
  Pieces result;
  result.Axis = pieces.Axis;
  for (const Piece& piece : list)
  {
    for (const Point3& vertex : piece.Vertices)
    {
      result.U.push_back(vertex[0]);
      result.V.push_back(vertex[1]);
      result.W.push_back(vertex[2]);
    }
    result.Offsets.push_back(static_cast<Index>(result.U.size()));
    result.Cell.push_back(result.Count());
    result.Closed.push_back(piece.Closed);
  }
  pieces = std::move(result);
}

} // namespace support
} // namespace orthoslices

#endif
