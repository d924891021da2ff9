// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   solids without any edges, whose surface and normals are known to the precision of double
 *
 * For measurements of how fast errors fall: every function is infinitely often differentiable near
 * its surface, and so are the contours.
 */

#ifndef OrthoSlicesSmoothSolids_h
#define OrthoSlicesSmoothSolids_h

#include "Support/AnalyticSolids.h"

namespace orthoslices
{
namespace support
{

/// A solid whose function comes with its gradient.
class SmoothSolid : public Solid
{
public:
  /// Negative inside; sets the gradient.
  std::function<double(const Point3&, Point3&)> ValueAndGradient;

  /// The nearest point of the surface to one that is near it, and the unit normal there.
  Point3 Project(const Point3& p, Point3& normal) const;
};

SmoothSolid SmoothTorus();     ///< tilted
SmoothSolid SmoothEllipsoid(); ///< tilted, with three different axes
SmoothSolid SmoothGyroid();    ///< one side of a gyroid within a ball, the edge rounded
SmoothSolid SmoothMetaballs(); ///< where a sum of Gaussians is large
SmoothSolid SmoothKnot();      ///< tube around a trefoil, a curve of trigonometric functions

/// These five.
std::vector<SmoothSolid> AllSmoothSolids();

/// Of genus two: the surface (x (x - 1)^2 (x - 2) + y^2)^2 + z^2 = 0.04.
SmoothSolid SmoothEight();

} // namespace support
} // namespace orthoslices

#endif
