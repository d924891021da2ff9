// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPieceDrawing_h
#define OrthoSlicesPieceDrawing_h

#include "Core/Labels/BorderPieces.h"
#include "Core/Labels/PieceMeetings.h"
#include "Core/Patches/BalancedCurve.h"

#include <array>
#include <map>
#include <vector>

namespace orthoslices
{
/// A piece as it is to be drawn.
struct PieceDrawing
{
  std::vector<CurvePlace> Places; ///< on the piece, those between its ends
  std::vector<Point3> Vertices;   ///< and where they are to be
  std::array<Point3, 2> Bulges{}; ///< see BalancedCurve
};

/// A piece with as few vertices as keep all of its own within the tolerance, in world units.
PieceDrawing DrawPiece(const SpatialGrid& grid, const BorderPiece& piece, double tolerance);

/// A piece with all of its vertices.
PieceDrawing KeepPiece(const BorderPiece& piece);

/// Adds the sides of a piece as drawn, of whose ends some have moved from one place to another.
void AddSides(const BorderPiece& piece, const PieceDrawing& drawing,
  const std::map<Point3, Point3>& moved, Index number, std::vector<PieceSide>& sides);
}

#endif
