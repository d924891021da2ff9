// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPieceMarks_h
#define OrthoSlicesPieceMarks_h

#include "Core/Base/Ranks.h"
#include "Core/Surface/PointNormals.h"

#include <cstdint>
#include <vector>

class vtkPolyData;

namespace orthoslices
{
struct Reconstruction;

/// The normals of some of all points, x, y and z of each; zero for -1, a new point.
std::vector<float> SelectNormals(
  const std::vector<float>& normals, const std::vector<std::int64_t>& points);

/// What a piece has to know of the whole surface; made before the result is consumed.
class PieceMarks
{
public:
  /// REQUIRES: result.Part.
  PieceMarks(const Reconstruction& result, const Ranks& ranks);

  /// Leaves the points of the piece, and marks these. Returns their normals of those of all points,
  /// or none if there are none.
  std::vector<float> Apply(const std::vector<float>& normals, vtkPolyData* surface);

  /// REQUIRES: Apply.
  const SharedPoints& GetShared() const { return this->Shared; }

private:
  std::vector<std::uint8_t> PartsOfPoints; ///< of the points of G, or of all if these are improved
  std::vector<std::int64_t> Ids;           ///< of improved points; else empty
  std::int64_t FirstInner;                 ///< the ids of what only this piece has begin here
  std::int64_t InnerBefore = 0;            ///< number of such points of the pieces before
  std::int64_t TrianglesBefore = 0;
  SharedPoints Shared;
};
}

#endif
