// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/LoopOracle.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace orthoslices
{
namespace support
{
namespace
{
void VisitSides(const std::vector<Polygon>& polygons,
  const std::function<void(const Point2&, const Point2&)>& visit)
{
  for (const Polygon& polygon : polygons)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      visit(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
  }
}

bool IsInBox(const Point2& x, const Point2& p, const Point2& q)
{
  return std::min(p[0], q[0]) <= x[0] && x[0] <= std::max(p[0], q[0]) &&
    std::min(p[1], q[1]) <= x[1] && x[1] <= std::max(p[1], q[1]);
}

double DistanceTo(const Point2& x, const Point2& p, const Point2& q)
{
  const double share = Dot(x - p, q - p) / std::max(SquaredDistance(p, q), 1e-300);
  return Distance(x, Between(p, q, std::max(0.0, std::min(1.0, share))));
}

/// For each point, whether the polygon runs around it.
std::vector<bool> SurroundedPoints(const Polygon& polygon, const std::vector<FacePoint>& points)
{
  std::vector<bool> surrounded;
  for (const FacePoint& point : points)
  {
    surrounded.push_back(WindingNumber(polygon, point.Place) != 0);
  }
  return surrounded;
}

using Set = std::vector<bool>;

bool IsMostlyWithin(const Set& inner, const Set& outer, const std::vector<FacePoint>& points)
{
  double all = 0.0, within = 0.0;
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    all += inner[i] ? points[i].Area : 0.0;
    within += inner[i] && outer[i] ? points[i].Area : 0.0;
  }
  return within >= 0.98 * all;
}

bool IsWithin(const Set& inner, const Set& outer, const std::vector<FacePoint>& points)
{
  return IsMostlyWithin(inner, outer, points) && !IsMostlyWithin(outer, inner, points);
}

Set FindUnion(const std::vector<Set>& sets, const std::vector<FacePoint>& points)
{
  std::vector<int> level(sets.size(), 0);
  for (std::size_t round = 0; round < sets.size(); ++round)
  {
    for (std::size_t i = 0; i < sets.size(); ++i)
    {
      for (std::size_t j = 0; j < sets.size(); ++j)
      {
        if (i != j && IsWithin(sets[i], sets[j], points))
        {
          level[i] = std::max(level[i], level[j] + 1);
        }
      }
    }
  }
  Set inside(points.size(), false);
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    for (std::size_t k = 0; k < points.size() && level[i] % 2 == 0; ++k)
    {
      bool isIn = sets[i][k];
      for (std::size_t j = 0; j < sets.size(); ++j)
      {
        isIn = isIn && !(level[j] % 2 == 1 && sets[j][k] && IsWithin(sets[j], sets[i], points));
      }
      inside[k] = inside[k] || isIn;
    }
  }
  return inside;
}
}

int WindingNumber(const Polygon& polygon, const Point2& point)
{
  int winding = 0;
  VisitSides({ polygon },
    [&](const Point2& p, const Point2& q)
    {
      const int side = SideOf(p, q, point);
      winding += p[1] <= point[1] && q[1] > point[1] && side > 0 ? 1 : 0;
      winding -= q[1] <= point[1] && p[1] > point[1] && side < 0 ? 1 : 0;
    });
  return winding;
}

bool DoSegmentsMeet(const Point2& p, const Point2& q, const Point2& r, const Point2& s)
{
  const int a = SideOf(p, q, r), b = SideOf(p, q, s), c = SideOf(r, s, p), d = SideOf(r, s, q);
  return (a * b < 0 && c * d < 0) || (a == 0 && IsInBox(r, p, q)) || (b == 0 && IsInBox(s, p, q)) ||
    (c == 0 && IsInBox(p, r, s)) || (d == 0 && IsInBox(q, r, s));
}

