// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContours_h
#define OrthoSlicesContours_h

#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/// What is wrong with a contour of the input, and what was done about it. The numbers are those of
/// the table of input problems.
enum class ProblemKind : std::uint8_t
{
  NotFinite,     ///< a coordinate is NaN or infinite
  OffPlane,      ///< a vertex is farther from the contour's plane than the tolerance
  Open,          ///< an end point that meets no other
  CrossesItself, ///< two segments of the contour cross
  CrossesOther,  ///< it crosses another contour of the same slice

  TooShort,          ///< a piece of one or two points that joins nothing: left out
  Flat,              ///< a loop without area: left out
  MovedOntoPlane,    ///< vertices a little off the contour's plane: put on it
  GapClosed,         ///< loose ends that are near to each other: joined
  OverrunTrimmed,    ///< a contour that runs past its start: trimmed to where it meets itself
  ClosedAlongBorder, ///< a contour that ends at the border of the image: closed along it
  LeftOpen,          ///< the same: left open there

  LoopsUnited,   ///< loops of one slice that cross or overlap: their union
  BridgeRemoved, ///< an outline and a hole joined by a line drawn twice: two loops
  LoopSplit,     ///< a loop that touches or crosses itself: several loops
  DrawnTwice     ///< a contour that was drawn before, exactly or nearly: left out
};
constexpr int ProblemKindCount = 16;

/// A problem with its place: input port (0, 1, 2), cell of that input, world coordinates.
struct Problem
{
  ProblemKind Kind;
  int Port;
  std::int64_t Cell;
  Point3 Where;
  /// How great it is, in world units: distance from the plane, length of the gap, of what was
  /// trimmed, left out or added, distance of the contours; 0 where that says nothing.
  double Size = 0.0;
  bool IsLeftOut = false; ///< the contour takes no part in the surface; else it was mended
  int Axis = Port;        ///< of the slice
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
