// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/SmoothSolids.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace orthoslices
{
namespace support
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

SmoothSolid MakeSolid(const char* name, double halfSize, int genus)
{
  SmoothSolid solid;
  solid.Name = name;
  // No box is symmetric to a plane of slices by chance.
  solid.Low = { -halfSize - 0.011, -halfSize - 0.023, -halfSize - 0.037 };
  solid.High = { halfSize + 0.017, halfSize + 0.013, halfSize + 0.029 };
  solid.Components = 1;
  solid.Genus = genus;
  return solid;
}

template <typename Function>
void SetFunction(Function&& function, SmoothSolid& solid)
{
  solid.ValueAndGradient = function;
  solid.Function = [function](const Point3& p)
  {
    Point3 gradient;
    return function(p, gradient);
  };
}

/// The trefoil, with its first two derivatives.
struct Knot
{
  static constexpr double Width = 0.31, Height = 0.42, Radius = 0.19;

  static Point3 At(double t)
  {
    return { Width * (std::sin(t) + 2.0 * std::sin(2.0 * t)),
      Width * (std::cos(t) - 2.0 * std::cos(2.0 * t)), -Height * std::sin(3.0 * t) };
  }
  static Point3 First(double t)
  {
    return { Width * (std::cos(t) + 4.0 * std::cos(2.0 * t)),
      Width * (-std::sin(t) + 4.0 * std::sin(2.0 * t)), -3.0 * Height * std::cos(3.0 * t) };
  }
  static Point3 Second(double t)
  {
    return { Width * (-std::sin(t) - 8.0 * std::sin(2.0 * t)),
      Width * (-std::cos(t) + 8.0 * std::cos(2.0 * t)), 9.0 * Height * std::sin(3.0 * t) };
  }
};

/// Where on the curve to look for the nearest point, for each small cube of space.
class KnotStarts
{
public:
  KnotStarts()
    : Starts(static_cast<std::size_t>(Count) * Count * Count)
  {
    std::array<Point3, Samples> curve;
    for (int i = 0; i < Samples; ++i)
    {
      curve[i] = Knot::At(2.0 * Pi * i / Samples);
    }
    for (int n = 0; n < Count * Count * Count; ++n)
    {
      const Point3 center{ Low + Size * (n % Count + 0.5), Low + Size * (n / Count % Count + 0.5),
        Low + Size * (n / Count / Count + 0.5) };
      const auto nearest = std::min_element(curve.begin(), curve.end(),
        [&](const Point3& a, const Point3& b)
        { return SquaredDistance(center, a) < SquaredDistance(center, b); });
      const bool far = Length(center - *nearest) > Knot::Radius + 3.0 * Size;
      this->Starts[n] = far ? -1.0 : 2.0 * Pi * (nearest - curve.begin()) / Samples;
    }
  }

  /// Negative if the point is well outside the tube.
  double At(const Point3& p) const
  {
    std::size_t number = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      const int i = static_cast<int>((p[axis] - Low) / Size);
      number = number * Count + std::max(0, std::min(Count - 1, i));
    }
    return this->Starts[number];
  }

private:
  static constexpr int Count = 80, Samples = 512;
  static constexpr double Low = -1.45, Size = 2.9 / Count;
  std::vector<double> Starts;
};

/// Newton's method for the nearest point of the curve.
double KnotValue(const KnotStarts& starts, const Point3& p, Point3& gradient)
{
  double t = starts.At(p);
  if (t < 0.0)
  {
    gradient = { 0.0, 0.0, 0.0 };
    return Knot::Radius;
  }
  for (int i = 0; i < 12; ++i)
  {
    const Point3 d = Knot::At(t) - p, first = Knot::First(t);
    const double slope = Dot(d, first);
    const double change = Dot(first, first) + Dot(d, Knot::Second(t));
    // Too near to the center of curvature: steepest descent instead.
    const double step = slope / std::max(change, 0.2 * Dot(first, first));
    t -= step;
    if (std::abs(step) < 1e-9)
    {
      break;
    }
  }
  const Point3 d = p - Knot::At(t);
  gradient = Unit(d);
  return Length(d) - Knot::Radius;
}
}

Point3 SmoothSolid::Project(const Point3& p, Point3& normal) const
{
  Point3 q = p;
  for (int round = 0; round < 30; ++round)
  {
    Point3 gradient;
    const double value = this->ValueAndGradient(q, gradient);
    const double squared = Dot(gradient, gradient);
    normal = Unit(gradient);
    if (!(squared > 0.0))
    {
      break;
    }
    // Onto the tangent plane: where that is nearest to p.
    const Point3 off = p - q;
    const Point3 aside = off - Dot(off, normal) * normal;
    const Point3 step = aside - (value / squared) * gradient;
    q = q + step;
    if (Dot(step, step) < 1e-28)
    {
      break;
    }
  }
  return q;
}

SmoothSolid SmoothTorus()
{
  SmoothSolid solid = MakeSolid("torus", 1.1, 1);
  const Point3 center{ 0.01, -0.02, 0.03 };
  const Point3 axis = Unit({ 0.4, 0.5, 0.77 });
  SetFunction(
    [=](const Point3& p, Point3& gradient)
    {
      const Point3 d = p - center;
      const Point3 inPlane = d - Dot(d, axis) * axis;
      const Point3 fromCircle = d - (0.62 / std::max(Length(inPlane), 1e-300)) * inPlane;
      gradient = Unit(fromCircle);
      return Length(fromCircle) - 0.27;
    },
    solid);
  return solid;
}

