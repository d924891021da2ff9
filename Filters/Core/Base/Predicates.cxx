// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Predicates.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Adds a number to a sum of numbers that do not overlap, without rounding (Shewchuk's expansion).
void AddExactly(double x, std::array<double, 12>& sum, int& count)
{
  int kept = 0;
  for (int i = 0; i < count; ++i)
  {
    const double total = x + sum[i];
    const double part = total - x;
    const double error = (x - (total - part)) + (sum[i] - part);
    if (error != 0.0)
    {
      sum[kept++] = error;
    }
    x = total;
  }
  if (x != 0.0) // the last number of the sum tells its sign
  {
    sum[kept++] = x;
  }
  count = kept;
}
}

int ExactSideOf(const Point2& p, const Point2& q, const Point2& r)
{
  if ((p[0] == r[0] && q[0] == r[0]) || (p[1] == r[1] && q[1] == r[1]))
  {
    return 0; // on a line along an axis, as points on a plane of M are in a projection
  }
  // The determinant multiplied out, so that no difference is rounded.
  const double factors[6][2] = { { p[0], q[1] }, { -p[0], r[1] }, { -r[0], q[1] }, { -p[1], q[0] },
    { p[1], r[0] }, { r[1], q[0] } };
  std::array<double, 12> sum{};
  int count = 0;
  for (const auto& factor : factors)
  {
    const double product = factor[0] * factor[1];
    AddExactly(std::fma(factor[0], factor[1], -product), sum, count);
    AddExactly(product, sum, count);
  }
  const double largest = count > 0 ? sum[count - 1] : 0.0;
  return largest > 0.0 ? 1 : largest < 0.0 ? -1 : 0;
}

bool AreOnOneRay(const Point2& p, const Point2& q, const Point2& r)
{
  return SideOf(p, q, r) == 0 &&
    ((q[0] > p[0] && r[0] > p[0]) || (q[0] < p[0] && r[0] < p[0]) || (q[1] > p[1] && r[1] > p[1]) ||
      (q[1] < p[1] && r[1] < p[1]));
}

int CertainSide(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  Point3 ad, bd, cd;
  for (int i = 0; i < 3; ++i)
  {
    ad[i] = a[i] - d[i];
    bd[i] = b[i] - d[i];
    cd[i] = c[i] - d[i];
  }
  const double p1 = bd[0] * cd[1], p2 = cd[0] * bd[1];
  const double p3 = cd[0] * ad[1], p4 = ad[0] * cd[1];
  const double p5 = ad[0] * bd[1], p6 = bd[0] * ad[1];
  const double det = ad[2] * (p1 - p2) + bd[2] * (p3 - p4) + cd[2] * (p5 - p6);
  const double permanent = std::abs(ad[2]) * (std::abs(p1) + std::abs(p2)) +
    std::abs(bd[2]) * (std::abs(p3) + std::abs(p4)) +
    std::abs(cd[2]) * (std::abs(p5) + std::abs(p6));
  // Shewchuk's o3derrboundA = (7 + 56 e) e with e = 2^-53.
  constexpr double errorBound = 7.7715611723761027e-16;
  const double bound = errorBound * permanent;
  // The determinant is positive when a, b, c run clockwise seen from d.
  return det > bound ? -1 : det < -bound ? 1 : 0;
}

namespace
{
template <std::size_t N>
std::array<Point2, N> Project(const std::array<Point3, N>& points, int axis)
{
  std::array<Point2, N> projected;
  for (std::size_t i = 0; i < N; ++i)
  {
    projected[i] = { points[i][FirstAxis(axis)], points[i][SecondAxis(axis)] };
  }
  return projected;
}

/// Whether the line of an edge of s strictly separates t from s, both in the plane. Exact.
template <std::size_t N, std::size_t M>
bool SeparatedByEdge(const std::array<Point2, N>& s, const std::array<Point2, M>& t)
{
  for (std::size_t i = 0; i < N; ++i)
  {
    const Point2& p = s[i];
    const Point2& q = s[(i + 1) % N];
    const int side = SideOf(p, q, t[0]);
    const bool away = side != 0 &&
      std::all_of(t.begin(), t.end(), [&](const Point2& r) { return SideOf(p, q, r) == side; }) &&
      std::none_of(s.begin(), s.end(), [&](const Point2& r) { return SideOf(p, q, r) == side; });
    if (away)
    {
      return true;
    }
  }
  return false;
}

/// What is apart in a projection is apart. Decides what lies in one plane, too.
template <std::size_t N, std::size_t M>
bool ProjectionsApart(const std::array<Point3, N>& s, const std::array<Point3, M>& t)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = Project(s, axis);
    const auto b = Project(t, axis);
    if (SeparatedByEdge(a, b) || SeparatedByEdge(b, a))
    {
      return true;
    }
  }
  return false;
}

