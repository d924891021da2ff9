// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSlopeOverSlice_h
#define OrthoSlicesSlopeOverSlice_h

#include "Core/Base/LeastSquares.h"
#include "Core/Base/Monomials.h"
#include "Core/Base/Predicates.h"

namespace orthoslices
{
/**
 * The slope of a surface that runs nearly along a slice, around a part of its contour there (our
 * own addition). There the contour may turn sharply, and the slope change as fast with its length,
 * though the surface is hardly bent: its height over the slice is a smooth function of the place.
 * So a polynomial of degree three is fitted to the height, which is zero all along the contour, and
 * has known slopes at the node points.
 */
class SlopeOverSlice
{
public:
  /// Forgets all. Places are taken in units of `size` from the center.
  void Start(const Point2& center, double size);
  void AddZero(const Point2& place);
  void AddSlope(const Point2& place, const Point2& slope);
  bool Fit();
  Point2 SlopeAt(const Point2& place) const;

private:
  static constexpr int Degree = 3;
  static constexpr int Terms = MonomialCount(Degree);

  void Add(const double (&values)[Terms], double right);
  Point2 ToLocal(const Point2& p) const
  {
    return { (p[0] - this->Center[0]) / this->Size, (p[1] - this->Center[1]) / this->Size };
  }

  Point2 Center{};
  double Size = 1.0;
  double Matrix[Terms][Terms] = {};
  double Coefficients[Terms] = {}; ///< the right side before Fit()
};
}

#endif
