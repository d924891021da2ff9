// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContours_h
#define OrthoSlicesContours_h

#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/// What is wrong with a contour of the input.
enum class ProblemKind : std::uint8_t
{
  NotFinite,     ///< a coordinate is NaN or infinite
  OffPlane,      ///< a vertex is farther from the contour's plane than the tolerance
  Open,          ///< an end point that meets no other
  CrossesItself, ///< two segments of the contour cross
  CrossesOther   ///< it crosses another contour of the same slice
};

/// A problem with its place: input port (0, 1, 2), cell of that input, world coordinates.
struct Problem
{
  ProblemKind Kind;
  int Port;
  std::int64_t Cell;
  Point3 Where;
};

/**
 * Polylines of one input port as the user has them: pieces of contours, one for each cell.
 * Piece i has the vertices Offsets[i] to Offsets[i + 1] - 1; U, V, W are the coordinates along
 * FirstAxis, SecondAxis and the slicing axis. Closed[i] says that the piece is a polygon, or that
 * its first point was repeated at the end (the repetition is not stored).
 *
 * Virtual[i] says that the piece lies on a virtual plane (see SpatialGrid); empty if none does.
 * REQUIRES: pieces on virtual planes are closed, have their interior on the left, and lie farther
 * than the tolerance of planes from pieces that are real.
 */
struct Pieces
{
  int Axis = 0;
  std::vector<double> U, V, W;
  std::vector<Index> Offsets{ 0 };
  std::vector<std::int64_t> Cell;
  std::vector<std::uint8_t> Closed;
  std::vector<std::uint8_t> Virtual;

  Index Count() const { return static_cast<Index>(this->Cell.size()); }
  bool IsVirtual(Index piece) const { return !this->Virtual.empty() && this->Virtual[piece] != 0; }
};

/**
 * Closed contours of all three axes, one after another. Contour i has the vertices Offsets[i] to
 * Offsets[i + 1] - 1 (first not repeated, no two consecutive ones equal, at least three) on the
 * plane Coordinate[i] of axis Axis[i]; Plane[i] is the index of that plane in the spatial grid.
 * Virtual[i] says that it is no contour of the input but one of a virtual plane (see SpatialGrid);
 * empty if none is.
 */
struct Contours
{
  std::vector<double> U, V;
  std::vector<Index> Offsets{ 0 };
  std::vector<std::int8_t> Axis;
  std::vector<double> Coordinate;
  std::vector<Index> Plane;
  std::vector<std::int64_t> Cell;
  std::vector<std::uint8_t> Virtual;

  Index Count() const { return static_cast<Index>(this->Axis.size()); }
  bool IsVirtual(Index contour) const
  {
    return !this->Virtual.empty() && this->Virtual[contour] != 0;
  }
  Index Size(Index contour) const { return this->Offsets[contour + 1] - this->Offsets[contour]; }

  /// World coordinates of a vertex of the contour.
  Point3 World(Index contour, Index vertex) const
  {
    const int axis = this->Axis[contour];
    Point3 point;
    point[axis] = this->Coordinate[contour];
    point[FirstAxis(axis)] = this->U[vertex];
    point[SecondAxis(axis)] = this->V[vertex];
    return point;
  }
};
}

#endif
