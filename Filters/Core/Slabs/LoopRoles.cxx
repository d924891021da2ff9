// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/LoopRoles.h"

#include "Core/Base/Vectors.h"
#include "Core/Slabs/SlabPieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace orthoslices
{
namespace
{
/// The centre of the area of a polygon.
Point2 CentroidOf(const std::vector<Point2>& points)
{
  const Point2 origin = points.front();
  Point2 sum{ 0.0, 0.0 };
  double twice = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point2 p = points[i] - origin;
    const Point2 q = points[(i + 1) % points.size()] - origin;
    sum = sum + Cross(p, q) * (p + q);
    twice += Cross(p, q);
  }
  return twice != 0.0 ? origin + (1.0 / (3.0 * twice)) * sum : origin;
}
}

LoopRoles::LoopRoles(const std::vector<SlabLoop>& loops)
  : Loops(loops)
  , Nesting(FindNesting(loops))
{
  for (const SlabLoop& loop : loops)
  {
    const double area = SignedArea(loop.Points);
    this->Holes.push_back(area < 0.0 ? 1 : 0);
    this->Areas.push_back(std::abs(area));
    this->Centers.push_back(CentroidOf(loop.Points));
  }
}

Index LoopRoles::FindAround(Index member) const
{
  const SlabLoop& loop = this->Loops[member];
  Index around = -1;
  for (Index other = 0; other < static_cast<Index>(this->Loops.size()); ++other)
  {
    const SlabLoop& outline = this->Loops[other];
    if (outline.Upper != loop.Upper && this->Areas[other] > this->Areas[member] &&
      (around < 0 || this->Areas[other] < this->Areas[around]) &&
      IsInside(outline.Points, loop.Points.front()))
    {
      around = other;
    }
  }
  return around;
}

LoopRoles::Members LoopRoles::ChildrenOf(Index parent, const Members& members, bool upper) const
{
  Members children;
  for (const Index member : members)
  {
    Index around = this->Nesting[member];
    while (around >= 0 && !std::binary_search(members.begin(), members.end(), around))
    {
      around = this->Nesting[around];
    }
    if (around == parent && this->Loops[member].Upper == upper)
    {
      children.push_back(member);
    }
  }
  return children;
}

Index LoopRoles::DepthOf(Index member, const Members& members) const
{
  Index depth = 0;
  for (Index around = this->Nesting[member]; around >= 0; around = this->Nesting[around])
  {
    depth += std::binary_search(members.begin(), members.end(), around) ? 1 : 0;
  }
  return depth;
}

Index LoopRoles::FindNearest(Index member, const Members& members) const
{
  Index nearest = -1;
  double least = HUGE_VAL;
  for (const Index other : members)
  {
    const Point2 d = this->Centers[other] - this->Centers[member];
    if (this->Loops[other].Upper != this->Loops[member].Upper &&
      this->IsHole(other) == this->IsHole(member) && Dot(d, d) < least)
    {
      least = Dot(d, d);
      nearest = other;
    }
  }
  return nearest;
}

bool LoopRoles::PairOff(const Members& lower, const Members& upper, const Point2& shift,
  std::vector<Members>& pairs) const
{
  if (lower.size() != upper.size())
  {
    return false;
  }
  std::vector<std::tuple<double, Index, Index>> costs;
  for (const Index a : lower)
  {
    for (const Index b : upper)
    {
      const Point2 d = (this->Centers[b] - shift) - this->Centers[a];
      const double growth = std::sqrt(this->Areas[a]) - std::sqrt(this->Areas[b]);
      costs.emplace_back(Dot(d, d) + growth * growth, a, b);
    }
  }
  std::sort(costs.begin(), costs.end());
  std::map<Index, Index> partner;
  for (const auto& [cost, a, b] : costs)
  {
    if (partner.count(a) == 0 && partner.count(b) == 0 && this->IsHole(a) == this->IsHole(b))
    {
      partner[a] = b;
      partner[b] = a;
      pairs.push_back({ a, b });
    }
  }
  return partner.size() == lower.size() + upper.size();
}
}
