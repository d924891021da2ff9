// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/MissingContours.h"

#include "Core/Planar/UncrossCurves.h"
#include "Core/Sparse/InterpolatePolygon.h"
#include "Core/Sparse/SlicePart.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/**
 * What a contour encloses, as a part of the one before, from which the part does not end there. The
 * last section of a ball of radius R cut at distance h is at most (n - 1) / (2 n - 4) of the one
 * before, n = 2 R / h: 0.83 for three and a half slices, less for more.
 */
constexpr double MinShareOfSteady = 0.85;

/// What the smaller one of two contours on both sides of a gap encloses of the other one, at least.
constexpr double MinLikeness = 0.5;

/// More slices without the contour than this are a gap that no one has overlooked.
constexpr Index MaxMissing = 2;

using Polygon = std::vector<Point2>;

/// Finds the missing contours of one family.
class FamilyCompleter
{
public:
  FamilyCompleter(const Contours& contours, const SpatialGrid& grid, int axis)
    : Set(contours)
    , Grid(grid)
    , Axis(axis)
    , OnPlane(static_cast<std::size_t>(grid.Count(axis)))
  {
  }

  void Run(const Execution& execution, MissingContours& missing);

private:
  void ReadParts(const Execution& execution);
  /// The contour of a plane that a part overlaps and that encloses most; -1 if there is none.
  Index LargestOn(Index plane, const SlicePart& part) const;
  bool IsEnd(const SlicePart& part, int direction) const;
  std::vector<Index> FindEnds(int direction, const Execution& execution) const;
  Index NearestOf(Index end, const std::vector<Index>& others) const;
  void Bridge(const SlicePart& from, const SlicePart& to, MissingContours& missing);
  bool IsPossible(const Polygon& polygon, Index plane, const SlicePart& like) const;
  bool DoOthersAgree(const Polygon& polygon, Index plane) const;
  bool IsInsideOn(int axis, double coordinate, const Point3& p) const;
  Index DepthOf(const Point2& p, Index plane) const;

  const Contours& Set;
  const SpatialGrid& Grid;
  const int Axis;
  std::vector<SlicePart> Parts;
  std::vector<std::vector<Index>> OnPlane; ///< numbers of parts
};

void FamilyCompleter::ReadParts(const Execution& execution)
{
  std::vector<Index> contours;
  for (Index contour = 0; contour < this->Set.Count(); ++contour)
  {
    if (this->Set.Axis[contour] == this->Axis && !this->Set.IsVirtual(contour))
    {
      this->OnPlane[this->Set.Plane[contour]].push_back(static_cast<Index>(contours.size()));
      contours.push_back(contour);
    }
  }
  this->Parts.resize(contours.size());
  execution.For(contours.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Parts[i] = MakeSlicePart(this->Set, contours[i]);
      }
    });
}

Index FamilyCompleter::LargestOn(Index plane, const SlicePart& part) const
{
  Index largest = -1;
  for (const Index other : this->OnPlane[plane])
  {
    if (DoOverlap(part, this->Parts[other]) &&
      (largest < 0 || std::abs(this->Parts[other].Area) > std::abs(this->Parts[largest].Area)))
    {
      largest = other;
    }
  }
  return largest;
}

/// Whether nothing continues a part on the next slice in this direction, though it does not shrink
/// there.
bool FamilyCompleter::IsEnd(const SlicePart& part, int direction) const
{
  const Index next = part.Plane + direction, previous = part.Plane - direction;
  if (std::min(next, previous) < 0 ||
    std::max(next, previous) >= static_cast<Index>(this->OnPlane.size()) ||
    this->LargestOn(next, part) >= 0)
  {
    return false;
  }
  const Index before = this->LargestOn(previous, part);
  return before >= 0 &&
    std::abs(part.Area) >= MinShareOfSteady * std::abs(this->Parts[before].Area);
}

