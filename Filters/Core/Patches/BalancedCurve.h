// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesBalancedCurve_h
#define OrthoSlicesBalancedCurve_h

#include "Core/Patches/LightCurve.h"

#include <array>
#include <vector>

namespace orthoslices
{
/// A light curve whose vertices between its ends lie as far outside of the curve as its sides lie
/// inside.
struct BalancedCurve
{
  std::vector<CurvePlace> Places; ///< on the curve, the vertices between the ends only
  std::vector<Point2> Vertices;   ///< where they are to be
  /// How far the first and the last point would have to move towards the side to which the curve
  /// bulges there.
  std::array<Point2, 2> Bulges{};
};

/// Draws a curve with few vertices (LightenCurve), and moves them by about the distance that its
/// sides leave, but where a side replaces a corner. The same curve for either direction but for
/// rounding.
BalancedCurve BalanceCurve(const std::vector<Point2>& curve, double tolerance);

/// How far a node point is to move along its edge of M, so that the surface around it lies as much
/// outside of the sides of its arcs as inside.
struct NodeMove
{
  double Bulges = 0.0; ///< outwards, the sum of those of its four arcs
  double Cosine = 0.0; ///< of the angle between the surface's normal and the edge
  double Room = 0.0;   ///< beside it on the edge, on the nearer side; it takes a part of that
  double Most = 0.0;   ///< in any case

  double Find() const;
};
}

#endif
