// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
// What OperationFinder does about splits.
#include "Core/Improve/OperationFinder.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// A side is split if it is so many times as long as the shortest one of its triangle at least,
constexpr double LeastLengthOfSplit = 1.5;

/// so many times the length of the shortest side away from it: beside it comes a triangle whose
/// smallest angle is 31 degrees.
constexpr double StepOfSplit = 1.8;

/// Farther than this share of the side, it is split in the middle.
constexpr double MaxStep = 0.55;
}

/// Lists the sides of the two triangles at a corner's edge.
void OperationFinder::SpanCavity(Index corner)
{
  const Index across = this->State.Mesh.Corners.OppositeOf(corner);
  this->Cavity = { CornerTable::Next(corner), CornerTable::Previous(corner),
    CornerTable::Next(across), CornerTable::Previous(across) };
  this->Flipped.clear();
}

/// Takes the triangles behind those sides of the cavity that would be better diagonals from the
/// new point.
void OperationFinder::WidenCavity(const Point3& place)
{
  const CornerTable& corners = this->State.Mesh.Corners;
  const std::vector<Index> sides = this->Cavity;
  this->Cavity.clear();
  for (const Index side : sides)
  {
    const Index beyond = corners.OppositeOf(side);
    const Point3 &p = this->State.At(corners.StartOf(side)),
                 &q = this->State.At(corners.EndOf(side));
    const Point3& x = this->State.At(corners.VertexOf(beyond));
    const TriangleCorners near{ place, p, q }, first{ place, p, x }, second{ place, x, q };
    const double before = std::min(SquaredSine(near), this->State.QualityOf(beyond / 3));
    const Point3 around = AreaOf(near) + AreaOf({ p, x, q });
    const Point3 across = Cross(q - p, x - place);
    const double length = Length(across);
    const double shift = length > 0.0 ? std::abs(Dot(x - p, across)) / length : HUGE_VAL;
    const bool isNew = !corners.IsCurve(side) &&
      std::none_of(sides.begin(), sides.end(),
        [&](Index other)
        {
          return other / 3 == beyond / 3 ||
            (other != side && corners.OppositeOf(other) / 3 == beyond / 3);
        });
    if (isNew && std::min(SquaredSine(first), SquaredSine(second)) > LeastGain * before &&
      CosineBetween(AreaOf(first), around) >= this->State.LeastCosine &&
      CosineBetween(AreaOf(second), around) >= this->State.LeastCosine &&
      shift <= this->State.Samples.ToleranceOfSide(side / 3, beyond / 3) * this->State.Slack)
    {
      this->Flipped.push_back(side);
      this->Cavity.push_back(CornerTable::Previous(beyond));
      this->Cavity.push_back(CornerTable::Next(beyond));
    }
    else
    {
      this->Cavity.push_back(side);
    }
  }
}

/// Whether the border of the cavity passes each point once: else two sides would join the new point
/// with the same one.
bool OperationFinder::IsCavitySimple() const
{
  const CornerTable& corners = this->State.Mesh.Corners;
  const SheetBorders& borders = this->State.Mesh.Borders;
  for (std::size_t i = 0; i < this->Cavity.size(); ++i)
  {
    for (std::size_t k = 0; k < i; ++k)
    {
      if (borders.AreCopies(corners.StartOf(this->Cavity[i]), corners.StartOf(this->Cavity[k])))
      {
        return false;
      }
    }
  }
  return true;
}

/// Whether both ends of a corner's edge may.
bool OperationFinder::MayMove(Index corner) const
{
  const CornerTable& corners = this->State.Mesh.Corners;
  return std::min(corners.StartOf(corner), corners.EndOf(corner)) >= this->State.Block.Kept;
}

/// Looks at splits of the two longer sides of a triangle.
void OperationFinder::TrySplits(Index triangle, LocalOperation& best)
{
  const CornerTable& corners = this->State.Mesh.Corners;
  std::array<std::pair<double, Index>, 3> sides = this->SidesOf(triangle);
  const double shortest = std::sqrt(sides[0].first);
  if (this->State.IsShort(sides[0].second) && this->MayMove(sides[0].second))
  {
    return; // splits would make triangles as small as this side, and hundreds around them
  }
  for (const int i : { 2, 1 })
  {
    const double length = std::sqrt(sides[i].first);
    if (!(length > LeastLengthOfSplit * shortest))
    {
      continue;
    }
    const Index corner = sides[i].second;
    // As far from the shortest side as makes a good triangle beside it.
    const double step = StepOfSplit * shortest / length;
    const bool isAtEnd = corners.StartOf(corner) != corners.VertexOf(sides[0].second);
    this->TrySplit(corner, step > MaxStep ? 0.5 : isAtEnd ? step : 1.0 - step, best);
  }
}

/// Looks at a point on a corner's side, at that share of its length, as a corner of all triangles
/// around it.
void OperationFinder::TrySplit(Index corner, double share, LocalOperation& best)
{
  const CornerTable& corners = this->State.Mesh.Corners;
  if (corners.IsCurve(corner))
  {
    return;
  }
  const Index across = corners.OppositeOf(corner);
  const Index start = corners.StartOf(corner), end = corners.EndOf(corner);
  const Point3 place = Between(this->State.At(start), this->State.At(end), share);
  LocalOperation split{ LocalOperation::Kind::Split, corner, -1,
    this->State.MoveIntoBounds(start, place), 0.0 };
  if (this->WasRefused(split))
  {
    return;
  }
  if (!this->State.Block.HasInside(split.Place))
  {
    this->IsCutShort = true;
    return;
  }
  this->SpanCavity(corner);
  this->WidenCavity(split.Place);
  if (!this->IsCavitySimple())
  {
    return;
  }
  double before = std::min(this->State.QualityOf(corner / 3), this->State.QualityOf(across / 3));
  double after = GoodEnough;
  for (const Index side : this->Cavity)
  {
    before = std::min(before, this->State.QualityOf(side / 3));
    after = std::min(after,
      SquaredSine({ split.Place, this->State.At(corners.StartOf(side)),
        this->State.At(corners.EndOf(side)) }));
  }
  if (after > std::max(best.Quality, LeastGain * before))
  {
    split.Quality = after;
    split.Sides = this->Cavity;
    split.Flipped = this->Flipped;
    best = split;
  }
}
}
