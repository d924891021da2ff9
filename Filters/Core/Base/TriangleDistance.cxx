// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/TriangleDistance.h"

#include "Core/Base/Vectors.h"

#include <algorithm>

namespace orthoslices
{
double DistanceToSegment(const Point2& p, const Point2& a, const Point2& b)
{
  const Point2 ab = b - a;
  const double square = Dot(ab, ab);
  const double share = square > 0.0 ? std::clamp(Dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
  return Length((p - a) - share * ab);
}

double SquaredDistanceToSegment(const Point3& p, const Point3& a, const Point3& b)
{
  const Point3 ab = b - a;
  const double square = Dot(ab, ab);
  const double share = square > 0.0 ? std::clamp(Dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
  return SquaredDistance(p, Between(a, b, share));
}

double SquaredDistanceToTriangle(const Point3& p, const Point3& a, const Point3& b, const Point3& c)
{
  const Point3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = Dot(ab, ap), d2 = Dot(ac, ap);
  Point3 nearest = a;
  const Point3 bp = p - b;
  const double d3 = Dot(ab, bp), d4 = Dot(ac, bp);
  const Point3 cp = p - c;
  const double d5 = Dot(ab, cp), d6 = Dot(ac, cp);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    nearest = a;
  }
  else if (d3 >= 0.0 && d4 <= d3)
  {
    nearest = b;
  }
  else if (d6 >= 0.0 && d5 <= d6)
  {
    nearest = c;
  }
  else if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    nearest = a + (d1 / (d1 - d3)) * ab;
  }
  else if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    nearest = a + (d2 / (d2 - d6)) * ac;
  }
  else if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    nearest = b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  }
  else if (va + vb + vc > 0.0)
  {
    const double scale = 1.0 / (va + vb + vc);
    nearest = a + (vb * scale) * ab + (vc * scale) * ac;
  }
  return SquaredDistance(nearest, p);
}
}
