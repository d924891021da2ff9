// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/TriangulatePolygon.h"

#include "Core/Base/Vectors.h"
#include "Core/Planar/CutEars.h"

#include <algorithm>
#include <numeric>

namespace orthoslices
{
namespace
{
std::vector<Point2> PointsOf(const std::vector<Point2>& points, const std::vector<Index>& ring)
{
  std::vector<Point2> polygon;
  for (const Index i : ring)
  {
    polygon.push_back(points[i]);
  }
  return polygon;
}

/// A part of the plane: the ring around it and the holes in it.
class Part
{
public:
  Part(const std::vector<Point2>& points, const std::vector<Index>& ring)
    : Points(points)
    , Ring(ring)
  {
  }

  std::vector<std::vector<Index>> Holes;
  std::vector<Index> JoinHoles();

private:
  bool IsFree(Index from, Index to, const std::vector<Index>& ring) const;
  bool IsBetween(std::size_t place, Index hole) const;
  bool FindBridge(Index from, std::size_t firstHole, std::size_t& place) const;

  const std::vector<Point2>& Points;
  std::vector<Index> Ring;
};

/// Whether the segment between two points touches the ring at most in them.
bool Part::IsFree(Index from, Index to, const std::vector<Index>& ring) const
{
  const Point2& p = this->Points[from];
  const Point2& q = this->Points[to];
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Index a = ring[i];
    const Index b = ring[(i + 1) % ring.size()];
    const bool touchesHere = a == from || a == to || b == from || b == to;
    const Point2& r = this->Points[a];
    const Point2& s = this->Points[b];
    if (!touchesHere && SideOf(p, q, r) * SideOf(p, q, s) <= 0 &&
      SideOf(r, s, p) * SideOf(r, s, q) <= 0)
    {
      return false;
    }
  }
  return true;
}

/// Whether one looks into the part from a place on the ring to a point.
bool Part::IsBetween(std::size_t place, Index hole) const
{
  const std::size_t n = this->Ring.size();
  const Point2& before = this->Points[this->Ring[(place + n - 1) % n]];
  const Point2& here = this->Points[this->Ring[place]];
  const Point2& after = this->Points[this->Ring[(place + 1) % n]];
  const Point2& there = this->Points[hole];
  const bool leftOfFirst = SideOf(before, here, there) > 0;
  const bool leftOfSecond = SideOf(here, after, there) > 0;
  return SideOf(before, here, after) > 0 ? leftOfFirst && leftOfSecond
                                         : leftOfFirst || leftOfSecond;
}

/// The nearest place on the ring that can be seen from a point of a hole.
bool Part::FindBridge(Index from, std::size_t firstHole, std::size_t& place) const
{
  std::vector<std::size_t> places(this->Ring.size());
  std::iota(places.begin(), places.end(), 0);
  const auto distance2 = [&](std::size_t i)
  { return SquaredDistance(this->Points[from], this->Points[this->Ring[i]]); };
  std::stable_sort(places.begin(), places.end(),
    [&](std::size_t a, std::size_t b) { return distance2(a) < distance2(b); });
  for (const std::size_t candidate : places)
  {
    const Index to = this->Ring[candidate];
    bool free = this->IsBetween(candidate, from) && this->IsFree(from, to, this->Ring);
    for (std::size_t h = firstHole; h < this->Holes.size() && free; ++h)
    {
      free = this->IsFree(from, to, this->Holes[h]);
    }
    if (free)
    {
      place = candidate;
      return true;
    }
  }
  return false;
}

/// One ring of all of them. Empty if the rings touch each other.
std::vector<Index> Part::JoinHoles()
{
  const auto isLess = [&](Index a, Index b) { return this->Points[a] < this->Points[b]; };
  for (std::vector<Index>& hole : this->Holes)
  {
    std::rotate(hole.begin(), std::max_element(hole.begin(), hole.end(), isLess), hole.end());
  }
  std::sort(this->Holes.begin(), this->Holes.end(),
    [&](const std::vector<Index>& a, const std::vector<Index>& b)
    { return isLess(b.front(), a.front()); });
  for (std::size_t h = 0; h < this->Holes.size(); ++h)
  {
    std::vector<Index> hole = this->Holes[h];
    std::size_t place = 0;
    if (!this->FindBridge(hole.front(), h, place))
    {
      return {};
    }
    hole.push_back(hole.front());
    hole.push_back(this->Ring[place]);
    this->Ring.insert(
      this->Ring.begin() + static_cast<std::ptrdiff_t>(place) + 1, hole.begin(), hole.end());
  }
  return this->Ring;
}
}

std::vector<std::array<Index, 3>> TriangulatePolygon(const std::vector<Point2>& polygon)
{
  std::vector<Index> ring(polygon.size());
  std::iota(ring.begin(), ring.end(), 0);
  std::vector<std::array<Index, 3>> triangles;
  CutEars(polygon, ring, triangles);
  return triangles;
}

std::vector<std::array<Index, 3>> TriangulateRings(
  const std::vector<Point2>& points, const std::vector<std::vector<Index>>& rings)
{
  std::vector<Part> parts;
  std::vector<double> areas;
  std::vector<std::vector<Point2>> polygons;
  for (const std::vector<Index>& ring : rings)
  {
    const std::vector<Point2> polygon = PointsOf(points, ring);
    const double area = SignedArea(polygon);
    if (area > 0.0)
    {
      parts.emplace_back(points, ring);
      areas.push_back(area);
      polygons.push_back(polygon);
    }
  }
  for (const std::vector<Index>& ring : rings)
  {
    if (SignedArea(PointsOf(points, ring)) > 0.0)
    {
      continue;
    }
    // The smallest part that it lies in.
    std::size_t best = parts.size();
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      if (IsInside(polygons[i], points[ring.front()]) &&
        (best == parts.size() || areas[i] < areas[best]))
      {
        best = i;
      }
    }
    if (best < parts.size())
    {
      parts[best].Holes.push_back(ring);
    }
  }
  std::vector<std::array<Index, 3>> triangles;
  for (Part& part : parts)
  {
    const std::vector<Index> ring = part.JoinHoles();
    if (ring.size() >= 3)
    {
      CutEars(points, ring, triangles);
    }
  }
  return triangles;
}
}
