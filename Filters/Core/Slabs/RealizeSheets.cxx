// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/RealizeSheets.h"

#include "Core/Base/Vectors.h"
#include "Core/Cells/FindContacts.h"
#include "Core/Slabs/SlabPieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace orthoslices
{
namespace
{
/// Own points of an overlay lie at half height. A sheet inside another one must stay farther from
/// it: lower where the solid ends between the slices, higher where it begins. Tried one after
/// another: the height of the outermost sheet, and what it is multiplied by for each loop of the
/// plan around a sheet.
struct SheetHeights
{
  double Outermost, Share;
};
constexpr std::array<SheetHeights, 5> Heights{ { { 0.5, 1.0 }, { 0.5, 0.4 }, { 0.5, 0.1 },
  { 0.8, 0.1 }, { 0.95, 0.05 } } };

class SheetMaker
{
public:
  SheetMaker(SlabGroup&& whole, double width)
    : Width(width)
    , Rest(std::move(whole))
    , IsTaken(Rest.Loops.size(), 0)
    , All(Rest)
  {
  }

  void TryPlan(const SheetPlan& plan);
  std::vector<SlabGroup> Take();

private:
  using Groups = std::vector<SlabGroup>;

  SlabGroup Select(const std::vector<Index>& members, const Point2& shift) const;
  std::vector<Point2> ListShifts(const SheetPlan& plan) const;
  Groups OverlaySheets(const SheetPlan& plan, const Point2& shift) const;
  bool IsAsPlanned(const SheetPlan& plan, const Groups& groups) const;
  bool Accept(const SheetPlan& plan, Groups&& groups);
  bool AreApart(const Groups& groups) const;
  void AddTriangles(const SlabGroup& group, Index patch, Index& nextId,
    std::vector<PatchTriangle>& triangles) const;

  const double Width;
  SlabGroup Rest; ///< loops for which no plan has been carried out
  std::vector<std::uint8_t> IsTaken;
  const SlabGroup All;
  Groups Done;
};

/// Some of the loops, overlaid by themselves.
SlabGroup SheetMaker::Select(const std::vector<Index>& members, const Point2& shift) const
{
  SlabGroup group{ this->All.Slab, {}, {}, shift, {} };
  bool allHoles = true;
  for (const Index member : members)
  {
    group.Loops.push_back(this->All.Loops[member]);
    group.Outlines.push_back(this->All.Outlines[member]);
    allHoles = allHoles && IsHole(group.Outlines.back());
  }
  group.Overlay = allHoles && !members.empty() ? OverlayHoles(group.Outlines, shift)
                                               : OverlaySlab(group.Outlines, shift);
  return group;
}

/// None, and those that bring the middles of the first sheet's loops above each other.
std::vector<Point2> SheetMaker::ListShifts(const SheetPlan& plan) const
{
  std::vector<Point2> shifts{ { 0.0, 0.0 } };
  std::vector<SlabLoop> loops;
  for (const Index member : plan.Sheets.front())
  {
    loops.push_back(this->All.Outlines[member]);
  }
  for (const auto& middleOf : { MiddleOfCurves, MiddleOfBox })
  {
    shifts.push_back(middleOf(loops, true) - middleOf(loops, false));
  }
  return shifts;
}

SheetMaker::Groups SheetMaker::OverlaySheets(const SheetPlan& plan, const Point2& shift) const
{
  Groups groups;
  for (const std::vector<Index>& sheet : plan.Sheets)
  {
    groups.push_back(this->Select(sheet, shift));
  }
  return groups;
}

/// Whether the overlays have the topology that is planned.
bool SheetMaker::IsAsPlanned(const SheetPlan& plan, const Groups& groups) const
{
  Index faults = 0;
  for (const SlabGroup& group : groups)
  {
    if (!group.Overlay.Valid)
    {
      return false;
    }
    for (const SlabPiece& piece : DescribePieces(group))
    {
      faults += piece.Handles + (piece.Mixed ? 1 : 0);
      if (!plan.InPairs)
      {
        continue;
      }
      std::vector<Index> loops;
      for (const Index loop : piece.Loops)
      {
        loops.push_back(group.Loops[loop]);
      }
      const bool isPlanned = std::any_of(plan.Sheets.begin(), plan.Sheets.end(),
        [&](const std::vector<Index>& sheet)
        {
          return sheet.size() == loops.size() &&
            std::is_permutation(sheet.begin(), sheet.end(), loops.begin(),
              [&](Index member, Index loop) { return this->All.Loops[member] == loop; });
        });
      if (!isPlanned || piece.Handles > 0)
      {
        return false;
      }
    }
  }
  return faults < plan.Faults;
}

/// The triangles of an overlay, for FindContacts.
void SheetMaker::AddTriangles(
  const SlabGroup& group, Index patch, Index& nextId, std::vector<PatchTriangle>& triangles) const
{
  std::vector<Point3> corners;
  const auto add = [&](const Point2& p, double level) {
    corners.push_back({ p[0], p[1], level * this->Width });
  };
  for (const SlabLoop& loop : group.Outlines)
  {
    for (const Point2& p : loop.Points)
    {
      add(p, loop.Upper ? 1.0 : 0.0);
    }
  }
  for (const SlabOverlay::Insertion& insertion : group.Overlay.Insertions)
  {
    const SlabLoop& loop = group.Outlines[insertion.Loop];
    const Point2& p = loop.Points[insertion.After];
    const Point2& q = loop.Points[(insertion.After + 1) % loop.Points.size()];
    add(p + insertion.Share * (q - p), loop.Upper ? 1.0 : 0.0);
  }
  for (const Point3& p : group.Overlay.Points)
  {
    add(Point2{ p[0], p[1] } + p[2] * group.Shift, p[2]);
  }
  for (const auto& [a, b, c] : group.Overlay.Triangles)
  {
    triangles.push_back(
      { patch, { corners[a], corners[b], corners[c] }, { nextId + a, nextId + b, nextId + c } });
  }
  nextId += static_cast<Index>(corners.size());
}

bool SheetMaker::AreApart(const Groups& groups) const
{
  std::vector<PatchTriangle> triangles;
  Index nextId = 0;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    this->AddTriangles(groups[i], static_cast<Index>(i), nextId, triangles);
  }
  const std::vector<PatchKind> kinds(groups.size(), PatchKind::Stitched);
  return FindContacts(triangles, kinds).empty();
}

/// Puts the overlay's own points at a distance from the slice in which there is a solid beside
/// them.
void SetHeight(double height, SlabOverlay& overlay)
{
  for (std::size_t i = 0; i < overlay.Points.size(); ++i)
  {
    overlay.Points[i][2] = overlay.Above[i] != 0 ? 1.0 - height : height;
  }
}

/// Takes overlays of the loops of a plan, if they meet nothing else.
bool SheetMaker::Accept(const SheetPlan& plan, Groups&& groups)
{
  std::vector<Index> others;
  for (Index member = 0; member < static_cast<Index>(this->IsTaken.size()); ++member)
  {
    if (this->IsTaken[member] == 0 &&
      !std::binary_search(plan.Loops.begin(), plan.Loops.end(), member))
    {
      others.push_back(member);
    }
  }
  Groups trial = this->Done;
  const std::size_t first = trial.size();
  std::move(groups.begin(), groups.end(), std::back_inserter(trial));
  const std::size_t last = trial.size();
  trial.push_back(this->Select(others, { 0.0, 0.0 }));
  if (!trial.back().Overlay.Valid)
  {
    return false;
  }
  for (const auto& [outermost, share] : Heights)
  {
    for (std::size_t i = first; i < last && last - first == plan.Sheets.size(); ++i)
    {
      SetHeight(outermost * std::pow(share, plan.Depth[i - first]), trial[i].Overlay);
    }
    if (this->AreApart(trial))
    {
      this->Rest = std::move(trial.back());
      trial.pop_back();
      this->Done = std::move(trial);
      for (const Index member : plan.Loops)
      {
        this->IsTaken[member] = 1;
      }
      return true;
    }
  }
  return false;
}

void SheetMaker::TryPlan(const SheetPlan& plan)
{
  for (const Point2& shift : this->ListShifts(plan))
  {
    if (shift != Point2{ 0.0, 0.0 })
    {
      Groups joint{ this->Select(plan.Loops, shift) };
      if (this->IsAsPlanned(plan, joint) && this->Accept(plan, std::move(joint)))
      {
        return;
      }
    }
    Groups sheets = plan.MayPart ? this->OverlaySheets(plan, shift) : Groups();
    if (plan.MayPart && this->IsAsPlanned(plan, sheets) && this->Accept(plan, std::move(sheets)))
    {
      return;
    }
  }
}

std::vector<SlabGroup> SheetMaker::Take()
{
  Groups result = std::move(this->Done);
  if (!this->Rest.Loops.empty())
  {
    result.insert(result.begin(), std::move(this->Rest));
  }
  return result;
}
}

std::vector<SlabGroup> RealizeSheets(
  SlabGroup&& whole, const std::vector<SheetPlan>& plans, double width)
{
  if (plans.empty())
  {
    std::vector<SlabGroup> groups;
    groups.push_back(std::move(whole));
    return groups;
  }
  SheetMaker maker(std::move(whole), width);
  for (const SheetPlan& plan : plans)
  {
    maker.TryPlan(plan);
  }
  return maker.Take();
}
}
