// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/TubePatch.h"

#include "Core/Base/Box.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Least distance of new points from the faces of their cell, as a part of the cell's width: as
/// much as central points of fans keep, too small to be seen and large beside what rounding moves.
constexpr double InnerMargin = 1e-3;
/// The greatest height of an arch, as a part of the cell's width: the middle of the cell.
constexpr double HighestArch = 0.5;
/// Pairs of points up to which curves are compared point by point, with one byte for each pair:
/// 16 MB.
constexpr std::size_t MaxPairs = std::size_t(1) << 24;

/// Pairs by the share of the length from a common start, for curves of very many points.
std::vector<PointPair> PairByLength(
  const PatchCurve& a, const PatchCurve& b, const PointPair& start)
{
  const auto shares = [](const PatchCurve& curve, Index from)
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

/// Points of a curve that are passed over together if none of them can be near.
constexpr Index BlockSize = 64;

/// The square of how far a point is from a box, at most what SquaredDistance has for a point in it.
double SquaredDistanceToBox(const Point3& p, const Box3& box)
{
  Point3 gap;
  for (int k = 0; k < 3; ++k)
  {
    gap[k] = std::max({ 0.0, box.Low[k] - p[k], p[k] - box.High[k] });
  }
  return Dot(gap, gap);
}

/// The points of two curves that are nearest to each other, among all or those on borders; of
/// several pairs, the first one.
PointPair FindNearest(const PatchCurve& a, const PatchCurve& b, bool onBorders)
{
  const auto counts = [&](const PatchCurve& curve, Index i)
  { return !onBorders || curve.Corners[i] >= 0; };
  std::vector<Box3> boxes((b.Count() + BlockSize - 1) / BlockSize);
  for (Index j = 0; j < b.Count(); ++j)
  {
    boxes[j / BlockSize].Add(b.Points[j]);
  }
  PointPair nearest;
  for (Index i = 0; i < a.Count(); ++i)
  {
    for (std::size_t block = 0; block < boxes.size() && counts(a, i); ++block)
    {
      if (SquaredDistanceToBox(a.Points[i], boxes[block]) >= nearest.Distance2)
      {
        continue;
      }
      const Index first = static_cast<Index>(block) * BlockSize;
      for (Index j = first; j < std::min(b.Count(), first + BlockSize); ++j)
      {
        const double distance2 = SquaredDistance(a.Points[i], b.Points[j]);
        if (distance2 < nearest.Distance2 && counts(b, j))
        {
          nearest = { i, j, distance2 };
        }
      }
    }
  }
  return nearest;
}
}

std::vector<PointPair> PairPoints(const PatchCurve& a, const PatchCurve& b)
{
  const PointPair start = FindNearest(a, b, false);
  const std::size_t n = a.Count();
  const std::size_t m = b.Count();
  if ((n + 1) * (m + 1) > MaxPairs)
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

PointPair FindNearestOnBorders(const PatchCurve& a, const PatchCurve& b)
{
  return FindNearest(a, b, true);
}

TubePatch::TubePatch(const CycleGeometry& geometry, const std::vector<Index>& cycles)
  : Geometry(geometry)
  , Cell(geometry.Cycles.Cell[cycles.front()])
{
  this->Mesh.Kind = PatchKind::Joined;
  this->Mesh.Cycles = cycles;
  std::vector<Index> border, nodePlaces;
  for (const Index cycle : cycles)
  {
    this->FirstPlaces.push_back(this->Borders.size());
    geometry.GetBoundary(cycle, border, nodePlaces);
    this->Borders.insert(this->Borders.end(), border.begin(), border.end());
  }
  this->FirstPlaces.push_back(this->Borders.size());
}

Point3 TubePatch::PointAt(Index corner) const
{
  return corner >= 0 ? this->Geometry.Graph.PointAt(this->Borders[corner])
                     : this->Mesh.Points[-1 - corner];
}

PatchCurve TubePatch::BorderOf(std::size_t cycle) const
{
  PatchCurve curve;
  for (std::size_t place = this->FirstPlaces[cycle]; place < this->FirstPlaces[cycle + 1]; ++place)
  {
    curve.Corners.push_back(static_cast<Index>(place));
    curve.Points.push_back(this->PointAt(static_cast<Index>(place)));
  }
  return curve;
}

Index TubePatch::AddPoint(const Point3& point)
{
  Point3 inside;
  for (int axis = 0; axis < 3; ++axis)
  {
    inside[axis] = this->Geometry.Grid.MoveInside(axis, this->Cell[axis], point[axis], InnerMargin);
  }
  this->Mesh.Points.push_back(inside);
  return -static_cast<Index>(this->Mesh.Points.size());
}

/// A point between two on one face of the cell moves off the face, as on half a circle.
Point3 TubePatch::Arch(const Point3& from, const Point3& to, Point3 between, double height) const
{
  height *= std::sqrt(SquaredDistance(from, to));
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& planes = this->Geometry.Grid.Planes[axis];
    const Index slab = this->Cell[axis];
    const double maximum = HighestArch * this->Geometry.Grid.Width(axis, slab);
    if (from[axis] != to[axis])
    {
      continue;
    }
    if (slab > 0 && from[axis] == planes[slab - 1])
    {
      between[axis] += std::min(height, maximum);
    }
    else if (slab < this->Geometry.Grid.Count(axis) && from[axis] == planes[slab])
    {
      between[axis] -= std::min(height, maximum);
    }
  }
  return between;
}

void TubePatch::AddTube(const PatchCurve& a, const PatchCurve& b,
  const std::vector<PointPair>& pairs, double share, double archHeight)
{
  std::vector<Index> ring;
  for (std::size_t k = 0; k + 1 < pairs.size(); ++k)
  {
    const Point3& from = a.Points[pairs[k].First];
    const Point3& to = b.Points[pairs[k].Second];
    ring.push_back(this->AddPoint(this->Arch(from, to, Between(from, to, share), archHeight)));
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
void TubePatch::AddStrip(
  const PatchCurve& curve, Index from, Index to, Index ringFrom, Index ringTo, bool flip)
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
}
