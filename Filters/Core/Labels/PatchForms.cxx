// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/PatchForms.h"

#include "Core/Base/Vectors.h"
#include "Core/Labels/JunctionCurves.h"
#include "Core/Labels/JunctionStar.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace orthoslices
{
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

namespace
{
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

bool PatchForms::BecomeStar(const PatchGroup& group)
{
  JunctionStar star;
  if (!this->CanBeCommon(group) || !FindJunctionStar(group, this->Cell, star))
  {
    return false;
  }
  SheetBuilder builder(this->Cell.GridOf(group), { this->Cell.EdgeLength(group), 0.0 },
    this->Cell.RoomOf(group), this->Cell);
  std::vector<InnerPatch> made(group.size());
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    if (!builder.Build(this->Cell.BorderOfSheets(group[i]), star, made[i]) ||
      !IsBordered(made[i], this->Cell[group[i]].Border.size()))
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

/// The middle of the points at which borders of a group part; of the patches' centers, if they do
/// not.
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
}
