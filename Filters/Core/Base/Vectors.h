// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesVectors_h
#define OrthoSlicesVectors_h

#include "Core/Base/Types.h"

#include <cmath>
#include <vector>

/// Arithmetic of points and vectors, in the plane and in space.
namespace orthoslices
{
inline Point2 operator-(const Point2& a, const Point2& b) { return { a[0] - b[0], a[1] - b[1] }; }
inline Point2 operator+(const Point2& a, const Point2& b) { return { a[0] + b[0], a[1] + b[1] }; }
inline Point2 operator*(double s, const Point2& a) { return { s * a[0], s * a[1] }; }
inline double Dot(const Point2& a, const Point2& b) { return a[0] * b[0] + a[1] * b[1]; }
/// Area of the parallelogram over two vectors, positive if b points to the left of a.
inline double Cross(const Point2& a, const Point2& b) { return a[0] * b[1] - a[1] * b[0]; }
inline double SquaredDistance(const Point2& a, const Point2& b)
{
  const Point2 d = b - a;
  return Dot(d, d);
}
/// The point on the way from a to b after a share of it.
inline Point2 Between(const Point2& a, const Point2& b, double share)
{
  return a + share * (b - a);
}
/// Never overflows, unlike the square root of the square, and takes more time than that.
inline double Length(const Point2& a) { return std::hypot(a[0], a[1]); }
inline double Distance(const Point2& a, const Point2& b) { return Length(b - a); }
/// Without that care for very large and small numbers.
inline double QuickDistance(const Point2& a, const Point2& b)
{
  return std::sqrt(SquaredDistance(a, b));
}

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
/// The point on the way from a to b after a share of it.
inline Point3 Between(const Point3& a, const Point3& b, double share)
{
  return a + share * (b - a);
}
inline double Length(const Point3& a) { return std::sqrt(Dot(a, a)); }
/// The vector of unit length in the same direction; zero stays zero.
inline Point3 Unit(const Point3& a)
{
  const double length = Length(a);
  return length > 0.0 ? (1.0 / length) * a : Point3{ 0.0, 0.0, 0.0 };
}

/// A right-handed frame of unit vectors, with the given one as the third.
inline std::array<Point3, 3> CompleteFrame(const Point3& third)
{
  // Off the axis to which the vector is closest: far from parallel to it.
  const double x = std::abs(third[0]), y = std::abs(third[1]), z = std::abs(third[2]);
  Point3 other{ 0.0, 0.0, 0.0 };
  other[x <= y ? (x <= z ? 0 : 2) : (y <= z ? 1 : 2)] = 1.0;
  const Point3 first = Unit(Cross(other, third));
  return { first, Cross(third, first), third };
}

/// The centre of curves whose parts weigh as much as they are long.
class CurveCenter
{
public:
  /// Sums are taken from the origin: a point near by keeps the digits of coordinates far from zero.
  explicit CurveCenter(const Point3& origin)
    : Origin(origin)
  {
  }

  /// Adds the segment from p to q. Returns its length.
  double Add(const Point3& p, const Point3& q)
  {
    const double length = Length(q - p);
    this->Sum = this->Sum + (0.5 * length) * ((p - this->Origin) + (q - this->Origin));
    this->Total += length;
    return length;
  }
  double TotalLength() const { return this->Total; }
  /// The origin if there is no length.
  Point3 Get() const
  {
    return this->Total > 0.0 ? this->Origin + (1.0 / this->Total) * this->Sum : this->Origin;
  }

private:
  Point3 Origin;
  Point3 Sum{ 0.0, 0.0, 0.0 };
  double Total = 0.0;
};

/// The centre of a closed curve, and for each of its points the share of the curve's length that is
/// nearest to it.
inline Point3 WeighByLength(const std::vector<Point3>& points, std::vector<double>& weights)
{
  const std::size_t n = points.size();
  weights.assign(n, 0.0);
  CurveCenter center(points[0]);
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    const double half = 0.5 * center.Add(points[i], points[j]);
    weights[i] += half;
    weights[j] += half;
  }
  for (double& weight : weights)
  {
    weight /= center.TotalLength() > 0.0 ? center.TotalLength() : 1.0;
  }
  return center.Get();
}
}

#endif
