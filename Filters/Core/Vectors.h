// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesVectors_h
#define OrthoSlicesVectors_h

#include "Types.h"

#include <cmath>

/// Arithmetic of points and vectors in space.
namespace orthoslices
{
inline Point3 operator-(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}
inline Point3 operator+(const Point3& a, const Point3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}
inline Point3 operator*(double s, const Point3& a) { return { s * a[0], s * a[1], s * a[2] }; }
inline double Dot(const Point3& a, const Point3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point3 Cross(const Point3& a, const Point3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}
inline double SquaredDistance(const Point3& a, const Point3& b)
{
  const Point3 d = b - a;
  return Dot(d, d);
}
inline Point3 Between(const Point3& a, const Point3& b, double share)
{
  return a + share * (b - a);
}
inline double Length(const Point3& a) { return std::sqrt(Dot(a, a)); }
/// Of unit length; zero stays zero.
inline Point3 Unit(const Point3& a)
{
  const double length = Length(a);
  return length > 0.0 ? (1.0 / length) * a : Point3{ 0.0, 0.0, 0.0 };
}
}

#endif
