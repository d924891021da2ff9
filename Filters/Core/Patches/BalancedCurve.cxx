// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/BalancedCurve.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// The height over a side from which on the curve is no smooth piece, whose sides would be balanced
/// by moving their ends, as a share of the side's length: a third of a circle has 0.29.
constexpr double MaxHeight = 0.25;

/// The share of the room beside it that a node point may take on its edge when it moves.
constexpr double ShareOfRoom = 0.25;

/// Added to squared cosines of angles between the surface's normal and an edge of M, so that nodes
/// on edges that run along the surface do not move far.
constexpr double LeastSquaredCosine = 0.05;

/// How far the end of two sides is to move to the right, so that both leave as much on one side as
/// on the other; not where one of them replaces a corner.
double BalanceOf(const LightCurve& light, std::size_t before, std::size_t after)
{
  double sum = 0.0;
  for (const std::size_t side : { before, after })
  {
    const double length = QuickDistance(light.Places[side].Place, light.Places[side + 1].Place);
    const double height = light.Sides[side].Height;
    if (std::abs(height) > MaxHeight * length)
    {
      return 0.0;
    }
    sum += height;
  }
  return 0.5 * sum;
}

/// The direction to the right of a path at the middle one of three points.
Point2 RightAt(const Point2& before, const Point2& here, const Point2& after)
{
  const Point2 a = here - before, b = after - here;
  const double first = std::max(Length(a), 1e-300), second = std::max(Length(b), 1e-300);
  const Point2 along = (1.0 / first) * a + (1.0 / second) * b;
  const double length = Length(along);
  return length > 0.0 ? Point2{ along[1] / length, -along[0] / length } : Point2{ 0.0, 0.0 };
}
}

BalancedCurve BalanceCurve(const std::vector<Point2>& curve, double tolerance)
{
  const LightCurve light = LightenCurve(curve, tolerance);
  const std::vector<CurvePlace>& places = light.Places;
  const std::size_t sides = light.Sides.size();
  BalancedCurve result;
  for (std::size_t i = 1; i < sides; ++i)
  {
    result.Places.push_back(places[i]);
    result.Vertices.push_back(places[i].Place +
      BalanceOf(light, i - 1, i) *
        RightAt(places[i - 1].Place, places[i].Place, places[i + 1].Place));
  }
  const auto bulge = [&](std::size_t side)
  {
    return BalanceOf(light, side, side) *
      RightAt(places[side].Place, places[side].Place, places[side + 1].Place);
  };
  result.Bulges = { bulge(0), bulge(sides - 1) };
  return result;
}

double NodeMove::Find() const
{
  const double move =
    0.25 * this->Bulges * this->Cosine / (this->Cosine * this->Cosine + LeastSquaredCosine);
  const double most = std::min(ShareOfRoom * this->Room, this->Most);
  return std::max(-most, std::min(most, move));
}
}
