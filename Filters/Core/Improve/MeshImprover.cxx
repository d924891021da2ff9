// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/MeshImprover.h"

#include "Core/Base/TriangleDistance.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
constexpr double Degree = 3.14159265358979323846 / 180.0;

/// Operations for each triangle that there is, at most: a guard, as each makes something better.
constexpr std::size_t MaxWork = 10;

/// The bounds, as shares of the one asked for: the worst come first.
constexpr std::array<double, 4> Bounds{ 0.1, 0.4, 0.75, 1.0 };

/// The least that an operation gains, as a factor of the squared sine: so that none is done for nothing.
constexpr double LeastGain = 1.02;

/// The same of a collapse, which leaves two triangles less, so that the next one may gain more.
constexpr double LeastOfCollapse = 0.95;

/// The cosine of the angle by which a triangle may turn: 60 degrees. Triangles that are slivers have
/// normals that say nothing; those count as the surface around them.
constexpr double MostTurn = 0.5;

/// What may be done in addition to the worst triangles that are left: those below the share of the angle
/// may move the surface by so many tolerances, and turn by 84 degrees.
constexpr double WorstBound = 0.2;
constexpr double MoreForWorst = 1.4;
constexpr double MostTurnOfWorst = 0.1;
constexpr double SliverQuality = 0.01; ///< of the squared sine: 6 degrees

/// The cosine between a triangle and the surface around it, where it has to be compared with that.
constexpr double MostTilt = 0.2;

/// Quality that is taken as it comes: 25 degrees.
constexpr double Satisfying = 0.18;

/// Quality beyond which none is better than another one: 35 degrees.
constexpr double GoodEnough = 0.33;

/// The share of the tolerance up to which distances need not be known exactly.
constexpr double NearEnough = 0.1;

/// Triangles at a point, at most: many more would cost time, and have small angles anyway.
constexpr std::size_t MaxValence = 32;

using Corners3 = std::array<Point3, 3>;

/// Twice the area, along the normal.
Point3 AreaOf(const Corners3& t) { return Cross(t[1] - t[0], t[2] - t[0]); }

/// The squared sine of the smallest angle, which the two longer sides enclose.
double Quality(const Corners3& t)
{
  const Point3 area = AreaOf(t);
  const double a = SquaredDistance(t[0], t[1]);
  const double b = SquaredDistance(t[1], t[2]);
  const double c = SquaredDistance(t[2], t[0]);
  const double product = std::max({ a * b, b * c, c * a });
  return product > 0.0 ? Dot(area, area) / product : 0.0;
}

double Cosine(const Point3& a, const Point3& b)
{
  const double lengths = std::sqrt(Dot(a, a) * Dot(b, b));
  return lengths > 0.0 ? Dot(a, b) / lengths : 0.0;
}
}

MeshImprover::MeshImprover(
  const SpatialGrid& grid, const ImprovementLimits& limits, ImprovableMesh& mesh)
  : Grid(grid)
  , Limits(limits)
  , Mesh(mesh)
  , Tolerance(limits.Tolerance)
  , LeastCosine(MostTurn)
  , Shifts(mesh.Points.size(), 0.0)
{
  const std::size_t count = static_cast<std::size_t>(mesh.Corners.CornerCount()) / 3;
  mesh.Changed.assign(count, 0);
  this->TouchedAt.assign(mesh.Points.size(), 1);
  this->FailedAt.assign(count, { 0, 0 });
}

MeshImprover::Corners3 MeshImprover::PlacesOf(Index triangle) const
{
  const CornerTable& corners = this->Mesh.Corners;
  return { this->Mesh.Points[corners.VertexOf(3 * triangle)],
    this->Mesh.Points[corners.VertexOf(3 * triangle + 1)],
    this->Mesh.Points[corners.VertexOf(3 * triangle + 2)] };
}

double MeshImprover::QualityOf(Index triangle) const { return Quality(this->PlacesOf(triangle)); }

/// Lists the corners at a point and their triangles.
void MeshImprover::GetStar(Index point) const
{
  this->Star.clear();
  this->Before.clear();
  this->Mesh.Corners.ForCornersAt(point,
    [&](Index corner)
    {
      this->Star.push_back(corner);
      this->Before.push_back(this->PlacesOf(corner / 3));
    });
}

