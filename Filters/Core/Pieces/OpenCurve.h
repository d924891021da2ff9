// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesOpenCurve_h
#define OrthoSlicesOpenCurve_h

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <vector>

namespace orthoslices
{
/// Pieces of one slice that were joined to a curve with two loose ends, and what was mended of it.
struct OpenCurve
{
  int Axis = 0;
  double Plane = 0.0;
  std::int64_t Cell = -1; ///< of one of its pieces
  std::vector<Point2> Points;
  double Gap = 0.0;         ///< the longest gap that was closed in it
  Point2 GapAt{ 0.0, 0.0 }; ///< one of its ends
  double Trimmed = 0.0;     ///< length of what ran past a start; its ends meet if it is a loop
  bool IsLoop = false;
  bool IsAtBorder = false; ///< closed along the border of the image

  /// The first point, or the last.
  const Point2& End(int which) const { return which ? this->Points.back() : this->Points.front(); }
  double EndDistance() const { return Distance(this->Points.front(), this->Points.back()); }
  double Length() const
  {
    double length = 0.0;
    for (std::size_t i = 1; i < this->Points.size(); ++i)
    {
      length += Distance(this->Points[i - 1], this->Points[i]);
    }
    return length;
  }
  double MeanSegment() const
  {
    return this->Points.size() > 1 ? this->Length() / (this->Points.size() - 1.0) : 0.0;
  }
};
}

#endif
