// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/LightCurve.h"

#include "Core/Base/TriangleDistance.h"
#include "Core/Base/Vectors.h"
#include "Core/Graph/SimplifyArcs.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// How many equal sides are tried: more are needed only where a curve has corners or noise, for
/// which MarkKept finds the better vertices.
constexpr int MaxEqualSides = 8;

/// A parabola has two thirds of its height as mean distance from its chord.
constexpr double HeightByMean = 1.5;

/// The deviation of the part of a curve between two places on it.
CurveDeviation MeasureDeviation(
  const std::vector<Point2>& curve, const CurvePlace& from, const CurvePlace& to)
{
  CurveDeviation deviation;
  double twiceArea = 0.0;
  Point2 previous = from.Place;
  for (std::size_t i = from.Side + 1; i <= to.Side; ++i)
  {
    deviation.Farthest =
      std::max(deviation.Farthest, DistanceToSegment(curve[i], from.Place, to.Place));
    twiceArea += Cross(previous - from.Place, curve[i] - from.Place);
    previous = curve[i];
  }
  twiceArea += Cross(previous - from.Place, to.Place - from.Place);
  const double length = QuickDistance(from.Place, to.Place);
  // A curve to the right of its chord and the chord backwards run counter-clockwise.
  deviation.Height = length > 0.0 ? HeightByMean * 0.5 * twiceArea / length : 0.0;
  return deviation;
}

/// Measures the sides between the places of a curve; false if a vertex is farther from one than the
/// tolerance.
bool MeasureSides(const std::vector<Point2>& curve, double tolerance, LightCurve& light)
{
  light.Sides.clear();
  for (std::size_t i = 1; i < light.Places.size(); ++i)
  {
    light.Sides.push_back(MeasureDeviation(curve, light.Places[i - 1], light.Places[i]));
    if (light.Sides.back().Farthest > tolerance)
    {
      return false;
    }
  }
  return true;
}

/// Divides a curve into parts of the same length.
void DivideEqually(const std::vector<Point2>& curve, const std::vector<double>& lengths, int parts,
  std::vector<CurvePlace>& places)
{
  places.assign(1, { 0, 0.0, curve.front() });
  std::size_t side = 0;
  for (int i = 1; i < parts; ++i)
  {
    const double length = lengths.back() * i / parts;
    while (side + 2 < curve.size() && lengths[side + 1] <= length)
    {
      ++side;
    }
    const double step = lengths[side + 1] - lengths[side];
    const double share = step > 0.0 ? std::min(1.0, (length - lengths[side]) / step) : 0.0;
    places.push_back({ side, share, Between(curve[side], curve[side + 1], share) });
  }
  places.push_back({ curve.size() - 2, 1.0, curve.back() });
}

/// The places of those vertices that MarkKept keeps.
void DivideAtKept(
  const std::vector<Point2>& curve, double tolerance, std::vector<CurvePlace>& places)
{
  std::vector<Point3> inSpace;
  for (const Point2& p : curve)
  {
    inSpace.push_back({ p[0], p[1], 0.0 });
  }
  std::vector<std::uint8_t> kept;
  MarkKept(inSpace, tolerance, kept);
  places.assign(1, { 0, 0.0, curve.front() });
  for (std::size_t i = 1; i + 1 < curve.size(); ++i)
  {
    if (kept[i] != 0)
    {
      places.push_back({ i, 0.0, curve[i] });
    }
  }
  places.push_back({ curve.size() - 2, 1.0, curve.back() });
}
}

LightCurve LightenCurve(const std::vector<Point2>& curve, double tolerance)
{
  LightCurve light;
  std::vector<double> lengths(curve.size(), 0.0);
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    lengths[i] = lengths[i - 1] + QuickDistance(curve[i - 1], curve[i]);
  }
  int parts = 1;
  bool isNear = false;
  for (; parts <= MaxEqualSides && !isNear; ++parts)
  {
    DivideEqually(curve, lengths, parts, light.Places);
    isNear = MeasureSides(curve, tolerance, light);
  }
  if (parts > 3) // else there is no way with less
  {
    LightCurve other;
    DivideAtKept(curve, tolerance, other.Places);
    if (!isNear || other.Places.size() < light.Places.size())
    {
      MeasureSides(curve, HUGE_VAL, other);
      return other;
    }
  }
  return light;
}
}
