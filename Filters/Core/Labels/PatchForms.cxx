// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/PatchForms.h"

#include "Core/Base/Vectors.h"
#include "Core/Labels/JunctionCurves.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace orthoslices
{
namespace
{
/// How far patches with a point of their own move it, as parts of the way from the common one to the
/// middle of their border, in the order in which that is tried.
constexpr std::array<double, 4> TriedWays{ 0.4, 0.15, 0.7, 0.85 };
/// As many choices are tried of the patches that keep the common point.
constexpr std::size_t TriedChoices = 3;

/// Whether the triangles are a surface with a border of so many points, each side of it passed once, in
/// its direction.
bool IsBordered(const InnerPatch& patch, std::size_t size)
{
  std::set<std::pair<Index, Index>> sides;
  for (const std::array<Index, 3>& triangle : patch.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index a = triangle[i], b = triangle[(i + 1) % 3];
      if (a == b || !sides.insert({ a, b }).second)
      {
        return false;
      }
    }
  }
  std::size_t onBorder = 0;
  for (const auto& [a, b] : sides)
  {
    const bool isBorder = a >= 0 && b >= 0 && static_cast<std::size_t>(b) == (a + 1) % size;
    const bool hasTwin = sides.count({ b, a }) > 0;
    if (hasTwin == isBorder)
    {
      return false;
    }
    onBorder += isBorder ? 1 : 0;
  }
  return onBorder == size;
}

InnerPatch FanAround(const Point3& center, std::size_t size)
{
  InnerPatch fan;
  fan.Points.push_back(center);
  fan.Normals.push_back({ 0.0, 0.0, 0.0 });
  for (std::size_t i = 0; i < size; ++i)
  {
    fan.Triangles.push_back(
      { static_cast<Index>(i), static_cast<Index>((i + 1) % size), Index(-1) });
  }
  return fan;
}

/// A patch whose sides are each seen from one of several points; `around` has the place of each side's
/// point in `centers`, and `base` is that of the patch.
InnerPatch FanAroundSeveral(
  const std::vector<Index>& around, Index base, const std::vector<Point3>& centers)
{
  InnerPatch patch;
  std::map<Index, Index> corner; // of a place in centers
  const auto cornerOf = [&](Index place)
  {
    const auto [at, isNew] = corner.emplace(place, -1 - static_cast<Index>(patch.Points.size()));
    if (isNew)
    {
      patch.Points.push_back(centers[place]);
      patch.Normals.push_back({ 0.0, 0.0, 0.0 });
    }
    return at->second;
  };
  const std::size_t size = around.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    const Index own = around[i], next = around[(i + 1) % size];
    const Index end = static_cast<Index>((i + 1) % size);
    patch.Triangles.push_back({ static_cast<Index>(i), end, cornerOf(own) });
    if (own != next)
    {
      patch.Triangles.push_back({ end, cornerOf(next), cornerOf(own) });
    }
    if (own != next && own != base && next != base)
    {
      patch.Triangles.push_back({ cornerOf(own), cornerOf(next), cornerOf(base) });
    }
  }
  return patch;
}
}

/// Whether a patch of the group is of several cycles.
bool PatchForms::HasMesh(const PatchGroup& group) const
{
  return std::any_of(
    group.begin(), group.end(), [this](Index patch) { return !this->Cell[patch].IsOneCycle; });
}

/// The middle of the centers of patches.
Point3 PatchForms::FanCenter(const PatchGroup& group) const
{
  Point3 center{ 0.0, 0.0, 0.0 };
  for (const Index patch : group)
  {
    center = center + (1.0 / group.size()) * this->Cell[patch].Center;
  }
  return this->Cell.MoveInside(group, center);
}

/// False if the patch is of several cycles, or a fan already.
bool PatchForms::BecomeFan(Index number)
{
  const CellPatch& patch = this->Cell[number];
  if (!patch.IsOneCycle)
  {
    return false;
  }
  this->Cell.Take(number, FanAround(this->FanCenter({ number }), patch.Border.size()));
  return true;
}

bool PatchForms::BecomeSheets(const PatchGroup& group)
{
  if (this->HasMesh(group))
  {
    return false;
  }
  const std::vector<JunctionCurve> curves = FindJunctionCurves(group, this->Cell);
  SheetBuilder builder(this->Cell.GridOf(group), { this->Cell.EdgeLength(group), 0.0 },
    this->Cell.RoomOf(group), this->Cell);
  std::vector<InnerPatch> made(group.size());
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    const CellPatch& patch = this->Cell[group[i]];
    const std::vector<Index> parting = this->Cell.PartingPoints(group[i]);
    const auto isOn = [&](Index point)
    { return std::find(parting.begin(), parting.end(), point) != parting.end(); };
    std::vector<JunctionCurve> own;
    std::copy_if(curves.begin(), curves.end(), std::back_inserter(own),
      [&](const JunctionCurve& curve) { return isOn(curve.First) && isOn(curve.Last); });
    if (2 * own.size() != parting.size() ||
      !builder.Build(this->Cell.BorderOfSheets(group[i]), own, made[i]) ||
      !IsBordered(made[i], patch.Border.size()))
    {
      return false;
    }
  }
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    this->Cell.Take(group[i], std::move(made[i]));
  }
  return true;
}

