// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JoinPatch.h"

#include "Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
/// Least distance of new points from the faces of their cell, as a part of the cell's width.
constexpr double InnerMargin = 1e-3;
/// Of a ring between points of one face, as a part of their distance and of the cell's width.
constexpr double HighestArch = 0.5;
/// Pairs of points up to which curves are compared point by point.
constexpr std::size_t MostPairs = std::size_t(1) << 24;

double SquaredDistance(const Point3& a, const Point3& b)
{
  const Point3 d = b - a;
  return Dot(d, d);
}

Point3 Between(const Point3& a, const Point3& b, double share) { return a + share * (b - a); }

/// A closed curve: corners as in PatchMesh, and where they are.
struct Curve
{
  std::vector<Index> Corners;
  std::vector<Point3> Points;

  Index Count() const { return static_cast<Index>(this->Corners.size()); }
};

/// A point of one curve and one of another.
struct PointPair
{
  Index First = 0, Second = 0;
  double Distance2 = std::numeric_limits<double>::infinity();
};

/// The nearest two points of two curves, among places on borders.
PointPair FindNearest(const Curve& a, const Curve& b)
{
  PointPair best;
  for (Index i = 0; i < a.Count(); ++i)
  {
    for (Index j = 0; j < b.Count() && a.Corners[i] >= 0; ++j)
    {
      const double distance2 = SquaredDistance(a.Points[i], b.Points[j]);
      if (b.Corners[j] >= 0 && distance2 < best.Distance2)
      {
        best = { i, j, distance2 };
      }
    }
  }
  return best;
}

class PatchJoiner
{
public:
  PatchJoiner(const CycleGeometry& geometry, const std::vector<Index>& cycles, double share)
    : Geometry(geometry)
    , Cell(geometry.Polygons.Cell[cycles.front()])
    , Share(share)
  {
    this->Mesh.Kind = PatchKind::Joined;
    this->Mesh.Cycles = cycles;
  }

  PatchMesh Run(const std::vector<std::pair<Index, Index>>& joins);

private:
  Index AddPoint(const Point3& point);
  std::vector<std::uint8_t> Colour(const std::vector<std::pair<Index, Index>>& joins) const;
  void Bridge(const Curve& other, const Curve& goal, Curve& curve);
  std::vector<PointPair> Pair(const Curve& a, const Curve& b) const;
  Point3 Arch(const Point3& from, const Point3& to, Point3 between) const;
  void Fill(const Curve& a, const Curve& b);
  void AddStrip(const Curve& curve, Index from, Index to, Index ringFrom, Index ringTo, bool flip);

  const CycleGeometry& Geometry;
  const std::array<Index, 3>& Cell;
  double Share;
  PatchMesh Mesh;
};

/// A new point strictly inside the cell.
Index PatchJoiner::AddPoint(const Point3& point)
{
  Point3 inside;
  for (int axis = 0; axis < 3; ++axis)
  {
    inside[axis] = this->Geometry.Grid.MoveInside(axis, this->Cell[axis], point[axis], InnerMargin);
  }
  this->Mesh.Points.push_back(inside);
  return -static_cast<Index>(this->Mesh.Points.size());
}

/// 0 for cycles at an even distance from the first one in the tree, 1 for the others.
std::vector<std::uint8_t> PatchJoiner::Colour(
  const std::vector<std::pair<Index, Index>>& joins) const
{
  constexpr std::uint8_t none = 2;
  const std::vector<Index>& cycles = this->Mesh.Cycles;
  std::vector<std::uint8_t> colours(cycles.size(), none);
  const auto colour = [&](Index cycle) -> std::uint8_t&
  { return colours[std::lower_bound(cycles.begin(), cycles.end(), cycle) - cycles.begin()]; };
  colours.front() = 0;
  for (std::size_t pass = 1; pass < cycles.size(); ++pass)
  {
    for (const auto& join : joins)
    {
      std::uint8_t& a = colour(join.first);
      std::uint8_t& b = colour(join.second);
      a = a == none && b != none ? 1 - b : a;
      b = b == none && a != none ? 1 - a : b;
    }
  }
  return colours;
}

