// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTypes_h
#define OrthoSlicesTypes_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

/**
 * Plain data that passes between the stages of the reconstruction; no VTK types.
 *
 * Lengths are world units. A slice of axis a lies on a plane of constant coordinate a and has
 * the in-plane axes u = FirstAxis(a) and v = SecondAxis(a), so that (u, v, a) is right-handed:
 * seen from the positive end of a, u points right, v points up and the interior of an oriented
 * contour lies on its left.
 */
namespace orthoslices
{
/// Numbers contours, vertices, crossings, nodes and cycles. At most 2^31 - 1 of each.
using Index = std::int32_t;

using Point3 = std::array<double, 3>;

constexpr int FirstAxis(int axis) { return (axis + 1) % 3; }
constexpr int SecondAxis(int axis) { return (axis + 2) % 3; }

/**
 * How the caller runs loops, hears of progress and stops. Work items are independent and write to
 * places of their own, so that the result does not depend on how the range is split.
 */
struct Execution
{
  using Range = std::function<void(std::size_t begin, std::size_t end)>;

  /// Calls the function for ranges that cover [0, count). DEFAULT: one range, this thread.
  std::function<void(std::size_t count, const Range&)> For = [](std::size_t count, const Range& run)
  {
    if (count > 0)
    {
      run(0, count);
    }
  };

  /// Takes the progress in [0, 1]; false stops at the next stage. DEFAULT: never stops.
  std::function<bool(double progress)> Continue = [](double) { return true; };
};

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
 */
struct Pieces
{
  int Axis = 0;
  std::vector<double> U, V, W;
  std::vector<Index> Offsets{ 0 };
  std::vector<std::int64_t> Cell;
  std::vector<std::uint8_t> Closed;

  Index Count() const { return static_cast<Index>(this->Cell.size()); }
};

/**
 * Closed contours of all three axes, one after another. Contour i has the vertices Offsets[i] to
 * Offsets[i + 1] - 1 (first not repeated, no two consecutive ones equal, at least three) on the
 * plane Coordinate[i] of axis Axis[i]; Plane[i] is the index of that plane in the spatial grid.
 */
struct Contours
{
  std::vector<double> U, V;
  std::vector<Index> Offsets{ 0 };
  std::vector<std::int8_t> Axis;
  std::vector<double> Coordinate;
  std::vector<Index> Plane;
  std::vector<std::int64_t> Cell;

  Index Count() const { return static_cast<Index>(this->Axis.size()); }
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
