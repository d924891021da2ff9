// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPolylines_h
#define OrthoSlicesPolylines_h

#include "Core/Base/Vectors.h"

#include <cstdint>
#include <vector>

namespace orthoslices
{
/// Where polylines come from: input port, block of a composite input (its flat index; 0 if the
/// input is none) and cell of that block.
struct PolylineSources
{
  std::vector<std::int8_t> Port;
  std::vector<Index> Block;
  std::vector<std::int64_t> Cell;
};

/**
 * Polylines of all inputs as the user has them, in world coordinates, before anything is known of
 * the planes that they lie on. Polyline i has the vertices Offsets[i] to Offsets[i + 1] - 1.
 * Closed[i] says that it is a polygon, or that its first point was repeated at the end (the
 * repetition is not stored).
 */
struct Polylines
{
  std::vector<double> X, Y, Z;
  std::vector<Index> Offsets{ 0 };
  std::vector<std::uint8_t> Closed;
  PolylineSources From;

  Index Count() const { return static_cast<Index>(this->Closed.size()); }
  Point3 PointAt(Index vertex) const
  {
    return { this->X[vertex], this->Y[vertex], this->Z[vertex] };
  }
  /// The coordinates along an axis.
  const std::vector<double>& Along(int axis) const
  {
    return axis == 0 ? this->X : axis == 1 ? this->Y : this->Z;
  }
};

/// Appends one of some polylines to others.
inline void AppendLine(const Polylines& from, Index line, Polylines& to)
{
  for (Index i = from.Offsets[line]; i < from.Offsets[line + 1]; ++i)
  {
    to.X.push_back(from.X[i]);
    to.Y.push_back(from.Y[i]);
    to.Z.push_back(from.Z[i]);
  }
  to.Offsets.push_back(static_cast<Index>(to.X.size()));
  to.Closed.push_back(from.Closed[line]);
  to.From.Port.push_back(from.From.Port[line]);
  to.From.Block.push_back(from.From.Block[line]);
  to.From.Cell.push_back(from.From.Cell[line]);
}
}

#endif
