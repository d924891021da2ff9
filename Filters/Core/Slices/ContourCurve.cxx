// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/ContourCurve.h"

#include "Core/Base/LeastSquares.h"
#include "Core/Base/Vectors.h"

#include <algorithm>

namespace orthoslices
{
void ContourCurve::Set(std::vector<Point2>&& points)
{
  this->Points = std::move(points);
  this->Corners.clear();
  this->Exact = false;
  this->Lengths.assign(this->Points.size() + 1, 0.0);
  for (Index i = 0; i < this->Count(); ++i)
  {
    this->Lengths[i + 1] = this->Lengths[i] + this->Distance(i, this->After(i));
  }
}

double ContourCurve::Distance(Index i, Index j) const
{
  return Length(this->Points[j] - this->Points[i]);
}

/// The difference to the first point that is `reach` away.
Point2 ContourCurve::Reach(Index i, double reach, bool forward) const
{
  Point2 d{ 0.0, 0.0 };
  Index j = i;
  for (Index n = 0; n < this->Count() / 3 + 1; ++n)
  {
    j = forward ? this->After(j) : this->Before(j);
    d = this->Points[j] - this->Points[i];
    if (Dot(d, d) >= reach * reach)
    {
      break;
    }
  }
  return d;
}

double ContourCurve::FindNoise(double window) const
{
  // A sample of the points will do.
  const Index step = std::max<Index>(1, this->Count() / 64);
  std::vector<double> residuals;
  for (Index i = 0; i < this->Count(); i += step)
  {
    if (!this->IsCorner(i))
    {
      residuals.push_back(this->FitAt(i, window).Residual);
    }
  }
  if (residuals.empty())
  {
    return 0.0;
  }
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  return *middle;
}

/// The least turn of a corner: directions are as uncertain as noise makes them.
double LeastTurn(double reach, double noise, double angle)
{
  constexpr double certainty = 3.0; // times the deviation of a direction
  return angle + certainty * 2.0 * noise / reach;
}

/// By how much the directions to and from a point differ (radians).
double ContourCurve::TurnAt(Index i, double reach) const
{
  const Point2 to = this->Reach(i, reach, false), from = this->Reach(i, reach, true);
  return std::abs(
    std::atan2(from[0] * to[1] - from[1] * to[0], -from[0] * to[0] - from[1] * to[1]));
}

void ContourCurve::FindCorners(double spacing, double noise, double angle)
{
  constexpr double minReach = 0.12;   // of the spacing
  constexpr double noiseReach = 10.0; // the directions are then known to some ten degrees
  const double reach = std::max(minReach * spacing, noiseReach * noise);
  this->Corners.assign(this->Points.size(), 1);
  this->MarkCorners(reach, LeastTurn(reach, noise, angle));
}

void ContourCurve::KeepCorners(double reach, double noise, double angle)
{
  if (this->HasCorners())
  {
    this->MarkCorners(reach, LeastTurn(reach, noise, angle));
  }
}

/// Of the points that are marked, leaves the sharpest ones that turn by more than that.
void ContourCurve::MarkCorners(double reach, double minimum)
{
  std::vector<double> turns(this->Points.size(), 0.0);
  bool any = false;
  for (Index i = 0; i < this->Count(); ++i)
  {
    const double turn = this->IsCorner(i) ? this->TurnAt(i, reach) : 0.0;
    turns[i] = turn > minimum ? turn : 0.0;
    any |= turn > minimum;
  }
  if (any)
  {
    this->MarkSharpest(turns, reach);
  }
  else
  {
    this->Corners.clear();
  }
}

void ContourCurve::MarkSharpest(const std::vector<double>& turns, double reach)
{
  for (Index i = 0; i < this->Count(); ++i)
  {
    bool sharpest = turns[i] > 0.0;
    double length = 0.0;
    for (Index j = i; sharpest && length <= reach && j != this->Before(i);)
    {
      length += this->Step(j);
      j = this->After(j);
      sharpest = length > reach || turns[j] <= turns[i];
    }
    length = 0.0;
    for (Index j = i; sharpest && length <= reach && j != this->After(i);)
    {
      j = this->Before(j);
      length += this->Step(j);
      sharpest = length > reach || turns[j] < turns[i];
    }
    this->Corners[i] = sharpest ? 1 : 0;
  }
}

/// Weighted sums of the powers of the length and of their products with both coordinates.
struct ContourCurve::Moments
{
  static constexpr int Terms = 4;
  double Powers[2 * Terms - 1] = {};
  double First[Terms] = {}, Second[Terms] = {};
  double Squares = 0.0; ///< of both coordinates
  int Count = 0;

  void Add(double x, double u, double v)
  {
    // Less weight for the points far away, and none of them without any.
    const double near = 1.0 - 0.9 * std::min(1.0, x * x);
    double power = near * near;
    this->Squares += power * (u * u + v * v);
    for (int k = 0; k < 2 * Terms - 1; ++k)
    {
      this->Powers[k] += power;
      if (k < Terms)
      {
        this->First[k] += power * u;
        this->Second[k] += power * v;
      }
      power *= x;
    }
    ++this->Count;
  }