/// Whether all patches have one cycle, and no structure has two of them.
bool PatchForms::CanBeCommon(const PatchGroup& group) const
{
  std::set<Index> structures;
  for (const Index patch : group)
  {
    for (const StructureCycle& owner : this->Cell[patch].Owners)
    {
      if (!this->Cell[patch].IsOneCycle || !structures.insert(owner.Structure).second)
      {
        return false;
      }
    }
  }
  return true;
}

/// The middle of the points at which borders of a group part; of the patches' centers, if they do not.
Point3 PatchForms::CommonCenter(const PatchGroup& group) const
{
  std::set<Index> parting;
  for (const Index patch : group)
  {
    for (const Index point : this->Cell.PartingPoints(patch))
    {
      parting.insert(point);
    }
  }
  if (parting.size() < 2)
  {
    return this->FanCenter(group);
  }
  Point3 center{ 0.0, 0.0, 0.0 };
  for (const Index i : parting)
  {
    center = center + (1.0 / static_cast<double>(parting.size())) * this->Cell.PlaceOf(i);
  }
  return this->Cell.MoveInside(group, center);
}

bool PatchForms::BecomeCommon(const PatchGroup& group)
{
  if (!this->CanBeCommon(group))
  {
    return false;
  }
  const Point3 center = this->CommonCenter(group);
  for (const Index patch : group)
  {
    this->Cell.Take(patch, FanAround(center, this->Cell[patch].Border.size()));
  }
  return true;
}

/// The patches of a group that need a point of their own: of each structure all but the one that
/// `kept` counts, from the longest border on; all where a patch of several cycles is in the way.
PatchGroup PatchForms::FindClaiming(const PatchGroup& group, std::size_t kept) const
{
  const bool hasMesh = this->HasMesh(group);
  std::map<Index, PatchGroup> ofStructure;
  for (const Index patch : group)
  {
    for (const StructureCycle& owner : this->Cell[patch].Owners)
    {
      ofStructure[owner.Structure].push_back(patch);
    }
  }
  std::set<Index> claiming;
  for (auto& structure : ofStructure)
  {
    PatchGroup& patches = structure.second;
    std::stable_sort(patches.begin(), patches.end(),
      [this](Index a, Index b)
      { return this->Cell[a].Border.size() > this->Cell[b].Border.size(); });
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      const bool isKept = patches.size() == 1 ? !hasMesh : i == kept % patches.size();
      if (!isKept && this->Cell[patches[i]].IsOneCycle)
      {
        claiming.insert(patches[i]);
      }
    }
  }
  return { claiming.begin(), claiming.end() };
}

/**
 * Fans around one point, from which some patches take theirs a part of the way to their border. Such a
 * patch claims its sides, so that they have that point in its neighbours, too; where sides around
 * several points follow each other, triangles between these points fill the patch. False if that is
 * no surface.
 */
bool PatchForms::BecomeClaims(const PatchGroup& group, std::size_t kept, double way)
{
  std::vector<Point3> centers{ this->CommonCenter(group) };
  std::map<CellEdge, Index> claimedBy; // place in centers
  std::map<Index, Index> baseOf;
  for (const Index patch : this->FindClaiming(group, kept))
  {
    baseOf[patch] = static_cast<Index>(centers.size());
    this->Cell[patch].VisitSides([&](Index a, Index b)
      { claimedBy.emplace(CellEdgeOf(a, b), static_cast<Index>(centers.size())); });
    centers.push_back(this->Cell.MoveInside(
      group, Between(centers[0], this->Cell.MiddleOfBorder(this->Cell[patch]), way)));
  }
  for (const Index patch : group)
  {
    if (!this->Cell[patch].IsOneCycle)
    {
      continue; // stays
    }
    const std::vector<Index>& border = this->Cell[patch].Border;
    std::vector<Index> around; // of each side, the place of its point
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      const auto found = claimedBy.find(CellEdgeOf(border[i], border[(i + 1) % border.size()]));
      around.push_back(found == claimedBy.end() ? 0 : found->second);
    }
    const auto base = baseOf.find(patch);
    InnerPatch made = FanAroundSeveral(around, base == baseOf.end() ? 0 : base->second, centers);
    if (!IsBordered(made, border.size()))
    {
      return false;
    }
    this->Cell.Take(patch, std::move(made));
  }
  return true;
}

bool PatchForms::BecomeClaims(const PatchGroup& group)
{
  for (const double way : TriedWays)
  {
    for (std::size_t kept = 0; kept < TriedChoices; ++kept)
    {
      if (this->BecomeClaims(group, kept, way) && this->Cell.FindContactsOf(group).empty())
      {
        return true;
      }
    }
  }
  return false;
}
}
