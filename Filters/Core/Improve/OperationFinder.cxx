// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/OperationFinder.h"

#include "Core/Base/Vectors.h"
#include "Core/Improve/MakesFold.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// What is refused for a triangle because others are near, at most, before it is left as it is.
constexpr std::size_t MaxRefusals = 12;

/// Quality that is taken as it comes: 25 degrees.
constexpr double Satisfying = 0.18;

/// Triangles at a point, at most: many more would cost time, and have small angles anyway.
constexpr std::size_t MaxValence = 32;
}

bool OperationFinder::WasRefused(const LocalOperation& operation) const
{
  return std::any_of(this->Refused.begin(), this->Refused.end(),
    [&](const LocalOperation& refused)
    {
      return refused.What == operation.What && refused.Corner == operation.Corner &&
        refused.Point == operation.Point && refused.Place == operation.Place;
    });
}

void OperationFinder::TryFlip(Index corner, LocalOperation& best) const
{
  const CornerTable& corners = this->State.Mesh.Corners;
  if (corners.IsCurve(corner))
  {
    return;
  }
  const Index across = corners.OppositeOf(corner);
  const Index a = corners.StartOf(corner), b = corners.EndOf(corner);
  const Index c = corners.VertexOf(corner), d = corners.VertexOf(across);
  const Point3 &pa = this->State.Mesh.Points[a], &pb = this->State.Mesh.Points[b],
               &pc = this->State.Mesh.Points[c], &pd = this->State.Mesh.Points[d];
  const TriangleCorners first{ pa, pd, pc }, second{ pd, pb, pc };
  const double before =
    std::min(this->State.QualityOf(corner / 3), this->State.QualityOf(across / 3));
  const double quality = std::min(SquaredSine(first), SquaredSine(second));
  if (!(quality > LeastGain * before) || std::min(quality, GoodEnough) <= best.Quality)
  {
    return;
  }
  const Point3 around = AreaOf({ pa, pb, pc }) + AreaOf({ pb, pa, pd });
  if (CosineBetween(AreaOf(first), around) < this->State.LeastCosine ||
    CosineBetween(AreaOf(second), around) < this->State.LeastCosine)
  {
    return;
  }
  // The two diagonals are so far apart.
  const Point3 across3 = Cross(pb - pa, pd - pc);
  const double length = Length(across3);
  const double shift = length > 0.0 ? std::abs(Dot(pc - pa, across3)) / length : HUGE_VAL;
  const LocalOperation flip{ LocalOperation::Kind::Flip, corner, -1, {},
    std::min(quality, GoodEnough) };
  if (shift <= this->State.Samples.ToleranceOfSide(corner / 3, across / 3) * this->State.Slack &&
    !this->WasRefused(flip) && corners.CanFlip(corner))
  {
    best = flip;
  }
}

/// Looks at the collapse of a corner's edge, from its start into its end.
void OperationFinder::TryCollapse(Index corner, LocalOperation& best)
{
  const CornerTable& corners = this->State.Mesh.Corners;
  const Index start = corners.StartOf(corner), end = corners.EndOf(corner);
  if (start < this->State.Block.Kept)
  {
    return;
  }
  PointStar& star = this->StarOf(start);
  if (star.Corners.size() + static_cast<std::size_t>(corners.Valence(end)) > MaxValence)
  {
    return;
  }
  double quality = 1.0;
  const double floor = std::max(this->State.LeastOfCollapse * star.Quality, best.Quality);
  if (!(GoodEnough > floor) ||
    !star.Try({ this->State.Mesh.Points[end], end, floor, this->State.LeastCosine }, quality))
  {
    return;
  }
  const LocalOperation collapse{ LocalOperation::Kind::Collapse, corner, -1, {},
    std::min(quality, GoodEnough) };
  if (this->IsNear(star) && !this->WasRefused(collapse) && corners.CanCollapse(corner))
  {
    best = collapse;
  }
}