std::vector<Index> FamilyCompleter::FindEnds(int direction, const Execution& execution) const
{
  std::vector<std::uint8_t> isEnd(this->Parts.size(), 0);
  execution.For(isEnd.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        isEnd[i] = this->IsEnd(this->Parts[i], direction) ? 1 : 0;
      }
    });
  std::vector<Index> ends;
  for (std::size_t i = 0; i < isEnd.size(); ++i)
  {
    if (isEnd[i] != 0)
    {
      ends.push_back(static_cast<Index>(i));
    }
  }
  return ends;
}

/// The end on the other side of a gap that is nearest to this one; -1 if there is none.
Index FamilyCompleter::NearestOf(Index end, const std::vector<Index>& others) const
{
  const SlicePart& part = this->Parts[end];
  Index nearest = -1;
  std::pair<Index, double> least{ MaxMissing + 2, 0.0 }; // slices, then distance of the middles
  for (const Index other : others)
  {
    const SlicePart& candidate = this->Parts[other];
    const double a = std::abs(part.Area), b = std::abs(candidate.Area);
    const std::pair<Index, double> distance{ std::abs(candidate.Plane - part.Plane),
      std::hypot(candidate.Middle[0] - part.Middle[0], candidate.Middle[1] - part.Middle[1]) };
    if (distance.first > 1 && distance < least && std::min(a, b) >= MinLikeness * std::max(a, b) &&
      DoOverlap(part, candidate))
    {
      least = distance;
      nearest = other;
    }
  }
  return nearest;
}

/// How many contours of a slice a point is inside of.
Index FamilyCompleter::DepthOf(const Point2& p, Index plane) const
{
  Index depth = 0;
  for (const Index other : this->OnPlane[plane])
  {
    depth += IsInside(this->Parts[other].Vertices, p) ? 1 : 0;
  }
  return depth;
}

bool FamilyCompleter::IsPossible(const Polygon& polygon, Index plane, const SlicePart& like) const
{
  if (polygon.size() < 3)
  {
    return false;
  }
  PlanarCurves curves;
  AddClosedCurve(polygon, curves);
  for (const Index other : this->OnPlane[plane])
  {
    AddClosedCurve(this->Parts[other].Vertices, curves);
  }
  return AreSimple(curves) &&
    this->DepthOf(polygon[0], plane) % 2 ==
    (this->DepthOf(like.Vertices[0], like.Plane) -
      (IsInside(like.Vertices, like.Vertices[0]) ? 1 : 0)) %
      2 &&
    this->DoOthersAgree(polygon, plane);
}

/// Whether a point on a slice is inside by the contours there.
bool FamilyCompleter::IsInsideOn(int axis, double coordinate, const Point3& p) const
{
  bool inside = false;
  for (Index contour = 0; contour < this->Set.Count(); ++contour)
  {
    if (this->Set.Axis[contour] == axis && this->Set.Coordinate[contour] == coordinate)
    {
      inside = inside !=
        IsInside(
          MakeSlicePart(this->Set, contour).Vertices, { p[FirstAxis(axis)], p[SecondAxis(axis)] });
    }
  }
  return inside;
}

/// Whether the slices of other families that pass through the polygon are inside there: all, and
/// one at least if there are any.
bool FamilyCompleter::DoOthersAgree(const Polygon& polygon, Index plane) const
{
  const std::array<int, 2> axes{ FirstAxis(this->Axis), SecondAxis(this->Axis) };
  Index agree = 0;
  for (int i = 0; i < 2; ++i)
  {
    for (const double coordinate : this->Grid.Planes[axes[i]])
    {
      std::vector<double> places; // where the slice meets the polygon
      for (std::size_t v = 0; v < polygon.size(); ++v)
      {
        const Point2 &a = polygon[v], &b = polygon[(v + 1) % polygon.size()];
        if ((a[i] <= coordinate) != (b[i] <= coordinate))
        {
          const double t = (coordinate - a[i]) / (b[i] - a[i]);
          places.push_back(a[1 - i] + t * (b[1 - i] - a[1 - i]));
        }
      }
      std::sort(places.begin(), places.end());
      for (std::size_t k = 0; k + 1 < places.size(); k += 2)
      {
        Point3 p;
        p[this->Axis] = this->Grid.Planes[this->Axis][plane];
        p[axes[i]] = coordinate;
        p[axes[1 - i]] = 0.5 * (places[k] + places[k + 1]);
        if (!this->IsInsideOn(axes[i], coordinate, p))
        {
          return false;
        }
        ++agree;
      }
    }
  }
  return agree > 0 || this->Grid.Count(axes[0]) + this->Grid.Count(axes[1]) == 0;
}

