// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContourCurve_h
#define OrthoSlicesContourCurve_h

#include "Core/Base/Predicates.h"

#include <vector>

namespace orthoslices
{
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
   * How far the points lie from a smooth curve: the median of the residuals of curves fitted up to
   * `window` around them.
   */
  double FindNoise(double window) const;

  /**
   * Marks the corners: points at which the directions to and from the points that are a little way
   * off differ by more than the angle (radians) and what noise can do, and by more than at the
   * other points so near. How far off, depends on the noise, and is a share of the spacing of the
   * planes at least.
   */
  void FindCorners(double spacing, double noise, double angle);
  /// Of the corners, leaves those that are corners at that distance, too: of the steps of an outline
  /// of pixels, those where the object itself turns.
  void KeepCorners(double reach, double noise, double angle);
  bool IsCorner(Index i) const { return !this->Corners.empty() && this->Corners[i] != 0; }
  /// From a point to the first one, forwards or backwards, that is at least `reach` away; after a
  /// third of the points, to the next one.
  Point2 Reach(Index i, double reach, bool forward) const;
  bool HasCorners() const { return !this->Corners.empty(); }

  /// Whether the points are known to lie on a smooth curve. Then few of them do for a cubic.
  void SetExact(bool exact) { this->Exact = exact; }
  bool IsExact() const { return this->Exact; }

  struct Fit
  {
    Point2 Place;
    Point2 Tangent;  ///< of unit length, in the curve's direction; zero if there is none
    double Residual; ///< root mean square distance of the points from the fit
  };
  /// The curve around a point, up to `window` of length before and after it (0.3 of the whole
  /// length at most) or to the next corners. Two points on each side are taken at least, if there
  /// are five, and fewer terms if there are few.
  Fit FitAt(Index i, double window) const;

private:
  double TurnAt(Index i, double reach) const;
  void MarkCorners(double reach, double minimum);
  void MarkSharpest(const std::vector<double>& turns, double reach);
  struct Moments;
  double Step(Index i) const { return this->Lengths[i + 1] - this->Lengths[i]; }
  double Distance(Index i, Index j) const;
  Index After(Index i) const { return i + 1 < this->Count() ? i + 1 : 0; }
  Index Before(Index i) const { return i > 0 ? i - 1 : this->Count() - 1; }

  std::vector<Point2> Points;
  std::vector<double> Lengths;
  std::vector<std::uint8_t> Corners; ///< empty if there are none
  bool Exact = false;
};

/// The curve through the points with its corners, and how it is best fitted.
struct MeasuredCurve
{
  ContourCurve Curve;
  double Noise = 0.0;
  /// Length before and after a point to which its tangent is fitted: where there is noise, longer.
  double Window = 0.0;

  /// `spacing` is that of the planes across the contour.
  void Set(std::vector<Point2>&& points, double spacing, double cornerAngle);
};
}

#endif
