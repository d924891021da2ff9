// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/SlabSheets.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Base/Vectors.h"
#include "Core/Slabs/LoopRoles.h"
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

/// And if the line between the middles is no farther from the axis: by its tangent, for parts of
/// the solid (76 degrees) and for holes (65 degrees), which make a handle and so need more
/// evidence.
constexpr double MaxSlopeOfPart = 4.0, MaxSlopeOfHole = 2.14;

/// And if one has at most so many times the area of the other, twice its radius.
constexpr double MaxRatioOfAreas = 4.0;

/// Whether the piece may be other than its contours' roles want it.
bool IsSuspect(const SlabPiece& piece) { return piece.Handles > 0 || piece.Mixed; }

class SheetPlanner
{
public:
  SheetPlanner(const SlabGroup& group, double width, const std::vector<SlabPiece>& pieces)
    : Group(group)
    , Width(width)
    , Pieces(pieces)
    , Roles(group.Outlines)
    , Sets(static_cast<Index>(group.Loops.size()))
  {
  }

  std::vector<SheetPlan> Run();

private:
  using Members = LoopRoles::Members;

  void UniteRegions();
  void UniteRingsThatEnd();
  bool Plan(const Members& members, SheetPlan& plan);
  void PairLids(std::vector<SheetPlan>& plans) const;
  bool PlanByDepth(const Members& members, SheetPlan& plan) const;

  const SlabGroup& Group;
  const double Width;
  const std::vector<SlabPiece>& Pieces;
  const LoopRoles Roles;
  DisjointSets Sets; ///< of loops
};

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
  for (Index member = 0; member < static_cast<Index>(this->Group.Loops.size()); ++member)
  {
    if (this->Roles.IsHole(member) && this->Roles.ParentOf(member) >= 0)
    {
      this->Sets.Unite(member, this->Roles.ParentOf(member));
    }
  }
}

/// A ring that ends, and a part of the solid that begins within its hole: a wall that has moved by
/// more than its thickness.
void SheetPlanner::UniteRingsThatEnd()
{
  std::vector<Index> pieceOf(this->Group.Loops.size(), -1);
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
      if (piece.Across || this->Roles.IsHole(member))
      {
        continue;
      }
      const Index hole = this->Roles.FindAround(member);
      if (hole >= 0 && this->Roles.IsHole(hole) && this->Pieces[pieceOf[hole]].Mixed &&
        !this->Pieces[pieceOf[hole]].Across &&
        this->Roles.AreaOf(member) >= MinShareOfHole * this->Roles.AreaOf(hole))
      {
        this->Sets.Unite(member, hole);
      }
    }
  }
}

/// Loops of one depth together.
bool SheetPlanner::PlanByDepth(const Members& members, SheetPlan& plan) const
{
  std::map<Index, Members> byDepth;
  for (const Index member : members)
  {
    byDepth[this->Roles.DepthOf(member, members)].push_back(member);
  }
  bool onBoth = true;
  for (const auto& [depth, loops] : byDepth)
  {
    const auto isUpper = [&](Index member) { return this->Roles.IsUpper(member); };
    const auto isHole = [&](Index member) { return this->Roles.IsHole(member); };
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
  const Members lower = this->Roles.ChildrenOf(-1, members, false);
  const Members upper = this->Roles.ChildrenOf(-1, members, true);
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
  plan.InPairs = this->Roles.PairOff(lower, upper, { 0.0, 0.0 }, plan.Sheets);
  for (std::size_t i = 0; plan.InPairs && i < plan.Sheets.size(); ++i)
  {
    const Index a = plan.Sheets[i][0];
    const Index b = plan.Sheets[i][1];
    plan.InPairs = this->Roles.PairOff(this->Roles.ChildrenOf(a, members, false),
      this->Roles.ChildrenOf(b, members, true), this->Roles.CenterOf(b) - this->Roles.CenterOf(a),
      plan.Sheets);
  }
  if (plan.InPairs)
  {
    return true;
  }
  plan.Sheets.clear();
  return this->PlanByDepth(members, plan);
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
    const Index other = this->Roles.FindNearest(member, lids);
    if (other < member || this->Roles.FindNearest(other, lids) != member)
    {
      continue; // each pair once
    }
    const auto [smaller, larger] =
      std::minmax({ this->Roles.AreaOf(member), this->Roles.AreaOf(other) });
    const Point2 d = this->Roles.CenterOf(other) - this->Roles.CenterOf(member);
    const double radii = std::sqrt(smaller / Pi) + std::sqrt(larger / Pi);
    const double slope = this->Roles.IsHole(member) ? MaxSlopeOfHole : MaxSlopeOfPart;
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
  for (Index member = 0; member < static_cast<Index>(this->Group.Loops.size()); ++member)
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
        plan.Depth.push_back(this->Roles.DepthOf(sheet.front(), plan.Loops));
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
  const std::vector<SlabPiece> pieces = DescribePieces(group);
  std::array<bool, 2> hasLid{ false, false };
  for (const SlabPiece& piece : pieces)
  {
    hasLid[group.Outlines[piece.Loops.front()].Upper ? 1 : 0] |= piece.Loops.size() == 1;
  }
  // Most slabs have none of that.
  if ((hasLid[0] && hasLid[1]) || std::any_of(pieces.begin(), pieces.end(), IsSuspect))
  {
    return SheetPlanner(group, width, pieces).Run();
  }
  return {};
}
}