/// Adds the contours between two ends, if all of them are possible.
void FamilyCompleter::Bridge(const SlicePart& from, const SlicePart& to, MissingContours& missing)
{
  const std::vector<double>& planes = this->Grid.Planes[this->Axis];
  std::vector<Polygon> polygons;
  for (Index plane = from.Plane + 1; plane < to.Plane; ++plane)
  {
    const double share =
      (planes[plane] - planes[from.Plane]) / (planes[to.Plane] - planes[from.Plane]);
    polygons.push_back(InterpolatePolygon(this->Grid, from.Vertices, to.Vertices, share));
    if (!this->IsPossible(polygons.back(), plane, from))
    {
      return;
    }
  }
  Index plane = from.Plane;
  for (const Polygon& polygon : polygons)
  {
    ++plane;
    Contours& found = missing.Found;
    for (const Point2& p : polygon)
    {
      found.U.push_back(p[0]);
      found.V.push_back(p[1]);
    }
    found.Offsets.push_back(static_cast<Index>(found.U.size()));
    found.Axis.push_back(static_cast<std::int8_t>(this->Axis));
    found.Coordinate.push_back(planes[plane]);
    found.Plane.push_back(plane);
    found.Cell.push_back(-1);
    const Point2 middle = MiddleOf(polygon);
    Point3 where;
    where[FirstAxis(this->Axis)] = middle[0];
    where[SecondAxis(this->Axis)] = middle[1];
    where[this->Axis] = planes[plane];
    missing.Repairs.push_back(
      { RepairKind::ContourInserted, this->Axis, plane, where, LengthOf(polygon) });
    this->OnPlane[plane].push_back(static_cast<Index>(this->Parts.size()));
    this->Parts.push_back(MakeSlicePart(found, found.Count() - 1));
  }
}

void FamilyCompleter::Run(const Execution& execution, MissingContours& missing)
{
  this->ReadParts(execution);
  const std::vector<Index> below = this->FindEnds(1, execution);
  const std::vector<Index> above = this->FindEnds(-1, execution);
  std::vector<std::pair<Index, Index>> pairs;
  for (const Index end : below)
  {
    std::vector<Index> beyond;
    std::copy_if(above.begin(), above.end(), std::back_inserter(beyond),
      [&](Index other) { return this->Parts[other].Plane > this->Parts[end].Plane; });
    const Index other = this->NearestOf(end, beyond);
    if (other >= 0)
    {
      pairs.emplace_back(end, other);
    }
  }
  // Outer contours before those within them.
  std::stable_sort(pairs.begin(), pairs.end(),
    [this](const auto& a, const auto& b)
    { return std::abs(this->Parts[a.first].Area) > std::abs(this->Parts[b.first].Area); });
  for (const auto& pair : pairs)
  {
    std::vector<Index> before;
    std::copy_if(below.begin(), below.end(), std::back_inserter(before),
      [&](Index other) { return this->Parts[other].Plane < this->Parts[pair.second].Plane; });
    if (this->NearestOf(pair.second, before) == pair.first)
    {
      const SlicePart from = this->Parts[pair.first], to = this->Parts[pair.second];
      this->Bridge(from, to, missing);
    }
  }
}
}

MissingContours FindMissingContours(
  const Contours& contours, const SpatialGrid& grid, const Execution& execution)
{
  MissingContours missing;
  for (int axis = 0; axis < 3; ++axis)
  {
    FamilyCompleter(contours, grid, axis).Run(execution, missing);
  }
  return missing;
}
}
