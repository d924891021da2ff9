// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContourTangents_h
#define OrthoSlicesContourTangents_h

#include "Predicates.h"

namespace orthoslices
{
/// Within how much of its length a contour turns at a corner, in mean plane spacings.
constexpr double CornerReach = 0.12;

/**
 * A closed polyline in the plane, and cubic curves fitted to parts of it by least squares: places
 * and tangents that do not follow its noise.
 */
class ContourCurve
{
public:
  /// The curve through these points, closed, without corners.
  void Set(std::vector<Point2>&& points);

  Index Count() const { return static_cast<Index>(this->Points.size()); }
  const Point2& operator[](Index i) const { return this->Points[i]; }
  /// Length from the first point; that of the whole curve for Count().
  double LengthTo(Index i) const { return this->Lengths[i]; }

  /**
   * Marks the corners: points at which the directions to and from the points that are `reach` away
   * differ by more than the angle (radians), and by more than at the other points so near.
   */
  void FindCorners(double reach, double angle);
  bool IsCorner(Index i) const { return !this->Corners.empty() && this->Corners[i] != 0; }
  bool HasCorners() const { return !this->Corners.empty(); }

  struct Fit
  {
    Point2 Place;
    Point2 Tangent;  ///< of unit length, in the curve's direction; zero if there is none
    double Residual; ///< root mean square distance of the points from the fit
  };
  /// The curve around a point, up to `window` of length before and after it or to the next corners.
  /// At least two points on each side are taken, and fewer terms if there are few.
  Fit FitAt(Index i, double window) const;

  /**
   * The length of curve over which its tangents are best measured: `least` where the curve is
   * smooth, and the more, the farther its points lie from a smooth curve, but not more than `most`.
   */
  double SuitableWindow(double least, double most) const;

private:
  struct Moments;
  double Step(Index i) const { return this->Lengths[i + 1] - this->Lengths[i]; }
  Index After(Index i) const { return i + 1 < this->Count() ? i + 1 : 0; }
  Index Before(Index i) const { return i > 0 ? i - 1 : this->Count() - 1; }
  Point2 Reach(Index i, double reach, bool forward) const;

  std::vector<Point2> Points;
  std::vector<double> Lengths;
  std::vector<std::uint8_t> Corners; ///< empty if there are none
};
}

#endif
