// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContourEllipse_h
#define OrthoSlicesContourEllipse_h

#include "Core/Correspondence/ContourStack.h"

#include <vector>

namespace orthoslices
{
/**
 * The ellipse with the centre of area and the second moments (per area) of what a contour encloses,
 * its holes not subtracted. Lengths are world units, Major >= Minor >= 0 are the semi-axes, and
 * Direction is the unit vector along the major one.
 */
struct ContourEllipse
{
  Point2 Center{ 0.0, 0.0 };
  double Major = 0.0, Minor = 0.0;
  Point2 Direction{ 1.0, 0.0 };

  /// Area of the symmetric difference of contour and ellipse, divided by the contour's: 0 for an
  /// ellipse, 0.19 for a square; infinite for a contour without area.
  double Misfit = 0.0;

  /**
   * (uu, uv, vv) of the symmetric matrix that takes the unit circle to the ellipse about its
   * centre. Unlike an angle it changes continuously also where the ellipse becomes a circle.
   */
  Point3 Shape() const;
};

/// One for each contour.
std::vector<ContourEllipse> FitEllipses(const ContourStack& stack);

/// The ellipse with the given centre and Shape(); where that is not positive, the axis is 0.
ContourEllipse EllipseOfShape(const Point2& center, const Point3& shape);

/// Whether two ellipses overlap, decided on 64 points of each of them.
bool DoOverlap(const ContourEllipse& a, const ContourEllipse& b);
}

#endif
