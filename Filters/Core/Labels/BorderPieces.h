// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesBorderPieces_h
#define OrthoSlicesBorderPieces_h

#include "Core/Graph/FaceArcs.h"
#include "Core/Patches/LightenArcs.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace orthoslices
{
/// A part of the arcs of structures that all of them have in common: between two places at which
/// they part, or which are node points or corners of one of them.
struct BorderPiece
{
  int Axis = 0;               ///< of its slice
  std::vector<Point3> Points; ///< from the lesser end on, ends included
  bool IsFixed = false;       ///< keeps all points
};

/// A piece as a part of an arc.
struct PieceInArc
{
  Index Piece;
  Index First;     ///< its first point among those of the arc, of which the start node is 0
  bool IsReversed; ///< it runs the other way in this arc
};

/// An end of a piece: 0 is its first point.
struct PieceEnd
{
  Index Piece;
  int End;

  bool operator<(const PieceEnd& other) const
  {
    return this->Piece != other.Piece ? this->Piece < other.Piece : this->End < other.End;
  }
  bool operator==(const PieceEnd& other) const
  {
    return this->Piece == other.Piece && this->End == other.End;
  }
};

/**
 * The arcs of several structures as pieces that are the same for all structures that have them,
 * point by point, to the last bit. Loops are pieces, too, which are fixed, as are arcs around
 * patches of several cycles and in cells with several patches of one structure.
 */
class BorderPieces
{
public:
  explicit BorderPieces(const std::vector<ArcSurface>& structures);

  std::vector<BorderPiece> Pieces;
  /// Of each structure and each of its arcs, the pieces in the direction of the arc.
  std::vector<std::vector<std::vector<PieceInArc>>> OfArc;

  /// The places of the points of an arc or a loop, nodes included.
  static std::vector<Index> PointsOf(const CycleGeometry& geometry, Index arc);
  void Fix(std::size_t structure, Index arc);
  /// The ends of the four pieces at a node of a structure, ascending.
  std::array<PieceEnd, 4> EndsAt(
    const CycleGeometry& geometry, std::size_t structure, Index node) const;
  /// Whether some structure has a vertex of an arc at a node of another one.
  bool IsInsideArc(const Point3& place) const;

private:
  void FindCuts(const std::vector<ArcSurface>& structures);
  void AddArc(const ArcSurface& surface, std::size_t structure, Index arc);
  PieceInArc AddPiece(int axis, std::vector<Point3>&& points);

  struct Start ///< of a piece: no two begin with the same side, as they would part after it
  {
    int Axis;
    Point3 First, Second;

    bool operator<(const Start& other) const
    {
      return this->Axis != other.Axis ? this->Axis < other.Axis
        : this->First != other.First  ? this->First < other.First
                                      : this->Second < other.Second;
    }
  };
  std::map<Start, Index> Numbers;
  std::vector<Point3> Cuts;  ///< where arcs are divided, ascending
  std::vector<Point3> Inner; ///< of these, vertices of arcs, ascending
};
}

#endif