/// Whether no triangle of the star that was listed has a fixed point.
bool MeshImprover::IsFree(Index point) const
{
  const CornerTable& corners = this->Mesh.Corners;
  return this->Mesh.Fixed[point] == 0 &&
    std::all_of(this->Star.begin(), this->Star.end(),
      [&](Index corner)
      { return this->Mesh.Fixed[corners.VertexOf(CornerTable::Next(corner))] == 0; });
}

Point3 MeshImprover::NormalOfStar() const
{
  Point3 sum{ 0.0, 0.0, 0.0 };
  for (const Corners3& triangle : this->Before)
  {
    sum = sum + AreaOf(triangle);
  }
  return Unit(sum);
}

/// The distance of a place from the triangles as they would be, or a little more.
double MeshImprover::DistanceToStar(const Point3& place) const
{
  double nearest = HUGE_VAL;
  const double enough = NearEnough * this->Tolerance;
  for (const Corners3& t : this->After)
  {
    nearest = std::min(nearest, SquaredDistanceToTriangle(place, t[0], t[1], t[2]));
    if (nearest <= enough * enough)
    {
      return enough;
    }
  }
  return std::sqrt(nearest);
}

/// How far a point and the middles of its edges are from the triangles as they would be.
double MeshImprover::ShiftOfStar(Index point) const
{
  const Point3& center = this->Mesh.Points[point];
  double shift = this->DistanceToStar(center);
  for (std::size_t i = 0; i < this->Star.size() && shift <= this->Tolerance; ++i)
  {
    const Index next = this->Mesh.Corners.VertexOf(CornerTable::Next(this->Star[i]));
    shift = std::max(shift, this->DistanceToStar(Between(center, this->Mesh.Points[next], 0.5)));
  }
  return shift;
}

/// Whether the triangles at a point, whose star was listed, are unfolded and better than `floor` if the
/// point goes to a place. Triangles with the point `left` vanish.
bool MeshImprover::CheckStar(
  Index point, const Point3& place, Index left, double floor, double& quality) const
{
  const CornerTable& corners = this->Mesh.Corners;
  static_cast<void>(point);
  const Point3 around = this->NormalOfStar();
  this->After.clear();
  quality = 1.0;
  for (std::size_t i = 0; i < this->Star.size(); ++i)
  {
    const Index corner = this->Star[i];
    const Index next = CornerTable::Next(corner), previous = CornerTable::Previous(corner);
    if (corners.VertexOf(next) == left || corners.VertexOf(previous) == left)
    {
      continue;
    }
    Corners3 triangle = this->Before[i];
    triangle[corner % 3] = place;
    const double now = Quality(triangle);
    quality = std::min(quality, now);
    if (!(quality > floor))
    {
      return false;
    }
    const Point3 area = AreaOf(triangle);
    const bool wasSliver = Quality(this->Before[i]) < SliverQuality;
    if (wasSliver ? Cosine(area, around) < MostTilt
                  : Cosine(area, AreaOf(this->Before[i])) < this->LeastCosine)
    {
      return false;
    }
    this->After.push_back(triangle);
  }
  return !this->After.empty();
}

void MeshImprover::TryFlip(Index corner, Operation& best) const
{
  const CornerTable& corners = this->Mesh.Corners;
  const Index across = corners.OppositeOf(corner);
  const Index a = corners.StartOf(corner), b = corners.EndOf(corner);
  const Index c = corners.VertexOf(corner), d = corners.VertexOf(across);
  for (const Index point : { a, b, c, d })
  {
    if (this->Mesh.Fixed[point] != 0)
    {
      return;
    }
  }
  const Point3 &pa = this->Mesh.Points[a], &pb = this->Mesh.Points[b], &pc = this->Mesh.Points[c],
               &pd = this->Mesh.Points[d];
  const Corners3 first{ pa, pd, pc }, second{ pd, pb, pc };
  const double before = std::min(this->QualityOf(corner / 3), this->QualityOf(across / 3));
  const double quality = std::min(Quality(first), Quality(second));
  if (!(quality > LeastGain * before) || std::min(quality, GoodEnough) <= best.Quality)
  {
    return;
  }
  const Point3 around = AreaOf({ pa, pb, pc }) + AreaOf({ pb, pa, pd });
  if (Cosine(AreaOf(first), around) < this->LeastCosine ||
    Cosine(AreaOf(second), around) < this->LeastCosine)
  {
    return;
  }
  // The two diagonals are so far apart.
  const Point3 across3 = Cross(pb - pa, pd - pc);
  const double length = Length(across3);
  const double shift = length > 0.0 ? std::abs(Dot(pc - pa, across3)) / length : HUGE_VAL;
  const double known =
    std::max({ this->Shifts[a], this->Shifts[b], this->Shifts[c], this->Shifts[d] });
  if (shift + known <= this->Tolerance && corners.CanFlip(corner))
  {
    best = { Kind::Flip, corner, -1, {}, shift + known, std::min(quality, GoodEnough) };
  }
}

