// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/JoinPatch.h"

#include "Core/Base/Vectors.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Height of arches between points of one face, as a part of their distance: that of half a circle.
constexpr double HalfCircle = 0.5;
/// How far the point of a bridge between two curves lies on the way to the curve that the tube
/// leads to: short of half-way, where the ring lies, so that both stay apart. Chosen by hand.
constexpr double BridgeLean = 0.4;

/// 0 for cycles at an even distance from the first one in the tree, 1 for the others.
std::vector<std::uint8_t> Colour(
  const std::vector<Index>& cycles, const std::vector<std::pair<Index, Index>>& joins)
{
  constexpr std::uint8_t none = 2;
  std::vector<std::uint8_t> colours(cycles.size(), none);
  const auto colour = [&](Index cycle) -> std::uint8_t& { return colours[PlaceIn(cycles, cycle)]; };
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
void Bridge(const PatchCurve& other, const PatchCurve& goal, PatchCurve& curve, TubePatch& patch)
{
  const PointPair nearest = FindNearestOnBorders(curve, other);
  const Point3 middle = Between(curve.Points[nearest.First], other.Points[nearest.Second], 0.5);
  Point3 target = middle;
  double minimum = std::numeric_limits<double>::infinity();
  for (const Point3& point : goal.Points)
  {
    const double distance2 = SquaredDistance(middle, point);
    if (distance2 < minimum)
    {
      minimum = distance2;
      target = point;
    }
  }
  const Index bridge = patch.AddPoint(Between(middle, target, BridgeLean));
  PatchCurve joined;
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
      add(bridge, patch.Mesh.Points.back());
      for (Index k = 0; k <= other.Count(); ++k)
      {
        const Index j = (nearest.Second + k) % other.Count();
        add(other.Corners[j], other.Points[j]);
      }
      add(bridge, patch.Mesh.Points.back());
      add(curve.Corners[i], curve.Points[i]);
    }
  }
  curve = std::move(joined);
}

/// Makes one curve of all of one side, always with the nearest one to what has been joined already.
void BridgeAll(const PatchCurve& goal, std::vector<PatchCurve>& curves, TubePatch& patch)
{
  while (curves.size() > 1)
  {
    std::size_t next = 1;
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < curves.size(); ++k)
    {
      const double distance2 = FindNearestOnBorders(curves.front(), curves[k]).Distance2;
      next = distance2 < minimum ? k : next;
      minimum = std::min(minimum, distance2);
    }
    const PatchCurve other = curves[next];
    Bridge(other, goal, curves.front(), patch);
    curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(next));
  }
}
}

JoinedPatchBuilder::JoinedPatchBuilder(const CycleGeometry& geometry,
  const std::vector<Index>& cycles, const std::vector<std::pair<Index, Index>>& joins)
  : Bridged(geometry, cycles)
{
  const std::vector<std::uint8_t> colours = Colour(cycles, joins);
  std::array<std::vector<PatchCurve>, 2> sides;
  for (std::size_t i = 0; i < cycles.size(); ++i)
  {
    sides[colours[i] == 1 ? 1 : 0].push_back(this->Bridged.BorderOf(i));
  }
  for (int side = 0; side < 2; ++side)
  {
    BridgeAll(sides[1 - side].front(), sides[side], this->Bridged);
  }
  this->First = std::move(sides[0].front());
  this->Second = std::move(sides[1].front());
  std::reverse(this->Second.Corners.begin(), this->Second.Corners.end());
  std::reverse(this->Second.Points.begin(), this->Second.Points.end());
  this->Pairs = PairPoints(this->First, this->Second);
}

PatchMesh JoinedPatchBuilder::Build(double share) const
{
  TubePatch patch = this->Bridged;
  patch.AddTube(this->First, this->Second, this->Pairs, share, HalfCircle);
  return std::move(patch.Mesh);
}

PatchMesh BuildJoinedPatch(const CycleGeometry& geometry, const std::vector<Index>& cycles,
  const std::vector<std::pair<Index, Index>>& joins, double share)
{
  return JoinedPatchBuilder(geometry, cycles, joins).Build(share);
}
}
