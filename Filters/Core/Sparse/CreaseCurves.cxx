// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/CreaseCurves.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

namespace orthoslices
{
namespace
{
/// Radians by which the turns of two corners of one edge may differ: as much as a corner of 90
/// degrees differs from one of the least.
constexpr double MaxTurnDifference = 0.55;
/// The cosine of the angle between the ways that they point, in parallel slices.
constexpr double MinSameWay = 0.8;
/// How far apart they may be, as a multiple of the distance that slices have there.
constexpr double MaxSlant = 1.5;
/// What a path may cost, as a multiple of the distance of its ends.
constexpr double MaxCost = 8.0;
/// What a path costs beside the straight line between its ends, for each length of distance: so
/// much that it follows the line from point to point.
constexpr double CostOfDistance = 2.0;

/// Two corners, by their places in ContourCorners, and the cell of the patch between them.
struct Crease
{
  Index From, To;
  Index Cell;
  double Length;
};

class CreaseDrawer
{
public:
  explicit CreaseDrawer(SurfaceMesh& mesh)
    : Mesh(mesh)
    , Corners(mesh.ContourCorners)
    , Partners(Corners.size())
  {
  }

  void Run();

private:
  using CornerInCell = std::pair<Index, Index>; ///< a cell, and a corner on its border

  std::vector<CornerInCell> ListCorners() const;
  double DistanceOf(Index one, Index other) const;
  void Match(const CornerInCell* begin, const CornerInCell* end);
  double CostOf(const Crease& crease, Index point) const;
  void OpenEar(Index point, Index cell);
  bool FindPath(const Crease& crease);
  void Draw(const Crease& crease);
  Point3 DirectionAt(Index corner, Index from, Index to) const;

  const Point3& PlaceOf(Index corner) const
  {
    return this->Mesh.Points[this->Corners[corner].Point];
  }
  Point3 Way(Index from, Index to) const
  {
    return this->Mesh.InWorld(this->Corners[from].Point, this->Corners[to].Point);
  }

