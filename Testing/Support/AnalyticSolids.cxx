// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/AnalyticSolids.h"

#include "Support/Random.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace orthoslices
{
namespace support
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

Point3 operator+(const Point3& a, const Point3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

Point3 operator-(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Point3 operator*(double s, const Point3& a) { return { s * a[0], s * a[1], s * a[2] }; }

double Dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double Norm(const Point3& a) { return std::sqrt(Dot(a, a)); }

Point3 NearestOnSegment(const Point3& p, const Point3& a, const Point3& b)
{
  const Point3 ab = b - a;
  const double t = std::clamp(Dot(p - a, ab) / Dot(ab, ab), 0.0, 1.0);
  return a + t * ab;
}

Point3 NearestOnCurve(const Point3& p, const std::vector<Point3>& curve, bool closed)
{
  Point3 nearest = curve[0];
  double minimum = HUGE_VAL;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < curve.size(); ++i)
  {
    const Point3 q = NearestOnSegment(p, curve[i], curve[(i + 1) % curve.size()]);
    const Point3 d = p - q;
    if (Dot(d, d) < minimum)
    {
      minimum = Dot(d, d);
      nearest = q;
    }
  }
  return nearest;
}

Solid MakeSolid(const char* name, double halfSize, int components, int genus)
{
  Solid solid;
  solid.Name = name;
  // No box is symmetric to a plane of slices by chance.
  solid.Low = { -halfSize - 0.011, -halfSize - 0.023, -halfSize - 0.037 };
  solid.High = { halfSize + 0.017, halfSize + 0.013, halfSize + 0.029 };
  solid.Components = components;
  solid.Genus = genus;
  return solid;
}
}

const Tube& Solid::NearestTube(const Point3& p) const
{
  return *std::min_element(this->Tubes.begin(), this->Tubes.end(),
    [&](const Tube& a, const Tube& b)
    { return Norm(p - a.Nearest(p)) - a.Radius < Norm(p - b.Nearest(p)) - b.Radius; });
}

double Solid::Value(const Point3& p) const
{
  if (this->Function)
  {
    return this->Function(p);
  }
  double value = HUGE_VAL;
  for (const Tube& tube : this->Tubes)
  {
    value = std::min(value, Norm(p - tube.Nearest(p)) - tube.Radius);
  }
  return value;
}

Point3 Solid::Gradient(const Point3& p) const
{
  if (this->Function)
  {
    constexpr double step = 1e-6;
    Point3 gradient;
    for (int i = 0; i < 3; ++i)
    {
      Point3 before = p, after = p;
      before[i] -= step;
      after[i] += step;
      gradient[i] = (this->Function(after) - this->Function(before)) / (2.0 * step);
    }
    return gradient;
  }
  const Point3 d = p - this->NearestTube(p).Nearest(p);
  const double length = Norm(d);
  return length > 0.0 ? (1.0 / length) * d : Point3{ 0, 0, 0 };
}

Tube Ball(const Point3& center, double radius)
{
  return { [center](const Point3&) { return center; }, radius };
}

Tube Capsule(const Point3& a, const Point3& b, double radius)
{
  return { [a, b](const Point3& p) { return NearestOnSegment(p, a, b); }, radius };
}

Tube Torus(const Point3& center, const Point3& axis, double majorRadius, double minorRadius)
{
  const Point3 n = (1.0 / Norm(axis)) * axis;
  const auto nearest = [=](const Point3& p)
  {
    const Point3 d = p - center;
    const Point3 inPlane = d - Dot(d, n) * n;
    return center + (majorRadius / std::max(Norm(inPlane), 1e-300)) * inPlane;
  };
  return { nearest, minorRadius };
}

Tube CurveTube(std::vector<Point3> points, bool closed, double radius)
{
  const auto curve = std::make_shared<const std::vector<Point3>>(std::move(points));
  return { [curve, closed](const Point3& p) { return NearestOnCurve(p, *curve, closed); }, radius };
}

Solid TiltedTorus()
{
  Solid solid = MakeSolid("TiltedTorus", 1.1, 1, 1);
  solid.Tubes = { Torus({ 0.01, -0.02, 0.03 }, { 0.4, 0.5, 0.77 }, 0.62, 0.27) };
  return solid;
}

Solid InclinedThinTube()
{
  Solid solid = MakeSolid("InclinedThinTube", 1.1, 1, 0);
  solid.Tubes = { Capsule({ -0.83, -0.61, -0.41 }, { 0.82, 0.63, 0.42 }, 0.11) };
  return solid;
}

Solid BranchingTube()
{
  Solid solid = MakeSolid("BranchingTube", 1.1, 1, 0);
  const Point3 fork{ 0.03, 0.01, -0.07 };
  solid.Tubes = { Capsule({ -0.11, 0.05, -0.79 }, fork, 0.23),
    Capsule(fork, { 0.62, 0.21, 0.73 }, 0.2), Capsule(fork, { -0.57, -0.26, 0.69 }, 0.21) };
  return solid;
}

Solid KnottedTube()
{
  std::vector<Point3> curve;
  for (int i = 0; i < 96; ++i)
  {
    const double t = 2.0 * Pi * i / 96.0;
    curve.push_back({ 0.31 * (std::sin(t) + 2.0 * std::sin(2.0 * t)),
      0.31 * (std::cos(t) - 2.0 * std::cos(2.0 * t)), -0.42 * std::sin(3.0 * t) });
  }
  Solid solid = MakeSolid("KnottedTube", 1.25, 1, 1);
  solid.Tubes = { CurveTube(curve, true, 0.17) };
  return solid;
}

Solid LinkedTori()
{
  Solid solid = MakeSolid("LinkedTori", 1.2, 2, 2);
  solid.Tubes = { Torus({ -0.3, 0.02, 0.01 }, { 0.1, 0.2, 1.0 }, 0.55, 0.17),
    Torus({ 0.3, -0.01, 0.03 }, { 0.15, 1.0, -0.25 }, 0.55, 0.17) };
  return solid;
}

Solid Cochlea()
{
  std::vector<Point3> curve;
  for (int i = 0; i <= 96; ++i)
  {
    const double s = i / 96.0;
    const double angle = 2.0 * Pi * 2.25 * s;
    const double radius = 0.85 - 0.6 * s;
    curve.push_back({ radius * std::cos(angle), 0.9 * (s - 0.45), radius * std::sin(angle) });
  }
  Solid solid = MakeSolid("Cochlea", 1.15, 1, 0);
  solid.Tubes = { CurveTube(curve, false, 0.125) };
  return solid;
}

Solid HollowBall()
{
  // The shell between two spheres: a tube around the middle sphere.
  const Point3 center{ 0.02, 0.05, -0.03 };
  const auto nearest = [center](const Point3& p)
  {
    const Point3 d = p - center;
    return center + (0.6 / std::max(Norm(d), 1e-300)) * d;
  };
  Solid solid = MakeSolid("HollowBall", 1.0, 2, 0);
  solid.Tubes = { Tube{ nearest, 0.21 } };
  return solid;
}

Solid TwoDistantBalls()
{
  Solid solid = MakeSolid("TwoDistantBalls", 1.2, 2, 0);
  solid.Tubes = { Ball({ -0.7, -0.65, -0.6 }, 0.36), Ball({ 0.66, 0.7, 0.63 }, 0.35) };
  return solid;
}

std::vector<Solid> AllAnalyticSolids()
{
  return { TiltedTorus(), InclinedThinTube(), BranchingTube(), KnottedTube(), LinkedTori(),
    Cochlea(), HollowBall(), TwoDistantBalls() };
}

Solid RandomSolid(std::uint64_t seed)
{
  Random random(seed);
  const auto place = [&]() -> Point3 {
    return { random.Uniform(-0.6, 0.6), random.Uniform(-0.6, 0.6), random.Uniform(-0.6, 0.6) };
  };
  Solid solid = MakeSolid("RandomSolid", 1.4, -1, -1);
  solid.Name += std::to_string(seed);
  const std::size_t count = 1 + random.Below(6);
  for (std::size_t i = 0; i < count; ++i)
  {
    switch (random.Below(3))
    {
      case 0:
        solid.Tubes.push_back(Ball(place(), random.Uniform(0.15, 0.5)));
        break;
      case 1:
        solid.Tubes.push_back(Capsule(place(), place(), random.Uniform(0.1, 0.3)));
        break;
      default:
        solid.Tubes.push_back(
          Torus(place(), place(), random.Uniform(0.3, 0.5), random.Uniform(0.1, 0.2)));
    }
  }
  return solid;
}

} // namespace support
} // namespace orthoslices
