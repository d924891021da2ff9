// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
// What OperationFinder does about folds, and what comes near them.
#include "Core/Improve/OperationFinder.h"

#include "Core/Base/TriangleDistance.h"
#include "Core/Base/Vectors.h"
#include "Core/Improve/MakesFold.h"
#include "Core/Improve/PressedPoints.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Triangles that a fold is opened with get no worse quality than this, if they had a better one:
/// 10 degrees.
constexpr double LeastQuality = 0.03;

/// Cosine between normals beyond which a fold is none: 30 degrees between the triangles.
constexpr double OpenEnough = -0.866;

/// How many times as far from -1 the cosine has to be afterwards: half as much again of the angle.
constexpr double LeastOpening = 2.0;

/// Triangles turn as they like.
constexpr double AnyTurn = -2.0;

/// How far points move away from planes, as shares of the tolerance inside plain patches: else to the
/// other side.
constexpr std::array<double, 8> Lifts{ 1.0, 0.5, 0.25, 0.125, -1.0, -0.5, -0.25, -0.125 };

/// How far points move across the fold, as shares of the least height of a triangle over it.
constexpr std::array<double, 3> ShiftsAcross{ 0.1, 0.2, 0.4 };
}

/// Adds an operation, if it opens the fold and leaves triangles well shaped.
void OperationFinder::AddUnfolding(LocalOperation operation)
{
  const std::vector<Point3>& points = this->State.Mesh.Points;
  this->Describe(operation);
  double before = LeastQuality, after = 1.0;
  for (const Index triangle : this->Change.Removed)
  {
    before = std::min(before, this->State.QualityOf(triangle));
  }
  const auto at = [&](Index point) -> const Point3&
  { return point == this->Change.Point ? this->Change.Place : points[point]; };
  for (const auto& [p, q, r] : this->Change.Added)
  {
    after = std::min(after, SquaredSine({ at(p), at(q), at(r) }));
  }
  const FoldChange folds =
    MeasureFolds(this->State.Mesh.Corners, points, this->Change, this->State.Mesh.Borders);
  if (after >= before && 1.0 + folds.After > LeastOpening * (1.0 + folds.Before))
  {
    operation.Quality = after;
    this->Unfoldings.push_back({ std::move(operation), std::min(folds.After, OpenEnough) });
  }
}

/// Adds a flip, if the middle of the side is near what takes its place. Of a fold the distance of the
/// diagonals, by which other flips go, says nothing.
void OperationFinder::AddFlip(Index corner)
{
  const CornerTable& corners = this->State.Mesh.Corners;
  if (!corners.CanFlip(corner))
  {
    return;
  }
  const Index across = corners.OppositeOf(corner);
  const Point3 &a = this->State.At(corners.StartOf(corner)),
               &b = this->State.At(corners.EndOf(corner)),
               &c = this->State.At(corners.VertexOf(corner)),
               &d = this->State.At(corners.VertexOf(across));
  const Point3 middle = Between(a, b, 0.5);
  const double most =
    this->State.Slack * this->State.Samples.ToleranceOfSide(corner / 3, across / 3);
  if (std::min(SquaredDistanceToTriangle(middle, a, d, c),
        SquaredDistanceToTriangle(middle, d, b, c)) <= most * most)
  {
    this->AddUnfolding({ LocalOperation::Kind::Flip, corner, -1, {}, 0.0 });
  }
}

/// Whether the start of a corner's edge may move into its end, however triangles turn, if none gets a
/// quality below that share of the least one before.
bool OperationFinder::MayMerge(Index corner, double shareOfQuality)
{
  const CornerTable& corners = this->State.Mesh.Corners;
  const Index start = corners.StartOf(corner), end = corners.EndOf(corner);
  if (start < this->State.Block.Kept || !corners.CanCollapse(corner))
  {
    return false;
  }
  PointStar& star = this->Stars[0];
  star.Set(corners, this->State.Mesh.Points, start);
  double quality = 1.0;
  return star.Try({ this->State.At(end), end, shareOfQuality * star.Quality, AnyTurn }, quality) &&
    this->IsNear(star);
}

void OperationFinder::AddCollapse(Index corner)
{
  if (this->MayMerge(corner, 0.0))
  {
    this->AddUnfolding({ LocalOperation::Kind::Collapse, corner, -1, {}, 0.0 });
  }
}