  SurfaceMesh& Mesh;
  const std::vector<ContourCorner>& Corners;
  std::vector<Crease> Creases;
  std::vector<std::vector<Index>> Partners; ///< of each corner
  std::vector<double> Cost;                 ///< of the way to each point; infinite where none is
  std::vector<Index> Before;                ///< the point before it
  std::vector<Index> Reached;
  std::vector<Index> Path; ///< from its first point to the last
};

/// The corners of each cell, by cells.
std::vector<CreaseDrawer::CornerInCell> CreaseDrawer::ListCorners() const
{
  std::vector<CornerInCell> list;
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    const Index point = this->Corners[i].Point;
    if (this->Mesh.Corners.IsUsed(point))
    {
      this->Mesh.Corners.ForCornersAt(point,
        [&](Index at) { list.emplace_back(this->Mesh.Cell[at / 3], static_cast<Index>(i)); });
    }
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

/// Infinite for corners that do not belong together.
double CreaseDrawer::DistanceOf(Index one, Index other) const
{
  const ContourCorner &a = this->Corners[one], &b = this->Corners[other];
  const double distance = Length(this->Way(one, other));
  const Point3 apart = this->PlaceOf(one) - this->PlaceOf(other);
  const double slices = std::max(std::abs(apart[a.Axis]), std::abs(apart[b.Axis]));
  const bool isParallel = a.Axis == b.Axis;
  const bool isOne = (a.Turn > 0.0) == (b.Turn > 0.0) &&
    std::abs(a.Turn - b.Turn) < MaxTurnDifference && apart[a.Axis] != 0.0 &&
    distance < MaxSlant * slices && Dot(a.Tip, b.Tip) > (isParallel ? MinSameWay : 0.0);
  return isOne ? distance : HUGE_VAL;
}

/// Finds the pairs among the corners of a cell.
void CreaseDrawer::Match(const CornerInCell* begin, const CornerInCell* end)
{
  const auto nearest = [&](Index corner)
  {
    std::pair<double, Index> best(HUGE_VAL, -1);
    for (const CornerInCell* other = begin; other != end; ++other)
    {
      best = std::min(best, { this->DistanceOf(corner, other->second), other->second });
    }
    return best;
  };
  for (const CornerInCell* one = begin; one != end; ++one)
  {
    const auto [distance, other] = nearest(one->second);
    if (std::isfinite(distance) && one->second < other && nearest(other).second == one->second)
    {
      this->Creases.push_back({ one->second, other, one->first, distance });
      this->Partners[one->second].push_back(other);
      this->Partners[other].push_back(one->second);
    }
  }
}

/// What a point costs by its distance from the straight line.
double CreaseDrawer::CostOf(const Crease& crease, Index point) const
{
  const Index from = this->Corners[crease.From].Point, to = this->Corners[crease.To].Point;
  const Point3 way = this->Mesh.Edge(from, to), gone = this->Mesh.Edge(from, point);
  const double share = std::clamp(Dot(gone, way) / std::max(Dot(way, way), 1e-300), 0.0, 1.0);
  return CostOfDistance * Length(gone - share * way);
}

/// Where a single triangle of the patch is at a corner, no edge leads from it into the patch: the
/// one across from it is split.
void CreaseDrawer::OpenEar(Index point, Index cell)
{
  Index triangles = 0, ear = -1;
  this->Mesh.Corners.ForCornersAt(point,
    [&](Index at)
    {
      const bool isOf = this->Mesh.Cell[at / 3] == cell;
      triangles += isOf ? 1 : 0;
      ear = isOf ? at : ear;
    });
  if (triangles == 1 && !this->Mesh.Corners.IsCurve(ear))
  {
    SplitEdge(ear, 0.5, this->Mesh);
  }
}

/// The cheapest path of edges inside the patch, through points that are not fixed.
bool CreaseDrawer::FindPath(const Crease& crease)
{
  const CornerTable& table = this->Mesh.Corners;
  const Index from = this->Corners[crease.From].Point, to = this->Corners[crease.To].Point;
  const double most = MaxCost * Length(this->Mesh.Edge(from, to));
  for (const Index point : this->Reached)
  {
    this->Cost[point] = HUGE_VAL;
  }
  this->Reached.assign(1, from);
  this->Cost[from] = 0.0;
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>,
    std::greater<>>
    next;
  next.emplace(0.0, from);
  while (!next.empty() && next.top().second != to)
  {
    const auto [cost, point] = next.top();
    next.pop();
    if (cost > this->Cost[point])
    {
      continue;
    }
    table.ForCornersAt(point,
      [&, cost = cost, point = point](Index at)
      {
        const Index beside = table.VertexOf(CornerTable::Next(at));
        if (this->Mesh.Cell[at / 3] != crease.Cell || (this->Mesh.Fixed[beside] && beside != to))
        {
          return;
        }
        const double way =
          cost + Length(this->Mesh.Edge(point, beside)) + this->CostOf(crease, beside);
        if (way < this->Cost[beside] && way <= most)
        {
          this->Cost[beside] = way;
          this->Before[beside] = point;
          this->Reached.push_back(beside);
          next.emplace(way, beside);
        }
      });
  }
  if (next.empty())
  {
    return false;
  }
  this->Path.assign(1, to);
  while (this->Path.back() != from)
  {
    this->Path.push_back(this->Before[this->Path.back()]);
  }
  std::reverse(this->Path.begin(), this->Path.end());
  return true;
}

/// The derivative of the curve at one of its ends, by its share from `from` to `to`.
Point3 CreaseDrawer::DirectionAt(Index corner, Index from, Index to) const
{
  const Point3 straight = this->PlaceOf(to) - this->PlaceOf(from);
  const std::vector<Index>& partners = this->Partners[corner];
  const Index other = corner == from ? to : from;
  if (partners.size() != 2)
  {
    return straight;
  }
  const Index beyond = partners[0] == other ? partners[1] : partners[0];
  const Point3 before = corner == from ? this->PlaceOf(from) - this->PlaceOf(beyond)
                                       : this->PlaceOf(beyond) - this->PlaceOf(to);
  const double own = Length(this->Way(from, to)), next = Length(this->Way(corner, beyond));
  // The parabola through the three, by lengths.
  return (1.0 / (own + next)) * (next * straight + (own * own / next) * before);
}

void CreaseDrawer::Draw(const Crease& crease)
{
  SurfaceMesh& mesh = this->Mesh;
  std::vector<double> lengths(1, 0.0);
  for (std::size_t i = 1; i < this->Path.size(); ++i)
  {
    lengths.push_back(lengths.back() + Length(mesh.Edge(this->Path[i - 1], this->Path[i])));
  }
  const Point3 p = this->PlaceOf(crease.From), q = this->PlaceOf(crease.To);
  const Point3 a = this->DirectionAt(crease.From, crease.From, crease.To);
  const Point3 b = this->DirectionAt(crease.To, crease.From, crease.To);
  const Box3& cell = mesh.Cells[crease.Cell];
  for (std::size_t i = 0; i < this->Path.size(); ++i)
  {
    const Index point = this->Path[i];
    mesh.Crease[point] = 1;
    if (mesh.Fixed[point])
    {
      continue;
    }
    const double x = lengths[i] / lengths.back(), y = 1.0 - x;
    mesh.Points[point] =
      y * y * (1.0 + 2.0 * x) * p + x * x * (1.0 + 2.0 * y) * q + x * y * (y * a - x * b);
    for (int axis = 0; axis < 3; ++axis)
    {
      mesh.Points[point][axis] =
        std::clamp(mesh.Points[point][axis], cell.Low[axis], cell.High[axis]);
    }
    mesh.Fixed[point] = 1;
  }
  for (std::size_t i = 1; i < this->Path.size(); ++i)
  {
    mesh.Corners.MarkCurve(mesh.Corners.FindEdge(this->Path[i - 1], this->Path[i]));
  }
}

void CreaseDrawer::Run()
{
  const std::vector<CornerInCell> list = this->ListCorners();
  for (auto begin = list.begin(); begin != list.end();)
  {
    const auto end = std::find_if(
      begin, list.end(), [&](const CornerInCell& corner) { return corner.first != begin->first; });
    this->Match(&*begin, &*begin + (end - begin));
    begin = end;
  }
  // The shortest ones are the surest, and leave room for others.
  std::sort(this->Creases.begin(), this->Creases.end(),
    [](const Crease& one, const Crease& other) {
      return std::tie(one.Length, one.From, one.To) < std::tie(other.Length, other.From, other.To);
    });
  for (const Crease& crease : this->Creases)
  {
    this->OpenEar(this->Corners[crease.From].Point, crease.Cell);
    this->OpenEar(this->Corners[crease.To].Point, crease.Cell);
  }
  this->Cost.assign(this->Mesh.Points.size(), HUGE_VAL);
  this->Before.assign(this->Mesh.Points.size(), -1);
  for (const Crease& crease : this->Creases)
  {
    if (this->FindPath(crease))
    {
      this->Draw(crease);
    }
  }
}
}

void KeepCorners(std::vector<ContourCorner>&& corners, SurfaceMesh& mesh)
{
  mesh.ContourCorners = std::move(corners);
  for (const ContourCorner& corner : mesh.ContourCorners)
  {
    mesh.Fixed[corner.Point] = SurfaceMesh::AtCorner;
  }
}

void DrawCreases(SurfaceMesh& mesh)
{
  if (!mesh.ContourCorners.empty())
  {
    CreaseDrawer(mesh).Run();
  }
}
}
