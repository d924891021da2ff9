// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/GraftPatch.h"

#include "Core/Base/Vectors.h"
#include "Core/Cells/TubePatch.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// The share of its length at which a tube has its ring: half-way leaves most room on both sides.
constexpr double RingShare = 0.5;
/// Height of arches between points of one face, as a part of their distance: so low that they stay
/// below the rest of the tube. Chosen by hand.
constexpr double ArchHeight = 0.05;
/// Pairs of triangles and points of a border up to which all distances are measured, which is a
/// matter of milliseconds; where there are more pairs, points are left out.
constexpr std::size_t MaxPairs = std::size_t(1) << 22;
/// By so many ranks the triangle to be cut out moves on from one attempt to the next but one: where
/// one triangle is of no use, its neighbours are likely not to be, either. Chosen by hand.
constexpr std::size_t RankStep = 4;

using PatchTriangles = std::vector<std::array<Index, 3>>;

/// A triangle of a patch, or the border of a cycle without one.
struct TubeEnd
{
  PatchCurve Curve;
  Point3 Center;
  Point3 Area; ///< its normal, outwards; of any length
};

class Grafter
{
public:
  Grafter(const CycleGeometry& geometry, const std::vector<PatchMesh>& parts, std::size_t attempt);

  bool Connect(Index first, Index second);
  PatchMesh Take();

private:
  std::size_t PlaceOf(Index cycle) const;
  TubeEnd TriangleAsEnd(const std::array<Index, 3>& triangle) const;
  TubeEnd CycleAsEnd(std::size_t cycle) const;
  std::vector<std::size_t> RankTriangles(
    const PatchTriangles& triangles, const TubeEnd& goal, bool goalIsFixed) const;
  bool CutOut(std::size_t part, const TubeEnd& goal, bool goalIsFixed, TubeEnd& end);

  std::vector<Index> Cycles;
  TubePatch Patch;
  std::vector<std::size_t> PartOf;       ///< of each cycle
  std::vector<PatchTriangles> Triangles; ///< of each part
  std::size_t Attempt;
};

std::vector<Index> AllCycles(const std::vector<PatchMesh>& parts)
{
  std::vector<Index> cycles;
  for (const PatchMesh& part : parts)
  {
    cycles.insert(cycles.end(), part.Cycles.begin(), part.Cycles.end());
  }
  std::sort(cycles.begin(), cycles.end());
  return cycles;
}

/// Takes over points and triangles of the parts, with the corners of the whole.
Grafter::Grafter(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& parts, std::size_t attempt)
  : Cycles(AllCycles(parts))
  , Patch(geometry, this->Cycles)
  , PartOf(this->Cycles.size())
  , Triangles(parts.size())
  , Attempt(attempt)
{
  std::vector<Index> places;
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    places.clear();
    for (const Index cycle : parts[part].Cycles)
    {
      this->PartOf[this->PlaceOf(cycle)] = part;
      const std::vector<Index>& corners = this->Patch.BorderOf(this->PlaceOf(cycle)).Corners;
      places.insert(places.end(), corners.begin(), corners.end());
    }
    std::vector<Point3>& points = this->Patch.Mesh.Points;
    const Index before = static_cast<Index>(points.size());
    points.insert(points.end(), parts[part].Points.begin(), parts[part].Points.end());
    this->Triangles[part] = parts[part].Triangles;
    for (auto& triangle : this->Triangles[part])
    {
      for (Index& corner : triangle)
      {
        corner = corner >= 0 ? places[corner] : corner - before;
      }
    }
  }
}

std::size_t Grafter::PlaceOf(Index cycle) const { return PlaceIn(this->Cycles, cycle); }

TubeEnd Grafter::TriangleAsEnd(const std::array<Index, 3>& triangle) const
{
  TubeEnd end;
  end.Curve.Corners.assign(triangle.begin(), triangle.end());
  for (const Index corner : triangle)
  {
    end.Curve.Points.push_back(this->Patch.PointAt(corner));
  }
  const auto& p = end.Curve.Points;
  end.Center = (1.0 / 3.0) * (p[0] + p[1] + p[2]);
  end.Area = Cross(p[1] - p[0], p[2] - p[0]);
  return end;
}

TubeEnd Grafter::CycleAsEnd(std::size_t cycle) const
{
  TubeEnd end;
  end.Curve = this->Patch.BorderOf(cycle);
  const auto& p = end.Curve.Points;
  end.Center = { 0.0, 0.0, 0.0 };
  end.Area = { 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    end.Center = end.Center + (1.0 / static_cast<double>(p.size())) * p[i];
    end.Area = end.Area + Cross(p[i] - p[0], p[(i + 1) % p.size()] - p[0]);
  }
  return end;
}