  /// Coefficients of both coordinates, of as many terms as there are points for.
  bool Solve(int minForCubic, double (&u)[Terms], double (&v)[Terms]) const
  {
    const int terms = this->Count >= minForCubic ? 4 : this->Count >= 4 ? 3 : 2;
    // Points that hardly determine a curve give the straightest one.
    constexpr double straight = 1e-8;
    double matrix[Terms][Terms];
    for (int i = 0; i < Terms; ++i)
    {
      for (int j = 0; j < Terms; ++j)
      {
        matrix[i][j] = i < terms && j < terms ? this->Powers[i + j] : i == j ? 1.0 : 0.0;
      }
      u[i] = i < terms ? this->First[i] : 0.0;
      v[i] = i < terms ? this->Second[i] : 0.0;
      matrix[i][i] += i > 1 ? straight * this->Powers[0] : 0.0;
    }
    if (!Factorize(matrix))
    {
      return false;
    }
    Substitute(matrix, u);
    Substitute(matrix, v);
    return true;
  }
};

ContourCurve::Fit ContourCurve::FitAt(Index i, double window) const
{
  constexpr int fewest = 2;
  const Point2& origin = this->Points[i];
  const double scale = std::max(std::min(window, 0.3 * this->Lengths.back()), 1e-300);
  // No point is taken on both sides.
  const Index maximum =
    std::min(this->Count() / 3 + 1, std::max<Index>(1, (this->Count() - 1) / 2));
  Moments sums;
  sums.Add(0.0, 0.0, 0.0);
  for (const bool forward : { true, false })
  {
    double length = 0.0;
    Index j = i;
    for (Index n = 0; n < maximum && (n == 0 || !this->IsCorner(j)); ++n)
    {
      const Index next = forward ? this->After(j) : this->Before(j);
      length += this->Step(forward ? j : next);
      if (length > scale && n >= fewest)
      {
        break;
      }
      j = next;
      sums.Add((forward ? length : -length) / scale, (this->Points[j][0] - origin[0]) / scale,
        (this->Points[j][1] - origin[1]) / scale);
    }
  }
  double u[Moments::Terms], v[Moments::Terms];
  Fit fit{ origin, { 0.0, 0.0 }, 0.0 };
  if (sums.Solve(this->Exact ? 5 : 6, u, v))
  {
    fit.Place = { origin[0] + scale * u[0], origin[1] + scale * v[0] };
    fit.Tangent = { u[1], v[1] };
    double left = sums.Squares;
    for (int k = 0; k < Moments::Terms; ++k)
    {
      left -= u[k] * sums.First[k] + v[k] * sums.Second[k];
    }
    fit.Residual = scale * std::sqrt(std::max(0.0, left / sums.Powers[0]));
  }
  double length = std::hypot(fit.Tangent[0], fit.Tangent[1]);
  if (!(length > 0.0))
  {
    const Point2 &p = this->Points[this->Before(i)], &q = this->Points[this->After(i)];
    fit.Tangent = q - p;
    length = std::hypot(fit.Tangent[0], fit.Tangent[1]);
  }
  const double inverse = length > 0.0 ? 1.0 / length : 0.0;
  fit.Tangent = { inverse * fit.Tangent[0], inverse * fit.Tangent[1] };
  return fit;
}

void MeasuredCurve::Set(std::vector<Point2>&& points, double spacing, double cornerAngle)
{
  // Lengths of the windows along the curve are parts of the spacing of the planes: within them, a
  // curve between two slices hardly bends, and they have enough points for a fit.
  constexpr double noiseWindow = 0.3;
  constexpr double minWindow = 0.15;
  constexpr double maxWindow = 1.5;
  // Noise, as a part of the spacing, and length of segments, as a part of it, up to which a curve
  // counts as drawn through exact points; cuts through meshes have ten times that noise.
  constexpr double maxExactNoise = 1e-4;
  constexpr double maxExactStep = 0.25;
  this->Curve.Set(std::move(points));
  this->Noise = this->Curve.FindNoise(noiseWindow * spacing);
  this->Curve.FindCorners(spacing, 0.0, cornerAngle);
  if (this->Curve.HasCorners())
  {
    // The corners of a polygon with few vertices look like noise, and noise looks like corners:
    // they are corners if little noise is left between them.
    constexpr double explained = 0.1;
    const double betweenCorners = this->Curve.FindNoise(noiseWindow * spacing);
    if (betweenCorners <= explained * this->Noise)
    {
      this->Noise = betweenCorners;
    }
    else
    {
      this->Curve.FindCorners(spacing, this->Noise, cornerAngle);
    }
  }
  const double step = this->Curve.LengthTo(this->Curve.Count()) / this->Curve.Count();
  this->Curve.SetExact(this->Noise < maxExactNoise * spacing && step < maxExactStep * spacing);
  // The error of a slope is about noise / window^1.5 + window^3.
  const double window = 8.0 * std::pow(this->Noise / spacing, 0.4);
  this->Window = spacing * std::max(minWindow, std::min(maxWindow, window));
}
}
