// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPieceGroups_h
#define OrthoSlicesPieceGroups_h

#include "Core/Base/Box.h"
#include "Core/Frames/PlaneFit.h"

#include <vector>

namespace orthoslices
{
/// Polylines that lie on one plane because they belong to one contour.
struct PieceGroup
{
  std::vector<Index> Members; ///< ascending
  int Port = 0;               ///< of the first one
  Box3 Box;                   ///< around all of its points
  Point3 Center{ 0.0, 0.0, 0.0 };
  Scatter Points; ///< around the centre; none if there are coordinates that are not finite
  PlaneFit Fit;

  bool IsFinite() const { return this->Points.Points > 0; }

  /// Whether the points say which plane they lie on: no line, and rather a plane than a cloud.
  bool IsPlanar() const
  {
    return this->Points.Points >= 3 && this->Fit.Width > 0.02 * this->Fit.Length &&
      this->Fit.Thickness < 0.1 * this->Fit.Width;
  }

  /// As the area of the contour: how much it has to say.
  double Weight() const { return this->Fit.Length * this->Fit.Width; }

  double Extent(int axis) const { return this->Box.High[axis] - this->Box.Low[axis]; }
};

/**
 * Closed polylines are groups of their own; open ones are joined where two ends, and no more, lie
 * at exactly the same place. In loose segments, single pieces say nothing of the plane. The groups
 * ascend by their first members.
 */
std::vector<PieceGroup> GroupPieces(const Polylines& lines);
}

#endif
