// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/SimplePolygon.h"

#include "Core/Base/Contours.h"
#include "Core/Base/Predicates.h"
#include "Core/Planar/SegmentTree.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// For polygons with more segments a tree finds those that meet: pairs would be too many. For fewer
/// it would cost more than it saves.
constexpr std::size_t ManySegments = 100;

/// Whether two segments on one line have a point in common.
bool Overlap(const Point2& p, const Point2& q, const Point2& r, const Point2& s)
{
  for (int k = 0; k < 2; ++k)
  {
    if (std::max(p[k], q[k]) < std::min(r[k], s[k]) || std::max(r[k], s[k]) < std::min(p[k], q[k]))
    {
      return false;
    }
  }
  return true;
}
/// Whether segments pq and rs, which have no end in common, have a point in common.
bool DoMeet(const Point2& p, const Point2& q, const Point2& r, const Point2& s)
{
  const int sideOfR = SideOf(p, q, r), sideOfS = SideOf(p, q, s);
  if (sideOfR * sideOfS > 0)
  {
    return false;
  }
  const int sideOfP = SideOf(r, s, p), sideOfQ = SideOf(r, s, q);
  const bool onOneLine = sideOfR == 0 && sideOfS == 0 && sideOfP == 0 && sideOfQ == 0;
  return sideOfP * sideOfQ <= 0 && (!onOneLine || Overlap(p, q, r, s));
}

/// The same as IsSimple, by a tree.
bool IsSimpleByTree(const std::vector<Point2>& polygon)
{
  Contours contours;
  for (const Point2& p : polygon)
  {
    contours.U.push_back(p[0]);
    contours.V.push_back(p[1]);
  }
  contours.Offsets.push_back(static_cast<Index>(polygon.size()));
  contours.Axis.push_back(2);
  contours.Coordinate.push_back(0.0);
  const auto next = [&](Index i) { return polygon[i + 1 < contours.Offsets[1] ? i + 1 : 0]; };
  bool isSimple = true;
  SegmentTree(contours, { 0 })
    .VisitOverlaps(
      [&](SegmentTree::Segment s, SegmentTree::Segment t)
      {
        isSimple =
          isSimple && !DoMeet(polygon[s.Vertex], next(s.Vertex), polygon[t.Vertex], next(t.Vertex));
      });
  return isSimple;
}
}

bool IsSimple(const std::vector<Point2>& polygon)
{
  const std::size_t n = polygon.size();
  if (n == 3 && SideOf(polygon[0], polygon[1], polygon[2]) == 0)
  {
    return false;
  }
  if (n > ManySegments)
  {
    return IsSimpleByTree(polygon);
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point2 &p = polygon[i], &q = polygon[i + 1 < n ? i + 1 : 0];
    for (std::size_t j = i + 2; j < n && (i > 0 || j + 1 < n); ++j)
    {
      if (DoMeet(p, q, polygon[j], polygon[j + 1 < n ? j + 1 : 0]))
      {
        return false;
      }
    }
  }
  return true;
}
}