/// How far a point is from a curve, at each step-th of its points.
double SquaredDistanceTo(const PatchCurve& curve, const Point3& point, std::size_t step)
{
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.Points.size(); i += step)
  {
    minimum = std::min(minimum, SquaredDistance(point, curve.Points[i]));
  }
  return minimum;
}

/// The triangles of a part, the best to be cut out first: near the goal and facing it. If the goal
/// is fixed, it has to face the triangle, too: outside or inside lies between both.
std::vector<std::size_t> Grafter::RankTriangles(
  const PatchTriangles& triangles, const TubeEnd& goal, bool goalIsFixed) const
{
  const std::size_t step = 1 + triangles.size() * goal.Curve.Points.size() / MaxPairs;
  std::vector<std::pair<double, std::size_t>> costs;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const TubeEnd candidate = this->TriangleAsEnd(triangles[i]);
    const Point3 line = goal.Center - candidate.Center;
    const double cosine = Dot(Unit(candidate.Area), Unit(line));
    if (!goalIsFixed || (cosine > 0.0) == (Dot(goal.Area, line) < 0.0))
    {
      const double distance2 = SquaredDistanceTo(goal.Curve, candidate.Center, step);
      costs.emplace_back(this->Attempt % 2 == 0 ? distance2 / (cosine * cosine) : distance2, i);
    }
  }
  std::sort(costs.begin(), costs.end());
  std::vector<std::size_t> ranked;
  for (const auto& cost : costs)
  {
    ranked.push_back(cost.second);
  }
  return ranked;
}

/// Takes a triangle out of a part.
bool Grafter::CutOut(std::size_t part, const TubeEnd& goal, bool goalIsFixed, TubeEnd& end)
{
  PatchTriangles& triangles = this->Triangles[part];
  const std::vector<std::size_t> ranked = this->RankTriangles(triangles, goal, goalIsFixed);
  const std::size_t rank = this->Attempt / 2 * RankStep;
  if (rank >= ranked.size())
  {
    return false;
  }
  end = this->TriangleAsEnd(triangles[ranked[rank]]);
  triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(ranked[rank]));
  return true;
}

/// Makes one part of the two that the cycles belong to.
bool Grafter::Connect(Index first, Index second)
{
  std::size_t a = this->PartOf[this->PlaceOf(first)];
  std::size_t b = this->PartOf[this->PlaceOf(second)];
  if (this->Triangles[a].empty())
  {
    std::swap(a, b);
    std::swap(first, second);
  }
  TubeEnd from;
  TubeEnd to = this->CycleAsEnd(this->PlaceOf(second));
  if (!this->Triangles[b].empty() &&
    !this->CutOut(b, this->CycleAsEnd(this->PlaceOf(first)), false, to))
  {
    return false;
  }
  if (!this->CutOut(a, to, true, from))
  {
    return false;
  }
  std::reverse(to.Curve.Corners.begin(), to.Curve.Corners.end());
  std::reverse(to.Curve.Points.begin(), to.Curve.Points.end());
  this->Patch.AddTube(
    from.Curve, to.Curve, PairPoints(from.Curve, to.Curve), RingShare, ArchHeight);
  std::replace(this->PartOf.begin(), this->PartOf.end(), b, a);
  PatchTriangles& joined = this->Triangles[a];
  joined.insert(joined.end(), this->Triangles[b].begin(), this->Triangles[b].end());
  joined.insert(joined.end(), this->Patch.Mesh.Triangles.begin(), this->Patch.Mesh.Triangles.end());
  this->Triangles[b].clear();
  this->Patch.Mesh.Triangles.clear();
  return true;
}

PatchMesh Grafter::Take()
{
  this->Patch.Mesh.Kind = PatchKind::Grafted;
  this->Patch.Mesh.Triangles = this->Triangles[this->PartOf.front()];
  return std::move(this->Patch.Mesh);
}
}

PatchMesh GraftPatches(const CycleGeometry& geometry, const std::vector<PatchMesh>& parts,
  const std::vector<std::pair<Index, Index>>& joins, std::size_t attempt)
{
  Grafter grafter(geometry, parts, attempt);
  for (const auto& join : joins)
  {
    if (!grafter.Connect(join.first, join.second))
    {
      return PatchMesh();
    }
  }
  return grafter.Take();
}
}