bool AreDisjointAndSimple(const std::vector<Polygon>& polygons)
{
  for (std::size_t a = 0; a < polygons.size(); ++a)
  {
    for (std::size_t b = 0; b <= a; ++b)
    {
      for (std::size_t i = 0; i < polygons[a].size(); ++i)
      {
        for (std::size_t j = 0; j < (a == b ? i : polygons[b].size()); ++j)
        {
          const std::size_t afterI = (i + 1) % polygons[a].size();
          const std::size_t afterJ = (j + 1) % polygons[b].size();
          const Point2 &p = polygons[a][i], &q = polygons[a][afterI];
          const Point2 &r = polygons[b][j], &s = polygons[b][afterJ];
          const bool isNext = a == b && (afterI == j || afterJ == i);
          if (isNext)
          {
            const Point2& common = afterI == j ? q : p;
            const Point2& one = afterI == j ? p : q;
            const Point2& other = afterI == j ? s : r;
            if (SideOf(one, common, other) == 0 && Dot(one - common, other - common) >= 0.0)
            {
              return false;
            }
          }
          else if (DoSegmentsMeet(p, q, r, s))
          {
            return false;
          }
        }
      }
    }
  }
  return true;
}

std::vector<FacePoint> PointsInAllFaces(const std::vector<Polygon>& polygons, double least)
{
  std::vector<double> us;
  VisitSides(polygons,
    [&](const Point2& p, const Point2& q)
    {
      us.push_back(p[0]);
      VisitSides(polygons,
        [&](const Point2& r, const Point2& s)
        {
          const double from = Cross(s - r, p - r), to = Cross(s - r, q - r);
          if ((from < 0.0) != (to < 0.0) && from != to)
          {
            us.push_back(p[0] + from / (from - to) * (q[0] - p[0]));
          }
        });
    });
  std::sort(us.begin(), us.end());
  std::vector<FacePoint> points;
  for (std::size_t i = 0; i + 1 < us.size(); ++i)
  {
    const double u = 0.5 * (us[i] + us[i + 1]);
    std::vector<double> vs;
    VisitSides(polygons,
      [&](const Point2& p, const Point2& q)
      {
        if ((p[0] < u) != (q[0] < u))
        {
          vs.push_back(p[1] + (u - p[0]) / (q[0] - p[0]) * (q[1] - p[1]));
        }
      });
    std::sort(vs.begin(), vs.end());
    for (std::size_t k = 0; k + 1 < vs.size() && us[i + 1] - us[i] > least; ++k)
    {
      const Point2 point{ u, 0.5 * (vs[k] + vs[k + 1]) };
      bool isClear = true;
      VisitSides(polygons,
        [&](const Point2& p, const Point2& q)
        { isClear = isClear && DistanceTo(point, p, q) > least; });
      if (isClear)
      {
        points.push_back({ point, (vs[k + 1] - vs[k]) * (us[i + 1] - us[i]) });
      }
    }
  }
  return points;
}

double CommonLength(const Polygon& a, const Polygon& b, bool isSame)
{
  double length = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const Point2 &p = a[i], &q = a[(i + 1) % a.size()], &r = b[j], &s = b[(j + 1) % b.size()];
      if ((isSame && i == j) || SideOf(p, q, r) != 0 || SideOf(p, q, s) != 0)
      {
        continue;
      }
      const Point2 along = (1.0 / Distance(p, q)) * (q - p);
      const double from = Dot(r - p, along), to = Dot(s - p, along);
      length += std::max(
        0.0, std::min(Distance(p, q), std::max(from, to)) - std::max(0.0, std::min(from, to)));
    }
  }
  return length;
}

std::vector<bool> FindInsidePoints(
  LoopRule rule, const std::vector<Polygon>& polygons, const std::vector<FacePoint>& points)
{
  if (rule == LoopRule::Union)
  {
    std::vector<std::vector<bool>> sets;
    for (const Polygon& polygon : polygons)
    {
      sets.push_back(SurroundedPoints(polygon, points));
    }
    return FindUnion(sets, points);
  }
  std::vector<bool> inside;
  for (const FacePoint& point : points)
  {
    int winding = 0;
    for (const Polygon& polygon : polygons)
    {
      winding += WindingNumber(polygon, point.Place);
    }
    inside.push_back(rule == LoopRule::EvenOdd ? winding % 2 != 0 : winding != 0);
  }
  return inside;
}

} // namespace support
} // namespace orthoslices