/// Looks at the collapse of a corner's edge, from its start into its end.
void MeshImprover::TryCollapse(Index corner, Operation& best) const
{
  const CornerTable& corners = this->Mesh.Corners;
  const Index start = corners.StartOf(corner), end = corners.EndOf(corner);
  this->GetStar(start);
  if (!this->IsFree(start) ||
    this->Star.size() + static_cast<std::size_t>(corners.Valence(end)) > MaxValence)
  {
    return;
  }
  double before = 1.0, quality = 1.0;
  for (const Corners3& triangle : this->Before)
  {
    before = std::min(before, Quality(triangle));
  }
  const double floor = std::max(LeastOfCollapse * before, best.Quality);
  if (!(GoodEnough > floor) || !this->CheckStar(start, this->Mesh.Points[end], end, floor, quality))
  {
    return;
  }
  const double shift = std::max(this->Shifts[start], this->Shifts[end]) + this->ShiftOfStar(start);
  if (shift <= this->Tolerance && corners.CanCollapse(corner))
  {
    best = { Kind::Collapse, corner, -1, {}, shift, std::min(quality, GoodEnough) };
  }
}

/// Looks at moves of a point towards the middle of those around it.
void MeshImprover::TryMove(Index point, Operation& best) const
{
  this->GetStar(point);
  if (!this->IsFree(point))
  {
    return;
  }
  const CornerTable& corners = this->Mesh.Corners;
  double before = 1.0;
  Point3 middle{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < this->Star.size(); ++i)
  {
    before = std::min(before, Quality(this->Before[i]));
    middle = middle +
      (1.0 / this->Star.size()) *
        this->Mesh.Points[corners.VertexOf(CornerTable::Next(this->Star[i]))];
  }
  const Point3& from = this->Mesh.Points[point];
  const Point3 normal = Dot(this->Mesh.Normals[point], this->Mesh.Normals[point]) > 0.0
    ? this->Mesh.Normals[point]
    : this->NormalOfStar();
  const Point3 along = (middle - from) - Dot(middle - from, normal) * normal;
  for (const double step : { 1.0, 0.6, 0.3 })
  {
    Point3 place = from + step * along;
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = this->Grid.MoveIntoBounds(axis, place[axis]);
    }
    double quality;
    if (!this->CheckStar(point, place, -1, std::max(LeastGain * before, best.Quality), quality))
    {
      continue;
    }
    const double shift = this->Shifts[point] + this->ShiftOfStar(point);
    if (shift <= this->Tolerance)
    {
      best = { Kind::Move, -1, point, place, shift, std::min(quality, GoodEnough) };
    }
  }
}

/// Notes that the triangles at a point have changed.
void MeshImprover::Touch(Index point)
{
  this->Mesh.Corners.ForCornersAt(point,
    [&](Index corner)
    {
      this->TouchedAt[this->Mesh.Corners.VertexOf(CornerTable::Next(corner))] = this->Now;
      this->Mesh.Changed[corner / 3] = 1;
      this->Open.push_back(corner / 3);
    });
  this->TouchedAt[point] = this->Now;
}

