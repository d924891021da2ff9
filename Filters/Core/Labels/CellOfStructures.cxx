// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/CellOfStructures.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Labels/PatchForms.h"
#include "Core/Labels/StructurePatches.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace orthoslices
{
namespace
{
/// How the patches of a group are made: each form makes less of their shape and more sure of it
/// than the one before.
enum class GroupForm : std::uint8_t
{
  Own,    ///< as their structures have them; of one patch only
  Fan,    ///< a fan around a point of its own; of one patch only
  Sheets, ///< divided by the curves in which structures meet
  Common, ///< fans around one point
  Claims, ///< fans around one point, but for some of structures that have several patches
  Stuck   ///< they may touch
};

/// Has the patches of one cell make room for each other.
class CellSettler
{
public:
  explicit CellSettler(const StructureTables& tables)
    : Cell(tables)
    , Make(this->Cell)
    , Groups(0)
  {
  }

  SettledCell Run(const std::vector<StructureCycle>& cycles);

private:
  void FormGroups();
  PatchGroup MembersOf(Index patch);
  GroupForm MakeSafe(const PatchGroup& group);
  bool Separate(Index a, Index b);
  bool Demote(Index patch);
  bool BreakMeshes();
  bool BreakContradicted();
  bool Settle();

  StructurePatches Cell;
  PatchForms Make;
  DisjointSets Groups;          ///< of patches
  std::vector<GroupForm> Forms; ///< of each group, at its least patch
};

/// Patches whose borders have a side in common are one group.
void CellSettler::FormGroups()
{
  this->Groups = DisjointSets(this->Cell.Count());
  this->Forms.assign(this->Cell.Count(), GroupForm::Own);
  for (const auto& side : this->Cell.Sides())
  {
    for (const Index patch : side.second)
    {
      this->Groups.Unite(side.second.front(), patch);
    }
  }
  for (Index i = 0; i < this->Groups.Count(); ++i)
  {
    if (this->Groups.Find(i) != i)
    {
      continue;
    }
    const PatchGroup group = this->MembersOf(i);
    if (group.size() > 1)
    {
      this->Forms[i] = this->Make.BecomeSheets(group) || this->Make.BecomeStar(group)
        ? GroupForm::Sheets
        : this->MakeSafe(group);
    }
    else if (this->Cell[i].IsAmbiguous)
    {
      this->Forms[i] = this->Make.BecomeFan(i) ? GroupForm::Fan : GroupForm::Stuck;
    }
  }
}

PatchGroup CellSettler::MembersOf(Index patch)
{
  PatchGroup group;
  for (Index i = 0; i < this->Groups.Count(); ++i)
  {
    if (this->Groups.Find(i) == this->Groups.Find(patch))
    {
      group.push_back(i);
    }
  }
  return group;
}

/// Gives a group whose patches touch each other a safer form. False if there is none.
bool CellSettler::Demote(Index patch)
{
  GroupForm& form = this->Forms[this->Groups.Find(patch)];
  form = form == GroupForm::Sheets ? this->MakeSafe(this->MembersOf(patch)) : GroupForm::Stuck;
  return form != GroupForm::Stuck;
}

/// Fans around one point, or around as many as are needed.
GroupForm CellSettler::MakeSafe(const PatchGroup& group)
{
  return this->Make.BecomeCommon(group) ? GroupForm::Common
    : this->Make.BecomeClaims(group)    ? GroupForm::Claims
                                        : GroupForm::Stuck;
}

/// Has two patches that touch make room for each other. False if nothing can be done any more.
bool CellSettler::Separate(Index a, Index b)
{
  if (this->Groups.Find(a) == this->Groups.Find(b))
  {
    return this->Demote(a);
  }
  bool changed = false;
  for (const Index patch : { a, b })
  {
    GroupForm& form = this->Forms[this->Groups.Find(patch)];
    if (form == GroupForm::Own && this->Make.BecomeFan(patch))
    {
      form = GroupForm::Fan;
      changed = true;
    }
  }
  if (changed)
  {
    return true;
  }
  this->Groups.Unite(a, b);
  const GroupForm form = this->MakeSafe(this->MembersOf(a));
  this->Forms[this->Groups.Find(a)] = form;
  return form != GroupForm::Stuck;
}

/// The new form of a patch for each of its owners, whose borders may begin elsewhere and run the
/// other way.
void AddNewPatches(
  const CellPatch& patch, const std::vector<std::vector<Index>>& borders, SettledCell& result)
{
  for (std::size_t i = 0; i < patch.Owners.size() && !patch.New.Points.empty(); ++i)
  {
    const std::vector<Index>& border = borders[i];
    std::map<Index, Index> placeOf;
    for (std::size_t k = 0; k < border.size(); ++k)
    {
      placeOf[border[k]] = static_cast<Index>(k);
    }
    const bool isReversed = placeOf[patch.Border[1]] !=
      (placeOf[patch.Border[0]] + 1) % static_cast<Index>(border.size());
    NewPatch own{ patch.Owners[i], patch.New };
    for (std::array<Index, 3>& triangle : own.Patch.Triangles)
    {
      for (Index& corner : triangle)
      {
        corner = corner >= 0 ? placeOf[patch.Border[corner]] : corner;
      }
      if (isReversed)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
    result.Patches.push_back(std::move(own));
  }
}

/// Whether a patch of several cycles is in the way of others; then its cycles get patches of their
/// own.
bool CellSettler::BreakMeshes()
{
  bool any = false;
  for (Index i = 0; i < this->Groups.Count(); ++i)
  {
    const CellPatch& patch = this->Cell[i];
    if (this->Forms[this->Groups.Find(i)] == GroupForm::Stuck && patch.Offsets.size() > 2)
    {
      any |= this->Cell.Break(patch);
    }
  }
  return any;
}

/**
 * Whether a patch of several cycles has one that is the whole border of another structure's patch:
 * what is beyond that cycle ends there for the other structure, and leads to another cycle for this
 * one. Between both there would be a gap, or an overlap. Then its cycles get patches of their own,
 * as there.
 */
bool CellSettler::BreakContradicted()
{
  bool any = false;
  for (Index i = 0; i < this->Cell.Count(); ++i)
  {
    if (this->Cell[i].Offsets.size() > 2 && this->Cell.HasBorderOfAnother(i))
    {
      any |= this->Cell.Break(this->Cell[i]);
    }
  }
  return any;
}

/// Makes patches give way to each other. False if some still touch.
bool CellSettler::Settle()
{
  PatchGroup all(this->Cell.Count());
  std::iota(all.begin(), all.end(), 0);
  bool changed = true, settled = false;
  while (changed && !settled)
  {
    changed = false;
    const std::vector<std::pair<Index, Index>> contacts = this->Cell.FindContactsOf(all);
    settled = contacts.empty();
    for (const auto& [a, b] : contacts)
    {
      changed |= this->Separate(a, b);
    }
  }
  return settled;
}

SettledCell CellSettler::Run(const std::vector<StructureCycle>& cycles)
{
  SettledCell result;
  do
  {
    do
    {
      this->Cell.Set(cycles);
    } while (this->BreakContradicted());
    this->FormGroups();
    result.IsSettled = this->Settle();
  } while (!result.IsSettled && this->BreakMeshes());
  for (Index patch = 0; patch < this->Cell.Count(); ++patch)
  {
    std::vector<std::vector<Index>> borders;
    for (const StructureCycle& owner : this->Cell[patch].Owners)
    {
      borders.push_back(this->Cell.BorderOf(owner));
    }
    AddNewPatches(this->Cell[patch], borders, result);
  }
  return result;
}
}

SettledCell SettleCell(const StructureTables& tables, const std::vector<StructureCycle>& cycles)
{
  return CellSettler(tables).Run(cycles);
}
}
