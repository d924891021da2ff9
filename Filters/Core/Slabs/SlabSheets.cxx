// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/SlabSheets.h"

#include "Core/Base/DisjointSets.h"
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
/// A wall of which less than this share lies above itself in the next slice has moved by about its
/// thickness: an opening that the overlay shows in it comes from that.
constexpr double MaxCommonShareOfMovedWall = 0.5;

/// What appears in the hole of a ring that ends is the ring's continuation only if it fills at
/// least this share of the hole; else it is another body.
constexpr double MinShareOfHole = 0.1;

constexpr double Pi = 3.14159265358979323846;

/// Two lids become a tube if their middles are closer together than so many times the sum of the
/// radii of circles of their areas: then the gap between them is no wider than they are themselves.
constexpr double MaxRadiiApart = 2.0;

/// And if the line between the middles is no farther from the axis: by its tangent, for parts of the
/// solid (76 degrees) and for holes (65 degrees), which make a handle and so need more evidence.
constexpr double MaxSlopeOfPart = 4.0, MaxSlopeOfHole = 2.14;

/// And if one has at most so many times the area of the other, twice its radius.
constexpr double MaxRatioOfAreas = 4.0;

class SheetPlanner
{
public:
  SheetPlanner(const SlabGroup& group, double width)
    : Group(group)
    , Width(width)
    , Pieces(DescribePieces(group))
    , Sets(static_cast<Index>(group.Loops.size()))
  {
  }

  std::vector<SheetPlan> Run();

private:
  using Members = std::vector<Index>;

  bool IsLid(const SlabPiece& piece, bool upper) const
  {
    return piece.Loops.size() == 1 && this->Group.Outlines[piece.Loops.front()].Upper == upper;
  }
  static bool IsSuspect(const SlabPiece& piece) { return piece.Handles > 0 || piece.Mixed; }
  bool IsHoleAt(Index member) const { return this->Holes[member] != 0; }
  void DescribeLoops();
  void UniteRegions();
  void UniteRingsThatEnd();
  Index FindAround(Index member) const;
  bool Plan(const Members& members, SheetPlan& plan);
  Index FindNearest(Index member, const Members& lids) const;
  void PairLids(std::vector<SheetPlan>& plans) const;
  bool PairNested(const Members& lower, const Members& upper, const Point2& shift,
    std::vector<Members>& pairs) const;
  bool PlanByDepth(const Members& members, SheetPlan& plan) const;
  Members ChildrenOf(Index parent, const Members& members, bool upper) const;
  Index DepthOf(Index member, const Members& members) const;

  const SlabGroup& Group;
  const double Width;
  std::vector<SlabPiece> Pieces;
  DisjointSets Sets; ///< of loops
  std::vector<Index> Nesting;
  std::vector<std::uint8_t> Holes;
  std::vector<double> Areas; ///< without sign
  std::vector<Point2> Centers;
};

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

void SheetPlanner::DescribeLoops()
{
  this->Nesting = FindNesting(this->Group.Outlines);
  for (const SlabLoop& loop : this->Group.Outlines)
  {
    const double area = SignedArea(loop.Points);
    this->Holes.push_back(area < 0.0 ? 1 : 0);
    this->Areas.push_back(std::abs(area));
    this->Centers.push_back(CentroidOf(loop.Points));
  }
}

/// The contours of a piece, and those that bound the same part of the solid in a slice.
void SheetPlanner::UniteRegions()
{
  for (const SlabPiece& piece : this->Pieces)
  {
    for (const Index member : piece.Loops)
    {
      this->Sets.Unite(piece.Loops.front(), member);
    }
  }
  for (Index member = 0; member < static_cast<Index>(this->Nesting.size()); ++member)
  {
    if (this->IsHoleAt(member) && this->Nesting[member] >= 0)
    {
      this->Sets.Unite(member, this->Nesting[member]);
    }
  }
}

/// The smallest loop of the other slice around a loop that crosses none of that slice; -1 without.
Index SheetPlanner::FindAround(Index member) const
{
  const SlabLoop& loop = this->Group.Outlines[member];
  Index around = -1;
  for (Index other = 0; other < static_cast<Index>(this->Group.Outlines.size()); ++other)
  {
    const SlabLoop& outline = this->Group.Outlines[other];
    if (outline.Upper != loop.Upper && this->Areas[other] > this->Areas[member] &&
      (around < 0 || this->Areas[other] < this->Areas[around]) &&
      IsInside(outline.Points, loop.Points.front()))
    {
      around = other;
    }
  }
  return around;
}