void MeshImprover::Apply(const Operation& operation)
{
  CornerTable& corners = this->Mesh.Corners;
  ++this->Now;
  if (operation.What == Kind::Flip)
  {
    const Index across = corners.OppositeOf(operation.Corner);
    for (const Index at : { operation.Corner, CornerTable::Next(operation.Corner),
           CornerTable::Previous(operation.Corner), across })
    {
      this->Shifts[corners.VertexOf(at)] = operation.Shift;
      this->TouchedAt[corners.VertexOf(at)] = this->Now;
    }
    for (const Index triangle : { operation.Corner / 3, across / 3 })
    {
      this->Mesh.Changed[triangle] = 1;
      this->Open.push_back(triangle);
    }
    corners.Flip(operation.Corner);
    return;
  }
  Index point = operation.Point;
  if (operation.What == Kind::Collapse)
  {
    point = corners.EndOf(operation.Corner);
    corners.ForCornersAt(
      corners.StartOf(operation.Corner), [&](Index corner) { this->Mesh.Changed[corner / 3] = 1; });
    corners.Collapse(operation.Corner);
  }
  else
  {
    this->Mesh.Points[point] = operation.Place;
  }
  this->Touch(point);
  this->Shifts[point] = std::max(this->Shifts[point], operation.Shift);
}

/// Does the best of what can be done to a triangle. False if nothing can.
bool MeshImprover::Improve(Index triangle, bool withMoves)
{
  Operation best;
  best.Quality = 0.0;
  // Across the shortest side, the second and the longest one.
  std::array<std::pair<double, Index>, 3> sides;
  for (Index i = 0; i < 3; ++i)
  {
    const Index corner = 3 * triangle + i;
    sides[i] = { SquaredDistance(this->Mesh.Points[this->Mesh.Corners.StartOf(corner)],
                   this->Mesh.Points[this->Mesh.Corners.EndOf(corner)]),
      corner };
  }
  std::sort(sides.begin(), sides.end());
  this->TryFlip(sides[2].second, best);
  for (const int i : { 0, 1 })
  {
    this->TryCollapse(sides[i].second, best);
    this->TryCollapse(this->Mesh.Corners.OppositeOf(sides[i].second), best);
    if (best.Quality >= Satisfying)
    {
      break; // what is better elsewhere is not worth looking for
    }
  }
  if (best.What == Kind::None)
  {
    this->TryFlip(sides[0].second, best);
    this->TryFlip(sides[1].second, best);
  }
  for (Index corner = 3 * triangle; withMoves && corner < 3 * triangle + 3; ++corner)
  {
    this->TryMove(this->Mesh.Corners.VertexOf(corner), best);
  }
  if (best.What == Kind::None)
  {
    return false;
  }
  this->Apply(best);
  return true;
}

/// Whether anything beside a triangle has changed since nothing helped it.
bool MeshImprover::MayHelp(Index triangle, bool withMoves) const
{
  Index touched = 0;
  for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
  {
    touched = std::max(touched, this->TouchedAt[this->Mesh.Corners.VertexOf(corner)]);
  }
  return touched > this->FailedAt[triangle][withMoves ? 1 : 0];
}

/// Improves the triangles that are worse than a bound, and those that become so.
void MeshImprover::RunBelow(double quality, bool withMoves)
{
  const CornerTable& corners = this->Mesh.Corners;
  this->Open.resize(static_cast<std::size_t>(corners.CornerCount()) / 3);
  std::iota(this->Open.begin(), this->Open.end(), 0);
  std::size_t work = MaxWork * this->Open.size();
  for (std::size_t i = 0; i < this->Open.size() && work > 0; ++i)
  {
    const Index triangle = this->Open[i];
    if (!corners.IsAlive(3 * triangle) || !(this->QualityOf(triangle) < quality) ||
      !this->MayHelp(triangle, withMoves))
    {
      continue;
    }
    --work;
    if (!this->Improve(triangle, withMoves))
    {
      this->FailedAt[triangle][0] = this->Now;
      this->FailedAt[triangle][1] = withMoves ? this->Now : this->FailedAt[triangle][1];
    }
  }
}

void MeshImprover::Run()
{
  const auto qualityOf = [](double degrees)
  {
    const double sine = std::sin(degrees * Degree);
    return sine * sine;
  };
  for (const double share : Bounds)
  {
    const double quality = qualityOf(share * this->Limits.SmallAngle);
    this->RunBelow(quality, false);
    this->RunBelow(quality, true);
  }
  this->Tolerance *= MoreForWorst;
  this->LeastCosine = MostTurnOfWorst;
  std::fill(this->FailedAt.begin(), this->FailedAt.end(), std::array<Index, 2>{ 0, 0 });
  this->RunBelow(qualityOf(WorstBound * this->Limits.SmallAngle), true);
}
}
