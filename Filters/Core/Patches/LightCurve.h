// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLightCurve_h
#define OrthoSlicesLightCurve_h

#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/// The part of a curve between two places on it, against the straight side that takes its place.
struct CurveDeviation
{
  double Farthest = 0.0; ///< the greatest distance of a vertex from the side
  /// The height of a parabola over the side with the same mean distance from it; positive on the
  /// right, seen in the direction of the curve.
  double Height = 0.0;
};

/// A place on a curve: on the side that begins at a point, so far along it.
struct CurvePlace
{
  std::size_t Side = 0;
  double Share = 0.0; ///< 0 at the beginning of the side, 1 at its end
  Point2 Place{};
};

/// A curve in the plane with fewer vertices: places on the curve, the first and the last among
/// them, and the deviations of the sides between them.
struct LightCurve
{
  std::vector<CurvePlace> Places;
  std::vector<CurveDeviation> Sides;
};

/**
 * Draws a curve with as few sides as keep all of its vertices within `tolerance`: sides of equal
 * length where that takes no more of them, so that triangles beside them can be well shaped; else
 * vertices that MarkKept keeps.
 */
LightCurve LightenCurve(const std::vector<Point2>& curve, double tolerance);
}

#endif
