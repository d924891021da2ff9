// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/DiscTriangulation.h"

#include "Core/Base/Vectors.h"
#include "Core/Planar/SimplePolygon.h"
#include "Core/Planar/TriangulatePolygon.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Triangles whose circumradius is more than so many times their shortest side are badly shaped:
/// 1 / (2 sin 24 degrees), an angle below 24 degrees. Refinement is proven to come to an end up to
/// 20.7 degrees (Ruppert), and comes to one well beyond in practice.
constexpr double Quality = 1.23;

/// Square of the largest circumradius, in those of the size asked for: between 1/3, an equilateral
/// triangle with sides of that size, and 1/2, a right-angled one with legs of that size.
constexpr double MaxSquaredRadius = 0.45;

/// The farthest that a new point is from a bad triangle's shortest side, in lengths of that: the
/// angle at the new point is then 39 degrees, so that one more bad triangle does not follow.
constexpr double MaxHeight = 1.4;

/// Share of the way to the centre of the triangle by which new points are moved. The circumcentre
/// of a right-angled triangle lies on its long side, where it would be in no triangle.
constexpr double Inwards = 1e-3;

/// Cosine of the angle, 120 degrees, from which on a side of the border that is seen from a new
/// point is too near. Ruppert's 90 degrees go with sides that may be split; these may not.
constexpr double EncroachingCosine = -0.5;

/// Sides whose opposite angles together exceed 180 degrees by no more than rounding may tell stay:
/// the sine of the sum against the sum of its two terms' sizes. Coordinates are differences of ones
/// far from zero, so that this is much more than the unit roundoff.
constexpr double CocircularTolerance = 1e-9;

/// Most flips in a row, for each triangle and in any case. Flips come to an end; these bounds are
/// for rounding that would let sides turn round and round.
constexpr std::size_t MaxFlipsPerTriangle = 16, MinFlips = 64;
}

bool DiscTriangulation::StartWithFan(const std::vector<Point2>& border, const Point2& center)
{
  const Index n = static_cast<Index>(border.size());
  this->Points.assign(border.begin(), border.end());
  this->Points.push_back(center);
  this->Triangles.resize(n);
  // All triangles turn left, and the border runs once around the center.
  int turns = 0;
  for (Index i = 0; i < n; ++i)
  {
    const Index j = i + 1 < n ? i + 1 : 0;
    if (SideOf(center, border[i], border[j]) <= 0)
    {
      return false;
    }
    turns += border[i][1] < center[1] && border[j][1] >= center[1] ? 1 : 0;
    this->Triangles[i] = { { i, j, n }, { -1, j, i > 0 ? i - 1 : n - 1 } };
  }
  return turns == 1;
}

bool DiscTriangulation::StartWithEars(const std::vector<Point2>& border)
{
  if (!IsSimple(border) || !(SignedArea(border) > 0.0))
  {
    return false;
  }
  this->Points.assign(border.begin(), border.end());
  this->Triangles.clear();
  std::vector<std::array<Index, 4>> sides; // its ends ascending, triangle, side
  for (const std::array<Index, 3>& corners : TriangulatePolygon(border))
  {
    if (SideOf(border[corners[0]], border[corners[1]], border[corners[2]]) <= 0)
    {
      return false;
    }
    const Index t = static_cast<Index>(this->Triangles.size());
    for (int i = 0; i < 3; ++i)
    {
      const auto ends = std::minmax(corners[i], corners[(i + 1) % 3]);
      sides.push_back({ ends.first, ends.second, t, i });
    }
    this->Triangles.push_back({ corners, { -1, -1, -1 } });
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 1; i < sides.size(); ++i)
  {
    const auto &a = sides[i - 1], &b = sides[i];
    if (a[0] == b[0] && a[1] == b[1])
    {
      this->Triangles[a[2]].Neighbors[a[3]] = b[2];
      this->Triangles[b[2]].Neighbors[b[3]] = a[2];
    }
  }
  return true;
}

