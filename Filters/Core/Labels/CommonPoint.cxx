// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/CommonPoint.h"

#include "Core/Base/QuadraticFit.h"
#include "Core/Base/Vectors.h"

#include <cmath>

namespace orthoslices
{
namespace
{
/// A quadratic over the mean plane of a surface.
class HeightFit
{
public:
  /// `middle` becomes the origin, `size` the unit of length.
  HeightFit(const std::vector<BorderSide>& border, const Point3& middle, double size);

  /// Mean distance of the border from the quadratic, infinite if there is none.
  double Residual = HUGE_VAL;
  Point3 Offset{ 0.0, 0.0, 0.0 }; ///< of the surface from the middle
};

HeightFit::HeightFit(const std::vector<BorderSide>& border, const Point3& middle, double size)
{
  Point3 area{ 0.0, 0.0, 0.0 };
  double length = 0.0;
  for (const BorderSide& side : border)
  {
    area = area + Cross(side.From - middle, side.To - middle);
    length += Length(side.To - side.From);
  }
  if (!(Length(area) > 1e-6 * size * size))
  {
    return;
  }
  const std::array<Point3, 3> frame = CompleteFrame(Unit(area));
  const auto coordinatesOf = [&](const BorderSide& side)
  {
    const Point3 p = (1.0 / size) * (Between(side.From, side.To, 0.5) - middle);
    return Point3{ Dot(p, frame[0]), Dot(p, frame[1]), Dot(p, frame[2]) };
  };
  QuadraticFit fit;
  for (const BorderSide& side : border)
  {
    const Point3 p = coordinatesOf(side);
    fit.AddPoint(p[0], p[1], p[2], Length(side.To - side.From) / length);
  }
  this->Offset = (size * fit.HeightAtOrigin()) * frame[2];
  double sum = 0.0;
  for (const BorderSide& side : border)
  {
    const Point3 p = coordinatesOf(side);
    const double error = p[2] - fit.HeightAt(p[0], p[1]);
    sum += error * error * Length(side.To - side.From) / length;
  }
  this->Residual = size * std::sqrt(sum);
}
}

Point3 FindCommonPoint(
  const Point3& first, const Point3& last, const std::vector<std::vector<BorderSide>>& surfaces)
{
  const Point3 middle = Between(first, last, 0.5);
  const double size = 0.5 * Length(last - first);
  double best = HUGE_VAL;
  Point3 offset{ 0.0, 0.0, 0.0 };
  for (const std::vector<BorderSide>& border : surfaces)
  {
    const HeightFit fit(border, middle, size);
    if (fit.Residual < best)
    {
      best = fit.Residual;
      offset = fit.Offset;
    }
  }
  return best < 0.25 * size && Length(offset) < size ? middle + offset : middle;
}
}
