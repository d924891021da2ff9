// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/JunctionFit.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// What a surface's area has to be, in squares of half the length of the curve, for it to have a
/// plane.
constexpr double MinArea = 1e-6;

/// How far a border may lie off its quadratic, in half the length of the curve.
constexpr double MaxResidual = 0.25;
}

Point3 JunctionFit::ToLocal(const Point3& place) const
{
  const Point3 p = (1.0 / this->Unit) * (place - this->Origin);
  return { Dot(p, this->Axes[0]), Dot(p, this->Axes[1]), Dot(p, this->Axes[2]) };
}

bool JunctionFit::Try(const std::vector<BorderSide>& border)
{
  JunctionFit fit(this->First, this->Last);
  fit.Origin = Between(this->First, this->Last, 0.5);
  fit.Unit = 0.5 * Length(this->Last - this->First);
  Point3 area{ 0.0, 0.0, 0.0 };
  double length = 0.0;
  for (const BorderSide& side : border)
  {
    area = area + Cross(side.From - fit.Origin, side.To - fit.Origin);
    length += Length(side.To - side.From);
  }
  if (!(Length(area) > MinArea * fit.Unit * fit.Unit))
  {
    return false;
  }
  fit.Axes = CompleteFrame(orthoslices::Unit(area));
  for (const BorderSide& side : border)
  {
    const Point3 p = fit.ToLocal(Between(side.From, side.To, 0.5));
    fit.Heights.AddPoint(p[0], p[1], p[2], Length(side.To - side.From) / length);
  }
  fit.Heights.HeightAtOrigin();
  double sum = 0.0;
  for (const BorderSide& side : border)
  {
    const double error = fit.HeightOver(Between(side.From, side.To, 0.5));
    sum += error * error * Length(side.To - side.From) / length;
  }
  fit.HasSurface = true;
  fit.Residual = std::sqrt(sum);
  if (!(fit.Residual < (this->HasSurface ? this->Residual : MaxResidual)))
  {
    return false;
  }
  *this = fit;
  return true;
}

/// How far the surface is above a place, in units.
double JunctionFit::HeightOver(const Point3& place) const
{
  const Point3 p = this->ToLocal(place);
  return this->Heights.HeightAt(p[0], p[1]) - p[2];
}

Point3 JunctionFit::NormalAt(const Point3& place) const
{
  const Point3 p = this->ToLocal(place);
  const std::array<double, 2> slopes = this->Heights.SlopesAt(p[0], p[1]);
  return orthoslices::Unit(this->Axes[2] - slopes[0] * this->Axes[0] - slopes[1] * this->Axes[1]);
}

void JunctionFit::Evaluate(double share, Point3& place, Point3& normal) const
{
  this->EvaluateBetween(this->First, this->Last, share, place, normal);
}

void JunctionFit::EvaluateBetween(
  const Point3& first, const Point3& last, double share, Point3& place, Point3& normal) const
{
  place = Between(first, last, share);
  normal = { 0.0, 0.0, 0.0 };
  if (!this->HasSurface)
  {
    return;
  }
  // The ends are on the curve, wherever the quadratic is there.
  const double atEnds = (1.0 - share) * this->HeightOver(first) + share * this->HeightOver(last);
  const double height = std::max(-1.0, std::min(1.0, this->HeightOver(place) - atEnds));
  normal = this->NormalAt(place);
  place = place + (this->Unit * height) * this->Axes[2];
}

Point3 JunctionFit::Project(Point3& place) const
{
  const Point3 normal = this->NormalAt(place);
  const double height = std::max(-1.0, std::min(1.0, this->HeightOver(place)));
  place = place + (this->Unit * height) * this->Axes[2];
  return normal;
}
}
