// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContourStack_h
#define OrthoSlicesContourStack_h

#include "Core/Base/Predicates.h"
#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/**
 * Contours of one family of parallel slices. Contour i has the vertices Offsets[i] to
 * Offsets[i + 1] - 1 (first not repeated, at least three) and lies on slice Slice[i], whose place
 * along the axis is Coordinate[Slice[i]]. Slices ascend, also from contour to contour. A slice may
 * be empty. The interior lies on the left: holes run clockwise. Contours of one slice may touch but
 * do not cross.
 */
struct ContourStack
{
  std::vector<double> U, V;
  std::vector<Index> Offsets{ 0 };
  std::vector<Index> Slice;
  std::vector<double> Coordinate;

  Index Count() const { return static_cast<Index>(this->Slice.size()); }
  Index SliceCount() const { return static_cast<Index>(this->Coordinate.size()); }
  Point2 At(Index vertex) const { return { this->U[vertex], this->V[vertex] }; }

  /// The vertex after this one of the contour.
  Index Next(Index contour, Index vertex) const
  {
    return vertex + 1 < this->Offsets[contour + 1] ? vertex + 1 : this->Offsets[contour];
  }
};

/// The contours of slice s are numbers first[s] to first[s + 1] - 1 of the result.
std::vector<Index> FirstContourOfSlices(const ContourStack& stack);

/// Area within each contour: positive for outer boundaries, negative for holes.
std::vector<double> SignedAreas(const ContourStack& stack);
}

#endif