/// A ring that ends, and a part of the solid that begins within its hole: a wall that has moved by
/// more than its thickness.
void SheetPlanner::UniteRingsThatEnd()
{
  std::vector<Index> pieceOf(this->Nesting.size(), -1);
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    for (const Index member : this->Pieces[i].Loops)
    {
      pieceOf[member] = static_cast<Index>(i);
    }
  }
  for (const SlabPiece& piece : this->Pieces)
  {
    for (const Index member : piece.Loops)
    {
      if (piece.Across || this->IsHoleAt(member))
      {
        continue;
      }
      const Index hole = this->FindAround(member);
      if (hole >= 0 && this->IsHoleAt(hole) && this->Pieces[pieceOf[hole]].Mixed &&
        !this->Pieces[pieceOf[hole]].Across &&
        this->Areas[member] >= MinShareOfHole * this->Areas[hole])
      {
        this->Sets.Unite(member, hole);
      }
    }
  }
}

/// The outermost of these loops on a slice, or those directly inside one of them.
SheetPlanner::Members SheetPlanner::ChildrenOf(
  Index parent, const Members& members, bool upper) const
{
  Members children;
  for (const Index member : members)
  {
    Index around = this->Nesting[member];
    while (around >= 0 && !std::binary_search(members.begin(), members.end(), around))
    {
      around = this->Nesting[around];
    }
    if (around == parent && this->Group.Outlines[member].Upper == upper)
    {
      children.push_back(member);
    }
  }
  return children;
}

/// Pairs loops one to one, the closest first, after moving the upper ones back by a shift, and what
/// is inside them. False if that is not possible.
bool SheetPlanner::PairNested(const Members& lower, const Members& upper, const Point2& shift,
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
    if (partner.count(a) == 0 && partner.count(b) == 0 && this->IsHoleAt(a) == this->IsHoleAt(b))
    {
      partner[a] = b;
      partner[b] = a;
      pairs.push_back({ a, b });
    }
  }
  return partner.size() == lower.size() + upper.size();
}

Index SheetPlanner::DepthOf(Index member, const Members& members) const
{
  Index depth = 0;
  for (Index around = this->Nesting[member]; around >= 0; around = this->Nesting[around])
  {
    depth += std::binary_search(members.begin(), members.end(), around) ? 1 : 0;
  }
  return depth;
}

/// Loops of one depth together.
bool SheetPlanner::PlanByDepth(const Members& members, SheetPlan& plan) const
{
  std::map<Index, Members> byDepth;
  for (const Index member : members)
  {
    byDepth[this->DepthOf(member, members)].push_back(member);
  }
  bool onBoth = true;
  for (const auto& [depth, loops] : byDepth)
  {
    const auto isUpper = [&](Index member) { return this->Group.Outlines[member].Upper; };
    const auto isHole = [&](Index member) { return this->IsHoleAt(member); };
    const auto upper = std::count_if(loops.begin(), loops.end(), isUpper);
    const auto holes = std::count_if(loops.begin(), loops.end(), isHole);
    const auto count = static_cast<std::ptrdiff_t>(loops.size());
    if (holes != 0 && holes != count)
    {
      return false; // the outermost ones of this group are holes of one slice only
    }
    onBoth = onBoth && upper > 0 && upper < count;
    plan.Sheets.push_back(loops);
  }
  return plan.Sheets.size() > 1 && (onBoth || plan.MayPart);
}

bool SheetPlanner::Plan(const Members& members, SheetPlan& plan)
{
  plan.Loops = members;
  const Members lower = this->ChildrenOf(-1, members, false);
  const Members upper = this->ChildrenOf(-1, members, true);
  if (lower.empty() || upper.empty())
  {
    return false;
  }
  bool isMixed = false;
  for (const SlabPiece& piece : this->Pieces)
  {
    if (std::binary_search(members.begin(), members.end(), piece.Loops.front()))
    {
      plan.Faults += piece.Handles + (piece.Mixed ? 1 : 0);
      isMixed = isMixed || piece.Mixed;
    }
  }
  plan.MayPart = !isMixed || CommonShare(this->Group, members) < MaxCommonShareOfMovedWall;
  plan.InPairs = this->PairNested(lower, upper, { 0.0, 0.0 }, plan.Sheets);
  for (std::size_t i = 0; plan.InPairs && i < plan.Sheets.size(); ++i)
  {
    const Index a = plan.Sheets[i][0];
    const Index b = plan.Sheets[i][1];
    plan.InPairs = this->PairNested(this->ChildrenOf(a, members, false),
      this->ChildrenOf(b, members, true), this->Centers[b] - this->Centers[a], plan.Sheets);
  }
  if (plan.InPairs)
  {
    return true;
  }
  plan.Sheets.clear();
  return this->PlanByDepth(members, plan);
}

