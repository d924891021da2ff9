// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/MeshImprover.h"

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

/// Triangles that are looked at between two questions whether to go on.
constexpr std::size_t TrianglesBetweenCalls = 256;

/// The bounds, as shares of the one asked for: the worst come first.
constexpr std::array<double, 4> Bounds{ 0.1, 0.4, 0.75, 1.0 };

/// The least that an operation gains, as a factor of the squared sine: so that none is done for
/// nothing.
constexpr double LeastGain = 1.02;

/// The same of a collapse, which leaves two triangles less, so that the next one may gain more.
constexpr double LeastOfCollapse = 0.95;

/// The cosine of the angle by which a triangle may turn: 60 degrees.
constexpr double MostTurn = 0.5;

/// What may be done in addition to the worst triangles that are left: those below the share of the
/// angle may move the surface by so many tolerances, and turn by 84 degrees.
constexpr double WorstBound = 0.2;
constexpr double MoreForWorst = 1.4;
constexpr double MostTurnOfWorst = 0.1;

/// Quality that is taken as it comes: 25 degrees.
constexpr double Satisfying = 0.18;

/// Quality beyond which none is better than another one: 35 degrees.
constexpr double GoodEnough = 0.33;

/// Triangles at a point, at most: many more would cost time, and have small angles anyway.
constexpr std::size_t MaxValence = 32;
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

TriangleCorners MeshImprover::PlacesOf(Index triangle) const
{
  const CornerTable& corners = this->Mesh.Corners;
  return { this->Mesh.Points[corners.VertexOf(3 * triangle)],
    this->Mesh.Points[corners.VertexOf(3 * triangle + 1)],
    this->Mesh.Points[corners.VertexOf(3 * triangle + 2)] };
}

double MeshImprover::QualityOf(Index triangle) const
{
  return SquaredSine(this->PlacesOf(triangle));
}

/// Whether no triangle of the star that was set has a fixed point.
bool MeshImprover::IsFree(Index point) const
{
  const CornerTable& corners = this->Mesh.Corners;
  return this->Mesh.Fixed[point] == 0 && point >= this->Limits.Kept &&
    std::all_of(this->Star.Corners.begin(), this->Star.Corners.end(),
      [&](Index corner)
      { return this->Mesh.Fixed[corners.VertexOf(CornerTable::Next(corner))] == 0; });
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
  const TriangleCorners first{ pa, pd, pc }, second{ pd, pb, pc };
  const double before = std::min(this->QualityOf(corner / 3), this->QualityOf(across / 3));
  const double quality = std::min(SquaredSine(first), SquaredSine(second));
  if (!(quality > LeastGain * before) || std::min(quality, GoodEnough) <= best.Quality)
  {
    return;
  }
  const Point3 around = AreaOf({ pa, pb, pc }) + AreaOf({ pb, pa, pd });
  if (CosineBetween(AreaOf(first), around) < this->LeastCosine ||
    CosineBetween(AreaOf(second), around) < this->LeastCosine)
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
  this->Star.Set(this->Mesh.Corners, this->Mesh.Points, start);
  if (!this->IsFree(start) ||
    this->Star.Corners.size() + static_cast<std::size_t>(corners.Valence(end)) > MaxValence)
  {
    return;
  }
  double before = 1.0, quality = 1.0;
  for (const TriangleCorners& triangle : this->Star.Before)
  {
    before = std::min(before, SquaredSine(triangle));
  }
  const double floor = std::max(LeastOfCollapse * before, best.Quality);
  if (!(GoodEnough > floor) ||
    !this->Star.Try(
      this->Mesh.Corners, { this->Mesh.Points[end], end, floor, this->LeastCosine }, quality))
  {
    return;
  }
  const double shift = std::max(this->Shifts[start], this->Shifts[end]) +
    this->Star.Shift(this->Mesh.Points[start], this->Tolerance);
  if (shift <= this->Tolerance && corners.CanCollapse(corner))
  {
    best = { Kind::Collapse, corner, -1, {}, shift, std::min(quality, GoodEnough) };
  }
}

/// Looks at moves of a point towards the middle of those around it.
void MeshImprover::TryMove(Index point, Operation& best) const
{
  this->Star.Set(this->Mesh.Corners, this->Mesh.Points, point);
  if (!this->IsFree(point))
  {
    return;
  }
  const CornerTable& corners = this->Mesh.Corners;
  double before = 1.0;
  Point3 middle{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < this->Star.Corners.size(); ++i)
  {
    before = std::min(before, SquaredSine(this->Star.Before[i]));
    middle = middle +
      (1.0 / this->Star.Corners.size()) *
        this->Mesh.Points[corners.VertexOf(CornerTable::Next(this->Star.Corners[i]))];
  }
  const Point3& from = this->Mesh.Points[point];
  const Point3 normal = Dot(this->Mesh.Normals[point], this->Mesh.Normals[point]) > 0.0
    ? this->Mesh.Normals[point]
    : this->Star.Normal();
  const Point3 along = (middle - from) - Dot(middle - from, normal) * normal;
  for (const double step : { 1.0, 0.6, 0.3 })
  {
    Point3 place = from + step * along;
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = this->Grid.MoveIntoBounds(axis, place[axis]);
    }
    double quality;
    if (!this->Star.Try(this->Mesh.Corners,
          { place, -1, std::max(LeastGain * before, best.Quality), this->LeastCosine }, quality))
    {
      continue;
    }
    const double shift = this->Shifts[point] + this->Star.Shift(from, this->Tolerance);
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
void MeshImprover::RunBelow(double quality, bool withMoves, const Execution& execution)
{
  const CornerTable& corners = this->Mesh.Corners;
  this->Open.resize(static_cast<std::size_t>(corners.CornerCount()) / 3);
  std::iota(this->Open.begin(), this->Open.end(), 0);
  std::size_t work = MaxWork * this->Open.size();
  for (std::size_t i = 0; i < this->Open.size() && work > 0; ++i)
  {
    const Index triangle = this->Open[i];
    if (i % TrianglesBetweenCalls == 0)
    {
      execution.Advance(i, this->Open.size());
    }
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

void MeshImprover::Run(const Execution& execution)
{
  const auto qualityOf = [](double degrees)
  {
    const double sine = std::sin(degrees * Degree);
    return sine * sine;
  };
  for (const double share : Bounds)
  {
    const double quality = qualityOf(share * this->Limits.SmallAngle);
    this->RunBelow(quality, false, execution);
    this->RunBelow(quality, true, execution);
  }
  this->Tolerance *= MoreForWorst;
  this->LeastCosine = MostTurnOfWorst;
  std::fill(this->FailedAt.begin(), this->FailedAt.end(), std::array<Index, 2>{ 0, 0 });
  this->RunBelow(qualityOf(WorstBound * this->Limits.SmallAngle), true, execution);
}
}
