// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/ContourEllipse.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Eigenvalues (descending) of the symmetric matrix (uu, uv, vv) and the direction of the first.
struct Eigen
{
  double First, Second;
  Point2 Direction;

  explicit Eigen(const Point3& m)
  {
    const double mean = 0.5 * (m[0] + m[2]);
    const double half = 0.5 * (m[0] - m[2]);
    const double radius = std::hypot(half, m[1]);
    const double angle = radius > 0.0 ? 0.5 * std::atan2(m[1], half) : 0.0;
    this->First = mean + radius;
    this->Second = mean - radius;
    this->Direction = { std::cos(angle), std::sin(angle) };
  }
};

/// Place relative to the centre, in semi-axes: the ellipse becomes the unit circle.
Point2 InAxes(const ContourEllipse& ellipse, const Point2& p)
{
  const Point2 d = p - ellipse.Center;
  return { Dot(ellipse.Direction, d) / ellipse.Major, Cross(ellipse.Direction, d) / ellipse.Minor };
}

/// Signed area of the sector between two directions.
double Sector(const Point2& p, const Point2& q) { return 0.5 * std::atan2(Cross(p, q), Dot(p, q)); }

/// Signed area common to the unit disc and the triangle (origin, p, q).
double AreaInDisc(const Point2& p, const Point2& q)
{
  const Point2 d = q - p;
  const double a = Dot(d, d);
  const double b = Dot(p, d);
  const double discriminant = b * b - a * (Dot(p, p) - 1.0);
  if (!(a > 0.0) || !(discriminant > 0.0))
  {
    return Sector(p, q);
  }
  const double from = (-b - std::sqrt(discriminant)) / a;
  const double to = (-b + std::sqrt(discriminant)) / a;
  if (from >= 1.0 || to <= 0.0)
  {
    return Sector(p, q);
  }
  const auto at = [&](double t) { return p + t * d; };
  const Point2 enter = from > 0.0 ? at(from) : p;
  const Point2 leave = to < 1.0 ? at(to) : q;
  return Sector(p, enter) + 0.5 * Cross(enter, leave) + Sector(leave, q);
}

double MisfitOf(const ContourStack& stack, Index contour, const ContourEllipse& ellipse)
{
  double area = 0.0, common = 0.0;
  for (Index i = stack.Offsets[contour]; i < stack.Offsets[contour + 1]; ++i)
  {
    const Point2 p = InAxes(ellipse, stack.At(i));
    const Point2 q = InAxes(ellipse, stack.At(stack.Next(contour, i)));
    area += 0.5 * Cross(p, q);
    common += AreaInDisc(p, q);
  }
  return (std::abs(area) + Pi - 2.0 * std::abs(common)) / std::abs(area);
}

ContourEllipse FitEllipse(const ContourStack& stack, Index contour)
{
  const Point2 origin = stack.At(stack.Offsets[contour]);
  double area = 0.0, u = 0.0, v = 0.0, uu = 0.0, uv = 0.0, vv = 0.0;
  for (Index i = stack.Offsets[contour]; i < stack.Offsets[contour + 1]; ++i)
  {
    Point2 p = stack.At(i), q = stack.At(stack.Next(contour, i));
    p = p - origin;
    q = q - origin;
    const double w = Cross(p, q); // twice the area of the triangle with the origin
    area += w / 2.0;
    u += w * (p[0] + q[0]) / 6.0;
    v += w * (p[1] + q[1]) / 6.0;
    uu += w * (p[0] * p[0] + p[0] * q[0] + q[0] * q[0]) / 12.0;
    vv += w * (p[1] * p[1] + p[1] * q[1] + q[1] * q[1]) / 12.0;
    uv += w * (2.0 * (p[0] * p[1] + q[0] * q[1]) + p[0] * q[1] + q[0] * p[1]) / 24.0;
  }
  ContourEllipse ellipse;
  ellipse.Center = origin;
  ellipse.Misfit = std::numeric_limits<double>::infinity();
  if (area == 0.0)
  {
    return ellipse;
  }
  u /= area;
  v /= area;
  const Eigen axes(Point3{ uu / area - u * u, uv / area - u * v, vv / area - v * v });
  // The moments of an ellipse are a quarter of the squares of its semi-axes.
  ellipse.Center = { origin[0] + u, origin[1] + v };
  ellipse.Major = 2.0 * std::sqrt(std::max(axes.First, 0.0));
  ellipse.Minor = 2.0 * std::sqrt(std::max(axes.Second, 0.0));
  ellipse.Direction = axes.Direction;
  if (ellipse.Minor > 0.0)
  {
    ellipse.Misfit = MisfitOf(stack, contour, ellipse);
  }
  return ellipse;
}

/// Whether the centre or a point of the rim of one ellipse lies in the other one.
bool ReachesInto(const ContourEllipse& ellipse, const ContourEllipse& other)
{
  const auto contains = [&](const Point2& p)
  {
    const Point2 place = InAxes(other, p);
    return Dot(place, place) <= 1.0;
  };
  bool reaches = contains(ellipse.Center);
  for (int i = 0; i < 64 && !reaches; ++i)
  {
    const double a = ellipse.Major * std::cos(Pi * i / 32.0);
    const double b = ellipse.Minor * std::sin(Pi * i / 32.0);
    const Point2& e = ellipse.Direction;
    reaches = contains(
      { ellipse.Center[0] + a * e[0] - b * e[1], ellipse.Center[1] + a * e[1] + b * e[0] });
  }
  return reaches;
}
}

Point3 ContourEllipse::Shape() const
{
  const Point2& e = this->Direction;
  const double a = this->Major, b = this->Minor;
  return { a * e[0] * e[0] + b * e[1] * e[1], (a - b) * e[0] * e[1],
    a * e[1] * e[1] + b * e[0] * e[0] };
}

std::vector<ContourEllipse> FitEllipses(const ContourStack& stack)
{
  std::vector<ContourEllipse> ellipses;
  ellipses.reserve(stack.Slice.size());
  for (Index contour = 0; contour < stack.Count(); ++contour)
  {
    ellipses.push_back(FitEllipse(stack, contour));
  }
  return ellipses;
}

ContourEllipse EllipseOfShape(const Point2& center, const Point3& shape)
{
  const Eigen axes(shape);
  ContourEllipse ellipse;
  ellipse.Center = center;
  ellipse.Major = std::max(axes.First, 0.0);
  ellipse.Minor = std::max(axes.Second, 0.0);
  ellipse.Direction = axes.Direction;
  return ellipse;
}

bool DoOverlap(const ContourEllipse& a, const ContourEllipse& b)
{
  const double distance = Distance(a.Center, b.Center);
  return distance <= a.Major + b.Major && (ReachesInto(a, b) || ReachesInto(b, a));
}
}