/// Whether segment pq certainly does not meet triangle t.
bool CertainlyMisses(const Point3& p, const Point3& q, const std::array<Point3, 3>& t)
{
  if (CertainSide(t[0], t[1], t[2], p) * CertainSide(t[0], t[1], t[2], q) > 0)
  {
    return true;
  }
  // The line through p and q passes all edges of a triangle that it meets on the same side.
  int left = 0, right = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int side = CertainSide(p, q, t[i], t[(i + 1) % 3]);
    left += side > 0;
    right += side < 0;
  }
  return (left > 0 && right > 0) || ProjectionsApart(std::array<Point3, 2>{ p, q }, t);
}

/// Whether t lies on one side of the plane of s.
bool PlaneSeparates(const std::array<Point3, 3>& s, const std::array<Point3, 3>& t)
{
  const int side = CertainSide(s[0], s[1], s[2], t[0]);
  return side != 0 && side == CertainSide(s[0], s[1], s[2], t[1]) &&
    side == CertainSide(s[0], s[1], s[2], t[2]);
}
}

bool CertainlyApart(const std::array<Point3, 3>& s, const std::array<Point3, 3>& t)
{
  // The cheapest tests first; projections of points on faces of a cell need exact arithmetic.
  if (PlaneSeparates(s, t) || PlaneSeparates(t, s) || ProjectionsApart(s, t))
  {
    return true;
  }
  // Triangles that meet have an edge of one that meets the other.
  for (int i = 0; i < 3; ++i)
  {
    if (!CertainlyMisses(s[i], s[(i + 1) % 3], t) || !CertainlyMisses(t[i], t[(i + 1) % 3], s))
    {
      return false;
    }
  }
  return true;
}

bool HasNoArea(const std::array<Point3, 3>& triangle)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto p = Project(triangle, axis);
    if (SideOf(p[0], p[1], p[2]) != 0)
    {
      return false;
    }
  }
  return true;
}

namespace
{
/// Whether triangles with a common edge certainly do not lie on each other.
bool CertainlyUnfolded(const Point3& p, const Point3& q, const Point3& s, const Point3& t)
{
  if (CertainSide(p, q, s, t) != 0)
  {
    return true;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto x = Project(std::array<Point3, 4>{ p, q, s, t }, axis);
    if (SideOf(x[0], x[1], x[2]) * SideOf(x[0], x[1], x[3]) < 0)
    {
      return true;
    }
  }
  return false;
}
}

bool CertainlyApartBeyond(const std::vector<int>& common, const std::array<Point3, 3>& s,
  const std::vector<int>& commonOfOther, const std::array<Point3, 3>& t)
{
  if (common.size() == 1)
  {
    // Triangles that meet beyond a common corner have an opposite edge that meets the other.
    const int i = common[0];
    const int j = commonOfOther[0];
    return CertainlyMisses(s[(i + 1) % 3], s[(i + 2) % 3], t) &&
      CertainlyMisses(t[(j + 1) % 3], t[(j + 2) % 3], s);
  }
  if (common.size() == 2)
  {
    return CertainlyUnfolded(s[common[0]], s[common[1]], s[3 - common[0] - common[1]],
      t[3 - commonOfOther[0] - commonOfOther[1]]);
  }
  return false;
}

void CommonCorners::Find(const std::array<Index, 3>& first, const std::array<Index, 3>& second)
{
  this->OfFirst.clear();
  this->OfSecond.clear();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (first[i] == second[j])
      {
        this->OfFirst.push_back(i);
        this->OfSecond.push_back(j);
      }
    }
  }
}

bool CertainlyApartBeyond(
  const CommonCorners& common, const std::array<Point3, 3>& s, const std::array<Point3, 3>& t)
{
  return common.OfFirst.empty() ? CertainlyApart(s, t)
                                : CertainlyApartBeyond(common.OfFirst, s, common.OfSecond, t);
}

double SignedArea(const std::vector<Point2>& polygon)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& o = polygon.front();
    const Point2& p = polygon[i];
    const Point2& q = polygon[(i + 1) % polygon.size()];
    sum += (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
  }
  return 0.5 * sum;
}

bool IsInside(const std::vector<Point2>& polygon, const Point2& point)
{
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& p = polygon[i];
    const Point2& q = polygon[(i + 1) % polygon.size()];
    if ((p[1] > point[1]) != (q[1] > point[1]))
    {
      inside ^= (SideOf(p, q, point) > 0) == (q[1] > p[1]);
    }
  }
  return inside;
}
}