/// Whether the point across a side lies outside the circumcircle, or the side cannot be flipped.
bool DiscTriangulation::IsDelaunay(const TriangleSide& side) const
{
  if (this->Triangles.NeighborOf(side) < 0)
  {
    return true;
  }
  const Point2& a = this->Points[this->Triangles.StartOf(side)];
  const Point2& b = this->Points[this->Triangles.EndOf(side)];
  const Point2& c = this->Points[this->Triangles.ApexOf(side)];
  const Point2& d = this->Points[this->Triangles.ApexOf(this->Triangles.BackOf(side))];
  // Angles at c and d opposite to the side ab: their sum is at most 180 degrees.
  const double cax = a[0] - c[0], cay = a[1] - c[1], cbx = b[0] - c[0], cby = b[1] - c[1];
  const double dax = a[0] - d[0], day = a[1] - d[1], dbx = b[0] - d[0], dby = b[1] - d[1];
  const double cosC = cax * cbx + cay * cby, sinC = cax * cby - cay * cbx;
  const double cosD = dbx * dax + dby * day, sinD = dbx * day - dby * dax;
  const double left = sinC * cosD, right = cosC * sinD;
  if (left + right >= -CocircularTolerance * (std::abs(left) + std::abs(right)))
  {
    return true;
  }
  // The two new triangles.
  return SideOf(c, a, d) <= 0 || SideOf(d, b, c) <= 0;
}

/// Replaces the common side of two triangles by the other diagonal.
void DiscTriangulation::Flip(const TriangleSide& side)
{
  const Index t = side.Triangle;
  const Index u = this->Triangles.NeighborOf(side);
  this->Triangles.Flip(side);
  // In the order c, a, d: the first corner is the origin from which new points are computed.
  LinkedTriangle& one = this->Triangles[t];
  one = { { one.Corners[2], one.Corners[0], one.Corners[1] },
    { one.Neighbors[2], one.Neighbors[0], one.Neighbors[1] } };
  this->Doubtful.insert(this->Doubtful.end(), { { t, 0 }, { t, 1 }, { u, 0 }, { u, 1 } });
  this->Queue.push_back(t);
  this->Queue.push_back(u);
}

void DiscTriangulation::Legalize()
{
  std::size_t guard = MinFlips + MaxFlipsPerTriangle * this->Triangles.size();
  while (!this->Doubtful.empty() && guard-- > 0)
  {
    const TriangleSide side = this->Doubtful.back();
    this->Doubtful.pop_back();
    if (!this->IsDelaunay(side))
    {
      this->Flip(side);
    }
  }
  this->Doubtful.clear();
}

void DiscTriangulation::MakeDelaunay()
{
  this->Queue.clear();
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int side = 0; side < 3; ++side)
    {
      this->Doubtful.push_back({ static_cast<Index>(t), side });
    }
  }
  this->Legalize();
}

/// The triangle with a point strictly inside, or -1.
Index DiscTriangulation::Locate(Index from, const Point2& p) const
{
  Index t = from;
  for (std::size_t steps = 0; steps <= this->Triangles.size(); ++steps)
  {
    const LinkedTriangle& triangle = this->Triangles[t];
    Index next = -2;
    for (int i = 0; i < 3 && next == -2; ++i)
    {
      const int side =
        SideOf(this->Points[triangle.Corners[i]], this->Points[triangle.Corners[(i + 1) % 3]], p);
      next = side < 0 ? triangle.Neighbors[i] : side == 0 ? -1 : -2;
    }
    if (next < 0)
    {
      return next == -2 ? t : -1;
    }
    t = next;
  }
  return -1;
}