/// Adds moves of a point: towards the middle of those around it, and across the fold.
void OperationFinder::AddMoves(Index point, const Point3& across)
{
  if (point < this->State.Block.Kept)
  {
    return;
  }
  PointStar& star = this->Stars[0];
  star.Set(this->State.Mesh.Corners, this->State.Mesh.Points, point);
  const Point3& from = this->State.At(point);
  const Point3 middle = star.Middle() - from;
  std::vector<Point3> steps{ middle, 0.6 * middle, 0.3 * middle };
  for (const double shift : ShiftsAcross)
  {
    steps.push_back(shift * across);
    steps.push_back(-shift * across);
  }
  for (const Point3& step : steps)
  {
    const Point3 place = this->State.MoveIntoBounds(point, from + step);
    double quality = 1.0;
    if (!this->State.Block.HasInside(place))
    {
      this->IsCutShort = true;
    }
    else if (star.Try({ place, -1, 0.0, AnyTurn }, quality) && this->IsNear(star))
    {
      this->AddUnfolding({ LocalOperation::Kind::Move, -1, point, place, 0.0 });
    }
  }
}

/// Lists what opens the fold at a corner's edge, what opens it most first.
void OperationFinder::ListUnfolding(Index corner)
{
  const CornerTable& corners = this->State.Mesh.Corners;
  this->Unfoldings.clear();
  const Index opposite = corners.OppositeOf(corner);
  const std::array<Index, 5> sides{ corner, CornerTable::Next(corner),
    CornerTable::Previous(corner), CornerTable::Next(opposite), CornerTable::Previous(opposite) };
  for (const Index side : sides)
  {
    const Index beyond = corners.OppositeOf(side);
    this->AddFlip(side);
    this->AddCollapse(side);
    this->AddCollapse(beyond);
  }
  const TriangleCorners own = this->State.PlacesOf(corner / 3);
  const TriangleCorners other = this->State.PlacesOf(opposite / 3);
  const Point3 normal = AreaOf(own);
  const Point3 along =
    this->State.At(corners.EndOf(corner)) - this->State.At(corners.StartOf(corner));
  const double area = std::min(Length(normal), Length(AreaOf(other)));
  const double length = Length(along) * Length(normal);
  const Point3 across = (length > 0.0 ? area / length : 0.0) * normal;
  for (const Index point : { corners.VertexOf(corner), corners.VertexOf(opposite),
         corners.StartOf(corner), corners.EndOf(corner) })
  {
    this->AddMoves(point, across);
  }
  std::stable_sort(this->Unfoldings.begin(), this->Unfoldings.end(),
    [](const Unfolding& a, const Unfolding& b)
    {
      return a.Cosine > b.Cosine ||
        (a.Cosine == b.Cosine && a.Operation.Quality > b.Operation.Quality);
    });
}

bool OperationFinder::FindMerge(Index corner, LocalOperation& found)
{
  const CornerTable& corners = this->State.Mesh.Corners;
  this->IsCutShort = false;
  for (const Index side : { corner, corners.OppositeOf(corner) })
  {
    found = { LocalOperation::Kind::Collapse, side, -1, {}, 0.0 };
    if (this->MayMerge(side, 1.0) && this->IsAllowed(found, true))
    {
      std::swap(found.Change, this->Change);
      return true;
    }
  }
  return false;
}

bool OperationFinder::FindLift(Index point, LocalOperation& found)
{
  const ImprovableMesh& mesh = this->State.Mesh;
  const double tolerance = this->State.Samples.ToleranceInside();
  this->IsCutShort = false;
  const PressedPoint pressed = point < this->State.Block.Kept
    ? PressedPoint()
    : FindPressing(this->State.Grid, mesh.Corners, mesh.Points, point, PressedShare * tolerance);
  if (pressed.Axis < 0)
  {
    return false;
  }
  PointStar& star = this->Stars[0];
  star.Set(mesh.Corners, mesh.Points, point);
  for (const double share : Lifts)
  {
    Point3 place = this->State.At(point);
    place[pressed.Axis] += share * pressed.Way * tolerance;
    place = this->State.MoveIntoBounds(point, place);
    double quality = 1.0;
    found = { LocalOperation::Kind::Move, -1, point, place, 0.0 };
    if (star.Try({ place, -1, 0.0, AnyTurn }, quality) &&
      quality >= std::min(star.Quality, LeastQuality) && this->IsNear(star) &&
      this->State.Block.HasInside(place) && this->IsAllowed(found))
    {
      std::swap(found.Change, this->Change);
      return true;
    }
  }
  return false;
}

bool OperationFinder::FindUnfolding(Index corner, LocalOperation& found)
{
  this->IsCutShort = false;
  this->ListUnfolding(corner);
  for (Unfolding& unfolding : this->Unfoldings)
  {
    if (this->IsAllowed(unfolding.Operation))
    {
      found = std::move(unfolding.Operation);
      std::swap(found.Change, this->Change);
      return true;
    }
  }
  return false;
}
}