SmoothSolid SmoothEllipsoid()
{
  SmoothSolid solid = MakeSolid("ellipsoid", 1.0, 0);
  const Point3 first = Unit({ 0.83, 0.41, 0.37 });
  const Point3 second = Unit(Cross(first, { -0.2, 0.5, 0.6 }));
  const std::array<Point3, 3> axes{ first, second, Cross(first, second) };
  const std::array<double, 3> lengths{ 0.93, 0.64, 0.47 };
  SetFunction(
    [=](const Point3& p, Point3& gradient)
    {
      double value = -1.0;
      gradient = { 0.0, 0.0, 0.0 };
      for (int i = 0; i < 3; ++i)
      {
        const double x = Dot(p, axes[i]) / lengths[i];
        value += x * x;
        gradient = gradient + (2.0 * x / lengths[i]) * axes[i];
      }
      return value;
    },
    solid);
  return solid;
}

SmoothSolid SmoothGyroid()
{
  constexpr double frequency = 3.0, radius = 1.0, rounding = 0.5;
  SmoothSolid solid = MakeSolid("gyroid", 1.12, -1);
  SetFunction(
    [=](const Point3& p, Point3& gradient)
    {
      const Point3 x{ frequency * p[0] - 0.9, frequency * p[1] + 0.3, frequency * p[2] - 1.8 };
      const Point3 s{ std::sin(x[0]), std::sin(x[1]), std::sin(x[2]) };
      const Point3 c{ std::cos(x[0]), std::cos(x[1]), std::cos(x[2]) };
      // Both functions have slopes of about 1.
      const double gyroid = (s[0] * c[1] + s[1] * c[2] + s[2] * c[0]) / (1.4 * frequency) - 0.06;
      const Point3 ofGyroid = (1.0 / 1.4) *
        Point3{ c[0] * c[1] - s[2] * s[0], c[1] * c[2] - s[0] * s[1], c[2] * c[0] - s[1] * s[2] };
      const double ball = 0.5 * (Dot(p, p) / radius - radius);
      const Point3 ofBall = (1.0 / radius) * p;
      // The greater of both, but for the edge.
      const double difference = gyroid - ball;
      const double smooth = std::sqrt(difference * difference + rounding * rounding);
      const double share = difference / smooth;
      gradient = 0.5 * ((1.0 + share) * ofGyroid + (1.0 - share) * ofBall);
      return 0.5 * (gyroid + ball + smooth) - 0.4 * rounding;
    },
    solid);
  return solid;
}

SmoothSolid SmoothMetaballs()
{
  SmoothSolid solid = MakeSolid("metaballs", 1.1, -1);
  struct Blob
  {
    Point3 Center;
    double Width;
  };
  const std::array<Blob, 5> blobs{ Blob{ { -0.42, -0.31, -0.22 }, 0.46 },
    Blob{ { 0.38, -0.36, 0.11 }, 0.42 }, Blob{ { 0.05, 0.43, 0.31 }, 0.47 },
    Blob{ { -0.31, 0.19, -0.51 }, 0.38 }, Blob{ { 0.22, 0.05, 0.61 }, 0.35 } };
  SetFunction(
    [=](const Point3& p, Point3& gradient)
    {
      double value = 0.55;
      gradient = { 0.0, 0.0, 0.0 };
      for (const Blob& blob : blobs)
      {
        const Point3 d = p - blob.Center;
        const double scale = 1.0 / (blob.Width * blob.Width);
        const double height = std::exp(-scale * Dot(d, d));
        value -= height;
        gradient = gradient + (2.0 * scale * height) * d;
      }
      return value;
    },
    solid);
  return solid;
}

SmoothSolid SmoothKnot()
{
  SmoothSolid solid = MakeSolid("knot", 1.3, 1);
  const auto starts = std::make_shared<const KnotStarts>();
  SetFunction(
    [starts](const Point3& p, Point3& gradient) { return KnotValue(*starts, p, gradient); }, solid);
  return solid;
}

SmoothSolid SmoothEight()
{
  SmoothSolid solid = MakeSolid("eight", 1.0, 2);
  solid.Low = { -0.085, -0.673, -0.202 };
  solid.High = { 2.087, 0.674, 0.201 };
  SetFunction(
    [](const Point3& p, Point3& gradient)
    {
      const double x = p[0], y = p[1], z = p[2];
      const double curve = x * (x - 1.0) * (x - 1.0) * (x - 2.0) + y * y;
      const double slope = 2.0 * (x - 1.0) * (2.0 * x * x - 4.0 * x + 1.0);
      gradient = { 2.0 * curve * slope, 4.0 * curve * y, 2.0 * z };
      return curve * curve + z * z - 0.04;
    },
    solid);
  return solid;
}

std::vector<SmoothSolid> AllSmoothSolids()
{
  return { SmoothTorus(), SmoothEllipsoid(), SmoothGyroid(), SmoothMetaballs(), SmoothKnot() };
}

} // namespace support
} // namespace orthoslices