/// Whether a point inside a triangle sees a side of the border near by at more than 120 degrees.
bool DiscTriangulation::Encroaches(Index t, const Point2& p) const
{
  const auto tooNear = [&](const LinkedTriangle& triangle)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (triangle.Neighbors[i] >= 0)
      {
        continue;
      }
      const Point2& a = this->Points[triangle.Corners[i]];
      const Point2& b = this->Points[triangle.Corners[(i + 1) % 3]];
      const double dot = Dot(a - p, b - p);
      if (dot < EncroachingCosine * std::sqrt(SquaredDistance(a, p) * SquaredDistance(b, p)))
      {
        return true;
      }
    }
    return false;
  };
  const LinkedTriangle& triangle = this->Triangles[t];
  if (tooNear(triangle))
  {
    return true;
  }
  return std::any_of(triangle.Neighbors.begin(), triangle.Neighbors.end(),
    [&](Index n) { return n >= 0 && tooNear(this->Triangles[n]); });
}

void DiscTriangulation::Insert(Index t, const Point2& p)
{
  const Index u = static_cast<Index>(this->Triangles.size());
  this->Triangles.Divide(t, static_cast<Index>(this->Points.size()));
  this->Points.push_back(p);
  this->Doubtful.insert(this->Doubtful.end(), { { t, 0 }, { u, 0 }, { u + 1, 0 } });
  this->Queue.insert(this->Queue.end(), { t, u, u + 1 });
  this->Legalize();
}

/// Where a point would mend a triangle; false if it needs none.
bool DiscTriangulation::FindNewPoint(
  const LinkedTriangle& t, double size, double minimum, Point2& p) const
{
  const Point2 &a = this->Points[t.Corners[0]], &b = this->Points[t.Corners[1]],
               &c = this->Points[t.Corners[2]];
  const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
  const double bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  const double ab = bb, ca = cc, bc = SquaredDistance(b, c);
  const double twice = 2.0 * (bx * cy - by * cx);
  const double ux = (cy * bb - by * cc) / twice, uy = (bx * cc - cx * bb) / twice;
  const double radius2 = ux * ux + uy * uy;
  const double side = std::min({ ab, bc, ca });
  const double shortest = std::max(side, minimum * minimum);
  if (!(radius2 > Quality * Quality * shortest || radius2 > MaxSquaredRadius * size * size))
  {
    return false;
  }
  p = { a[0] + ux, a[1] + uy };
  // Not farther from the shortest side than a good triangle over it is high.
  const Point2& from = side == ab ? a : side == bc ? b : c;
  const Point2& to = side == ab ? b : side == bc ? c : a;
  const Point2 middle{ 0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]) };
  const double away = std::sqrt(SquaredDistance(middle, p));
  const double maximum = MaxHeight * std::sqrt(shortest);
  if (away > maximum && radius2 > Quality * Quality * shortest)
  {
    const double share = maximum / away;
    p = Between(middle, p, share);
  }
  p[0] += Inwards * ((a[0] + b[0] + c[0]) / 3.0 - p[0]);
  p[1] += Inwards * ((a[1] + b[1] + c[1]) / 3.0 - p[1]);
  return std::isfinite(p[0]) && std::isfinite(p[1]);
}

void DiscTriangulation::Refine(double size, std::size_t maxPoints, double minimum)
{
  this->Queue.resize(this->Triangles.size());
  for (std::size_t t = 0; t < this->Queue.size(); ++t)
  {
    this->Queue[t] = static_cast<Index>(t);
  }
  Point2 p;
  for (std::size_t next = 0; next < this->Queue.size() && this->Points.size() < maxPoints; ++next)
  {
    const Index t = this->Queue[next];
    if (!this->FindNewPoint(this->Triangles[t], size, minimum, p))
    {
      continue;
    }
    const Index at = this->Locate(t, p);
    if (at >= 0 && !this->Encroaches(at, p))
    {
      this->Insert(at, p);
    }
  }
}

/// Adds a point in the middle of a side inside the disc.
void DiscTriangulation::Split(const TriangleSide& side)
{
  const Point2& a = this->Points[this->Triangles.StartOf(side)];
  const Point2& b = this->Points[this->Triangles.EndOf(side)];
  const Point2 middle{ 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) };
  this->Triangles.Split(side, static_cast<Index>(this->Points.size()));
  this->Points.push_back(middle);
}
}