/// Looks at moves of a point towards the middle of those around it.
void OperationFinder::TryMove(Index point, LocalOperation& best)
{
  if (point < this->State.Block.Kept)
  {
    return;
  }
  PointStar& star = this->StarOf(point);
  const double floor = std::max(LeastGain * star.Quality, best.Quality);
  if (!(GoodEnough > floor) || star.Corners.size() > MaxValence)
  {
    return;
  }
  const Point3& from = this->State.At(point);
  const Point3 normal = Dot(this->State.Mesh.Normals[point], this->State.Mesh.Normals[point]) > 0.0
    ? this->State.Mesh.Normals[point]
    : Unit(star.Outwards);
  const Point3 middle = star.Middle();
  const Point3 along = (middle - from) - Dot(middle - from, normal) * normal;
  for (const double step : { 1.0, 0.6, 0.3 })
  {
    const Point3 place = this->State.MoveIntoBounds(point, from + step * along);
    double quality;
    if (!star.Try({ place, -1, std::max(floor, best.Quality), this->State.LeastCosine }, quality))
    {
      continue;
    }
    if (!this->State.Block.HasInside(place))
    {
      this->IsCutShort = true;
      continue;
    }
    const LocalOperation move{ LocalOperation::Kind::Move, -1, point, place,
      std::min(quality, GoodEnough) };
    if (this->IsNear(star) && !this->WasRefused(move))
    {
      best = move;
    }
  }
}

/// Whether the star that was tried is near the one before, and all samples on that.
bool OperationFinder::IsNear(const PointStar& star) const
{
  return this->State.Samples.AreNear(star, this->State.Slack);
}

/// Describes the triangles at a point, of which another one takes the place.
void OperationFinder::DescribeStar(Index point, Index gone, Index becomes)
{
  const CornerTable& corners = this->State.Mesh.Corners;
  corners.ForCornersAt(point,
    [&](Index corner)
    {
      this->Change.Removed.push_back(corner / 3);
      const Index next = corners.StartOf(corner), last = corners.EndOf(corner);
      if (next != gone && last != gone)
      {
        this->Change.Added.push_back({ becomes, next, last });
      }
    });
}

/// Whether all that a change adds stays within the block. Notes it if not.
bool OperationFinder::StaysInside()
{
  Box3 box;
  for (const std::array<Index, 3>& triangle : this->Change.Added)
  {
    for (const Index point : triangle)
    {
      box.Add(point == this->Change.Point ? this->Change.Place : this->State.At(point));
    }
  }
  const bool stays = this->State.Block.Cells.Cover(box);
  this->IsCutShort = this->IsCutShort || !stays;
  return stays;
}

/// Describes what an operation changes.
void OperationFinder::Describe(const LocalOperation& operation)
{
  const CornerTable& corners = this->State.Mesh.Corners;
  const Index corner = operation.Corner;
  this->Change.Removed.clear();
  this->Change.Added.clear();
  this->Change.Point = -1;
  if (operation.What == LocalOperation::Kind::Collapse)
  {
    this->DescribeStar(corners.StartOf(corner), corners.EndOf(corner), corners.EndOf(corner));
  }
  else if (operation.What == LocalOperation::Kind::Move)
  {
    this->Change.Point = operation.Point;
    this->Change.Place = operation.Place;
    this->DescribeStar(operation.Point, -1, operation.Point);
  }
  else if (operation.What == LocalOperation::Kind::Flip)
  {
    const Index across = corners.OppositeOf(corner);
    const Index a = corners.StartOf(corner), b = corners.EndOf(corner);
    const Index c = corners.VertexOf(corner), d = corners.VertexOf(across);
    this->Change.Removed = { corner / 3, across / 3 };
    this->Change.Added = { { a, d, c }, { d, b, c } };
  }
  else
  {
    this->Change.Point = corners.PointCount();
    this->Change.Place = operation.Place;
    this->Change.Removed = { corner / 3, corners.OppositeOf(corner) / 3 };
    for (const Index side : operation.Flipped)
    {
      this->Change.Removed.push_back(corners.OppositeOf(side) / 3);
    }
    for (const Index side : operation.Sides)
    {
      this->Change.Added.push_back(
        { this->Change.Point, corners.StartOf(side), corners.EndOf(side) });
    }
  }
}