/// Makes one curve of two, by a bridge between their nearest points that leans towards the goal.
void PatchJoiner::Bridge(const Curve& other, const Curve& goal, Curve& curve)
{
  const PointPair nearest = FindNearest(curve, other);
  const Point3 middle = Between(curve.Points[nearest.First], other.Points[nearest.Second], 0.5);
  Point3 target = middle;
  double least = std::numeric_limits<double>::infinity();
  for (const Point3& point : goal.Points)
  {
    const double distance2 = SquaredDistance(middle, point);
    if (distance2 < least)
    {
      least = distance2;
      target = point;
    }
  }
  const Index bridge = this->AddPoint(Between(middle, target, 0.4));
  Curve joined;
  const auto add = [&](Index corner, const Point3& point)
  {
    joined.Corners.push_back(corner);
    joined.Points.push_back(point);
  };
  for (Index i = 0; i < curve.Count(); ++i)
  {
    add(curve.Corners[i], curve.Points[i]);
    if (i == nearest.First)
    {
      add(bridge, this->Mesh.Points.back());
      for (Index k = 0; k <= other.Count(); ++k)
      {
        const Index j = (nearest.Second + k) % other.Count();
        add(other.Corners[j], other.Points[j]);
      }
      add(bridge, this->Mesh.Points.back());
      add(curve.Corners[i], curve.Points[i]);
    }
  }
  curve = std::move(joined);
}

/// Pairs by the share of the length from a common start, for curves of very many points.
std::vector<PointPair> PairByLength(const Curve& a, const Curve& b, const PointPair& start)
{
  const auto shares = [](const Curve& curve, Index from)
  {
    std::vector<double> lengths(1, 0.0);
    for (Index i = 0; i < curve.Count(); ++i)
    {
      lengths.push_back(lengths.back() +
        std::sqrt(SquaredDistance(
          curve.Points[(from + i) % curve.Count()], curve.Points[(from + i + 1) % curve.Count()])));
    }
    for (double& length : lengths)
    {
      length /= lengths.back();
    }
    return lengths;
  };
  const std::vector<double> ofA = shares(a, start.First);
  const std::vector<double> ofB = shares(b, start.Second);
  std::vector<PointPair> pairs{ start };
  Index i = 0, j = 0;
  while (i < a.Count() || j < b.Count())
  {
    const bool first = i < a.Count() && (j == b.Count() || ofA[i + 1] <= ofB[j + 1]);
    i += first ? 1 : 0;
    j += first ? 0 : 1;
    pairs.push_back({ (start.First + i) % a.Count(), (start.Second + j) % b.Count(), 0.0 });
  }
  return pairs;
}

/**
 * Pairs along both curves, the second one backwards, from their nearest points around to them again:
 * from each pair to the next, one or both points advance. Least sum of squared distances.
 */
std::vector<PointPair> PatchJoiner::Pair(const Curve& a, const Curve& b) const
{
  PointPair start;
  for (Index i = 0; i < a.Count(); ++i)
  {
    for (Index j = 0; j < b.Count(); ++j)
    {
      const double distance2 = SquaredDistance(a.Points[i], b.Points[j]);
      start = distance2 < start.Distance2 ? PointPair{ i, j, distance2 } : start;
    }
  }
  const std::size_t n = a.Count();
  const std::size_t m = b.Count();
  if ((n + 1) * (m + 1) > MostPairs)
  {
    return PairByLength(a, b, start);
  }
  // Step to (i, j): 1 from i - 1, 2 from j - 1, 3 from both.
  std::vector<std::uint8_t> steps((n + 1) * (m + 1), 0);
  std::vector<double> previous(m + 1), current(m + 1);
  for (std::size_t i = 0; i <= n; ++i)
  {
    for (std::size_t j = 0; j <= m; ++j)
    {
      double best = i + j == 0 ? 0.0 : std::numeric_limits<double>::infinity();
      std::uint8_t step = 0;
      const auto consider = [&](double sum, std::uint8_t which)
      {
        if (sum < best)
        {
          best = sum;
          step = which;
        }
      };
      if (i > 0 && j > 0)
      {
        consider(previous[j - 1], 3);
      }
      if (i > 0)
      {
        consider(previous[j], 1);
      }
      if (j > 0)
      {
        consider(current[j - 1], 2);
      }
      current[j] =
        best + SquaredDistance(a.Points[(start.First + i) % n], b.Points[(start.Second + j) % m]);
      steps[i * (m + 1) + j] = step;
    }
    previous.swap(current);
  }
  std::vector<PointPair> pairs;
  std::size_t i = n, j = m;
  while (true)
  {
    pairs.push_back({ static_cast<Index>((start.First + i) % n),
      static_cast<Index>((start.Second + j) % m), 0.0 });
    const std::uint8_t step = steps[i * (m + 1) + j];
    if (step == 0)
    {
      break;
    }
    i -= step & 1;
    j -= step >> 1;
  }
  std::reverse(pairs.begin(), pairs.end());
  return pairs;
}