/// The lid of the other slice whose loop is nearest, of one role; -1 without.
Index SheetPlanner::FindNearest(Index member, const Members& lids) const
{
  Index nearest = -1;
  double least = HUGE_VAL;
  for (const Index other : lids)
  {
    const Point2 d = this->Centers[other] - this->Centers[member];
    if (this->Group.Outlines[other].Upper != this->Group.Outlines[member].Upper &&
      this->IsHoleAt(other) == this->IsHoleAt(member) && Dot(d, d) < least)
    {
      least = Dot(d, d);
      nearest = other;
    }
  }
  return nearest;
}

/// Tubes instead of two lids each: what runs aslant through the slab.
void SheetPlanner::PairLids(std::vector<SheetPlan>& plans) const
{
  Members lids;
  for (const SlabPiece& piece : this->Pieces)
  {
    const bool isPlanned = std::any_of(plans.begin(), plans.end(),
      [&](const SheetPlan& plan)
      { return std::binary_search(plan.Loops.begin(), plan.Loops.end(), piece.Loops.front()); });
    if (piece.Loops.size() == 1 && !isPlanned)
    {
      lids.push_back(piece.Loops.front());
    }
  }
  for (const Index member : lids)
  {
    const Index other = this->FindNearest(member, lids);
    if (other < member || this->FindNearest(other, lids) != member)
    {
      continue; // each pair once
    }
    const auto [smaller, larger] = std::minmax({ this->Areas[member], this->Areas[other] });
    const Point2 d = this->Centers[other] - this->Centers[member];
    const double radii = std::sqrt(smaller / Pi) + std::sqrt(larger / Pi);
    const double slope = this->IsHoleAt(member) ? MaxSlopeOfHole : MaxSlopeOfPart;
    const double reach = std::min(MaxRadiiApart * radii, slope * this->Width);
    if (larger <= MaxRatioOfAreas * smaller && Dot(d, d) <= reach * reach)
    {
      SheetPlan plan;
      plan.Loops = { member, other };
      plan.Sheets = { plan.Loops };
      plan.Depth = { 0 };
      plan.InPairs = true;
      plan.Faults = 1;
      plans.push_back(std::move(plan));
    }
  }
}

std::vector<SheetPlan> SheetPlanner::Run()
{
  const auto isLid = [&](bool upper)
  {
    return std::any_of(this->Pieces.begin(), this->Pieces.end(),
      [&](const SlabPiece& piece) { return this->IsLid(piece, upper); });
  };
  if (std::none_of(this->Pieces.begin(), this->Pieces.end(), IsSuspect) &&
    !(isLid(false) && isLid(true)))
  {
    return {};
  }
  this->DescribeLoops();
  this->UniteRegions();
  this->UniteRingsThatEnd();
  std::map<Index, Members> groups; // those with a suspect piece
  for (const SlabPiece& piece : this->Pieces)
  {
    if (IsSuspect(piece))
    {
      groups[this->Sets.Find(piece.Loops.front())];
    }
  }
  for (Index member = 0; member < static_cast<Index>(this->Nesting.size()); ++member)
  {
    const auto at = groups.find(this->Sets.Find(member));
    if (at != groups.end())
    {
      at->second.push_back(member);
    }
  }
  std::vector<SheetPlan> plans;
  for (const auto& group : groups)
  {
    SheetPlan plan;
    if (this->Plan(group.second, plan))
    {
      for (const Members& sheet : plan.Sheets)
      {
        plan.Depth.push_back(this->DepthOf(sheet.front(), plan.Loops));
      }
      plans.push_back(std::move(plan));
    }
  }
  this->PairLids(plans);
  return plans;
}
}

std::vector<SheetPlan> PlanSheets(const SlabGroup& group, double width)
{
  return SheetPlanner(group, width).Run();
}
}