/// Whether an operation leaves triangles apart, and, unless it may make folds, those beside each
/// other, too.
bool OperationFinder::IsAllowed(const LocalOperation& operation, bool mayFold)
{
  const ImprovableMesh& mesh = this->State.Mesh;
  this->Describe(operation);
  return this->StaysInside() &&
    (operation.What == LocalOperation::Kind::Collapse ||
      operation.What == LocalOperation::Kind::Move ||
      this->State.Samples.AreNear(this->Change, mesh.Points, this->State.Slack)) &&
    (mayFold || !MakesFold(mesh.Corners, mesh.Points, this->Change, mesh.Borders)) &&
    this->Guard.Allows(this->Change);
}

/// The squared lengths of a triangle's sides, ascending, and the corners across them.
std::array<std::pair<double, Index>, 3> OperationFinder::SidesOf(Index triangle) const
{
  std::array<std::pair<double, Index>, 3> sides;
  for (Index i = 0; i < 3; ++i)
  {
    const Index corner = 3 * triangle + i;
    sides[i] = { SquaredDistance(this->State.At(this->State.Mesh.Corners.StartOf(corner)),
                   this->State.At(this->State.Mesh.Corners.EndOf(corner))),
      corner };
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Flips of the longest side of a triangle, and collapses of the two others; else other flips.
void OperationFinder::TryFlips(Index triangle, LocalOperation& best)
{
  const std::array<std::pair<double, Index>, 3> sides = this->SidesOf(triangle);
  this->TryFlip(sides[2].second, best);
  for (const int i : { 0, 1 })
  {
    this->TryCollapse(sides[i].second, best);
    this->TryCollapse(this->State.Mesh.Corners.OppositeOf(sides[i].second), best);
    if (best.Quality >= Satisfying)
    {
      break; // what is better elsewhere is not worth looking for
    }
  }
  if (best.What == LocalOperation::Kind::None)
  {
    this->TryFlip(sides[0].second, best);
    this->TryFlip(sides[1].second, best);
  }
}

/// The triangles at a corner of the triangle that is looked at.
PointStar& OperationFinder::StarOf(Index point)
{
  std::size_t i = 0;
  while (i + 1 < this->Stars.size() && this->Stars[i].Point != point && this->Stars[i].Point >= 0)
  {
    ++i;
  }
  if (this->Stars[i].Point != point)
  {
    this->Stars[i].Set(this->State.Mesh.Corners, this->State.Mesh.Points, point);
  }
  return this->Stars[i];
}

/// Looks at flips of the sides around the corners of a triangle, and at collapses of those that meet
/// there.
void OperationFinder::TryBeside(Index triangle, LocalOperation& best)
{
  for (Index own = 3 * triangle; own < 3 * triangle + 3; ++own)
  {
    for (const Index corner : this->StarOf(this->State.Mesh.Corners.VertexOf(own)).Corners)
    {
      this->TryFlip(corner, best);
      this->TryCollapse(CornerTable::Previous(corner), best);
    }
  }
}

LocalOperation OperationFinder::FindBest(Index triangle, Means means)
{
  LocalOperation best;
  this->TryFlips(triangle, best);
  for (Index corner = 3 * triangle; means != Means::SameShape && corner < 3 * triangle + 3;
       ++corner)
  {
    this->TryMove(this->State.Mesh.Corners.VertexOf(corner), best);
  }
  if (means == Means::Beside && best.What == LocalOperation::Kind::None)
  {
    this->TryBeside(triangle, best);
  }
  if (means >= Means::Splits && best.What == LocalOperation::Kind::None)
  {
    this->TrySplits(triangle, best);
  }
  return best;
}

/// What keeps all guarantees.
bool OperationFinder::Find(Index triangle, Means means, LocalOperation& found)
{
  this->Refused.clear();
  this->IsCutShort = false;
  for (PointStar& star : this->Stars)
  {
    star.Point = -1;
  }
  while (this->Refused.size() <= MaxRefusals)
  {
    LocalOperation best = this->FindBest(triangle, means);
    if (best.What == LocalOperation::Kind::None)
    {
      return false;
    }
    if (this->IsAllowed(best))
    {
      found = std::move(best);
      std::swap(found.Change, this->Change);
      return true;
    }
    this->Refused.push_back(std::move(best));
  }
  return false;
}
}