/// A point between two on one face of the cell moves off the face, as on half a circle.
Point3 PatchJoiner::Arch(const Point3& from, const Point3& to, Point3 between) const
{
  const double height = HighestArch * std::sqrt(SquaredDistance(from, to));
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& planes = this->Geometry.Grid.Planes[axis];
    const Index slab = this->Cell[axis];
    const double most = HighestArch * this->Geometry.Grid.Width(axis, slab);
    if (from[axis] != to[axis])
    {
      continue;
    }
    if (slab > 0 && from[axis] == planes[slab - 1])
    {
      between[axis] += std::min(height, most);
    }
    else if (slab < this->Geometry.Grid.Count(axis) && from[axis] == planes[slab])
    {
      between[axis] -= std::min(height, most);
    }
  }
  return between;
}

/// The strips between a curve and the ring, and between the ring and the other curve.
void PatchJoiner::Fill(const Curve& a, const Curve& b)
{
  const std::vector<PointPair> pairs = this->Pair(a, b);
  std::vector<Index> ring;
  for (std::size_t k = 0; k + 1 < pairs.size(); ++k)
  {
    const Point3& from = a.Points[pairs[k].First];
    const Point3& to = b.Points[pairs[k].Second];
    ring.push_back(this->AddPoint(this->Arch(from, to, Between(from, to, this->Share))));
  }
  ring.push_back(ring.front());
  for (std::size_t k = 0; k + 1 < pairs.size(); ++k)
  {
    this->AddStrip(a, pairs[k].First, pairs[k + 1].First, ring[k], ring[k + 1], false);
    this->AddStrip(b, pairs[k].Second, pairs[k + 1].Second, ring[k], ring[k + 1], true);
  }
}

/**
 * The part of a strip from one pair to the next: between two points of the ring and one or two
 * of a curve, divided by the shorter diagonal.
 */
void PatchJoiner::AddStrip(
  const Curve& curve, Index from, Index to, Index ringFrom, Index ringTo, bool flip)
{
  const auto add = [&](Index p, Index q, Index r)
  {
    this->Mesh.Triangles.push_back(
      flip ? std::array<Index, 3>{ p, r, q } : std::array<Index, 3>{ p, q, r });
  };
  const Index a = curve.Corners[from];
  const Index b = curve.Corners[to];
  if (from == to)
  {
    add(ringFrom, b, ringTo);
    return;
  }
  const Point3& atFrom = this->Mesh.Points[-1 - ringFrom];
  const Point3& atTo = this->Mesh.Points[-1 - ringTo];
  if (SquaredDistance(atFrom, curve.Points[to]) < SquaredDistance(atTo, curve.Points[from]))
  {
    add(ringFrom, a, b);
    add(ringFrom, b, ringTo);
  }
  else
  {
    add(ringFrom, a, ringTo);
    add(ringTo, a, b);
  }
}

PatchMesh PatchJoiner::Run(const std::vector<std::pair<Index, Index>>& joins)
{
  const std::vector<std::uint8_t> colours = this->Colour(joins);
  std::array<std::vector<Curve>, 2> sides;
  std::vector<Index> border, places;
  Index firstPlace = 0;
  for (std::size_t i = 0; i < colours.size(); ++i)
  {
    this->Geometry.GetBoundary(this->Mesh.Cycles[i], border, places);
    Curve curve;
    for (const Index point : border)
    {
      curve.Corners.push_back(firstPlace++);
      curve.Points.push_back(this->Geometry.Graph.PointAt(point));
    }
    sides[colours[i] == 1 ? 1 : 0].push_back(std::move(curve));
  }
  for (int side = 0; side < 2; ++side)
  {
    std::vector<Curve>& curves = sides[side];
    while (curves.size() > 1)
    {
      // The nearest one to what has been joined already.
      std::size_t next = 1;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 1; k < curves.size(); ++k)
      {
        const double distance2 = FindNearest(curves.front(), curves[k]).Distance2;
        next = distance2 < least ? k : next;
        least = std::min(least, distance2);
      }
      const Curve other = curves[next];
      this->Bridge(other, sides[1 - side].front(), curves.front());
      curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(next));
    }
  }
  Curve& back = sides[1].front();
  std::reverse(back.Corners.begin(), back.Corners.end());
  std::reverse(back.Points.begin(), back.Points.end());
  this->Fill(sides[0].front(), back);
  return std::move(this->Mesh);
}
}

PatchMesh BuildJoinedPatch(const CycleGeometry& geometry, const std::vector<Index>& cycles,
  const std::vector<std::pair<Index, Index>>& joins, double share)
{
  return PatchJoiner(geometry, cycles, share).Run(joins);
}
}
