// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellPatches.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Base/Predicates.h"
#include "Core/Cells/CellShells.h"

#include <algorithm>

namespace orthoslices
{
Index PatchStore::Find(const Name& name) const
{
  const auto at = this->Numbers.find(name);
  return at != this->Numbers.end() ? at->second : -1;
}

Index PatchStore::Add(const Name& name, PatchMesh&& mesh)
{
  const Index before = this->Find(name);
  if (before >= 0 && this->Meshes[before].Points == mesh.Points &&
    this->Meshes[before].Triangles == mesh.Triangles)
  {
    return before;
  }
  this->Meshes.push_back(std::move(mesh));
  const Index number = static_cast<Index>(this->Meshes.size()) - 1;
  this->Numbers[name] = number;
  return number;
}

CellPatches::CellPatches(
  const Index* first, const Index* last, std::size_t firstJoin, std::size_t lastJoin)
  : First(first)
  , Last(last)
  , FirstJoin(firstJoin)
  , LastJoin(lastJoin)
{
}

/// False if the joins are the same as before.
bool CellPatches::UpdateChosen(const std::vector<CycleJoin>& joins)
{
  std::vector<Index> chosen;
  for (std::size_t i = this->FirstJoin; i < this->LastJoin; ++i)
  {
    if (joins[i].Chosen)
    {
      chosen.push_back(static_cast<Index>(i));
    }
  }
  const bool changed = !this->IsBuilt || chosen != this->Chosen;
  this->Chosen.swap(chosen);
  this->IsBuilt = true;
  return changed;
}

/// Cycles that are joined become one piece.
void CellPatches::Group(std::vector<CycleJoin>& joins)
{
  const Index count = static_cast<Index>(this->Last - this->First);
  DisjointSets sets(count);
  const auto placeOf = [&](Index cycle)
  { return static_cast<Index>(std::lower_bound(this->First, this->Last, cycle) - this->First); };
  for (const Index i : this->Chosen)
  {
    sets.Unite(placeOf(joins[i].First), placeOf(joins[i].Second));
  }
  std::vector<Index> pieceOf(count);
  for (Index i = 0; i < count; ++i)
  {
    const Index root = sets.Find(i);
    if (root == i)
    {
      pieceOf[i] = static_cast<Index>(this->Pieces.size());
      this->Pieces.emplace_back();
    }
    pieceOf[i] = pieceOf[root];
    this->Pieces[pieceOf[i]].Cycles.push_back(this->First[i]);
  }
  for (const Index i : this->Chosen)
  {
    this->Pieces[pieceOf[placeOf(joins[i].First)]].Add(joins[i]);
  }
}

std::vector<Index> CellPatches::NumbersOfJoins(const CellPiece& piece) const
{
  std::vector<Index> numbers;
  for (const CycleJoin* join : piece.Joins)
  {
    numbers.push_back(static_cast<Index>(join - this->Joins));
  }
  return numbers;
}

/// Gives a piece the patch of its present form.
void CellPatches::Build(Index index)
{
  CellPiece& piece = this->Pieces[index];
  const bool byJoins = piece.Is(PatchKind::Joined) || piece.Is(PatchKind::Grafted);
  const PatchStore::Name name{ byJoins ? this->NumbersOfJoins(piece) : piece.Cycles, piece.Form };
  if (piece.Is(PatchKind::Shell))
  {
    piece.Mesh = this->Store.Add(name, this->BuildShell(index));
    return;
  }
  piece.Mesh = this->Store.Find(name);
  if (piece.Mesh < 0)
  {
    piece.Mesh =
      this->Store.Add(name, BuildPiece(this->Source->Geometry, this->Source->Stitched, piece));
  }
}

/// Shells depend on all pieces of the cell.
PatchMesh CellPatches::BuildShell(Index index)
{
  if (this->Shells.empty())
  {
    std::vector<std::vector<Index>> groups;
    for (const CellPiece& each : this->Pieces)
    {
      groups.push_back(each.Cycles);
    }
    this->Shells = BuildShells(this->Source->Geometry, this->First, this->Last, groups);
  }
  return this->Shells[index];
}

/// The triangles of all pieces; notes in which some have no area.
CellTriangles CellPatches::ListTriangles()
{
  CellTriangles cell(this->Source->Geometry);
  this->HasNoAreaIn.assign(this->Pieces.size(), 0);
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    const CellPiece& piece = this->Pieces[i];
    const std::size_t before = cell.Triangles.size();
    if (piece.Is(PatchKind::Fan))
    {
      const Index cycle = piece.Cycles.front();
      const double* c = this->Source->CentralPoints.data() + 3 * static_cast<std::size_t>(cycle);
      cell.AddFan(cycle, { c[0], c[1], c[2] });
      continue;
    }
    cell.AddMesh(this->Store[piece.Mesh]);
    for (std::size_t t = before; t < cell.Triangles.size(); ++t)
    {
      this->HasNoAreaIn[i] |= HasNoArea(cell.Triangles[t].Corners) ? 1 : 0;
    }
  }
  return cell;
}

/// Takes the join with the least evidence out of a joined patch. The parts are tried anew.
void CellPatches::Undo(Index index)
{
  std::pair<CellPiece, CellPiece> parts = UndoWeakest(this->Pieces[index], this->Source->Stitched);
  this->Undone = true;
  this->Pieces[index] = std::move(parts.first);
  this->Pieces.push_back(std::move(parts.second));
}

/// Which of two pieces that touch is in the wrong; both, if they are discs: -1.
Index CellPatches::PieceToChange(Index a, Index b) const
{
  const CellPiece& first = this->Pieces[a];
  const CellPiece& second = this->Pieces[b];
  if (first.IsDisc() && second.IsDisc())
  {
    return -1;
  }
  // Shells have room beside each other only.
  if (first.Is(PatchKind::Shell) != second.Is(PatchKind::Shell))
  {
    return first.Is(PatchKind::Shell) ? b : a;
  }
  return first.Evidence <= second.Evidence ? a : b;
}

/// Marks the pieces that are in the wrong.
std::vector<std::uint8_t> CellPatches::PiecesToChange(
  const std::vector<std::pair<Index, Index>>& contacts) const
{
  std::vector<std::uint8_t> change(this->Pieces.size(), 0);
  for (const auto& contact : contacts)
  {
    const Index piece = this->PieceToChange(contact.first, contact.second);
    if (piece >= 0)
    {
      change[piece] = 1;
      continue;
    }
    for (const Index each : { contact.first, contact.second })
    {
      change[each] |= this->Pieces[each].Is(PatchKind::Shell) ? 0 : 1;
    }
  }
  return change;
}

/// Whether a piece has no other form left to be tried.
bool CellPatches::HasToBeUndone(const CellPiece& piece) const
{
  return piece.Is(PatchKind::Shell) ||
    (!this->Source->MayShell && !piece.IsDisc() && piece.NextForm().Kind == PatchKind::Shell);
}

/// Changes what is in the way. False if there are only shells of discs left.
bool CellPatches::Change(const std::vector<std::pair<Index, Index>>& contacts)
{
  const std::vector<std::uint8_t> change = this->PiecesToChange(contacts);
  bool any = false;
  bool undone = false;
  const std::size_t count = this->Pieces.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (change[i] == 0)
    {
      continue;
    }
    any = true;
    if (this->HasToBeUndone(this->Pieces[i]))
    {
      this->Undo(static_cast<Index>(i));
      undone = true;
      continue;
    }
    this->Pieces[i].Form = this->Pieces[i].NextForm();
  }
  // Shells depend on what is joined.
  if (undone)
  {
    this->Shells.clear();
  }
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    if (i >= count || change[i] != 0 || (undone && this->Pieces[i].Is(PatchKind::Shell)))
    {
      this->Build(static_cast<Index>(i));
    }
  }
  return any;
}

/// Pieces that are in the way of each other, or, named twice, wrong in themselves.
std::vector<std::pair<Index, Index>> CellPatches::Test()
{
  CellTriangles cell = this->ListTriangles();
  this->Apart.Numbers.clear();
  for (const CellPiece& piece : this->Pieces)
  {
    this->Apart.Numbers.push_back(piece.Mesh);
  }
  std::vector<std::pair<Index, Index>> contacts =
    FindContacts(cell.Triangles, cell.Kinds, &this->Apart);
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    const CellPiece& piece = this->Pieces[i];
    // What has no triangles was not possible.
    if (this->HasNoAreaIn[i] != 0 ||
      (!piece.Is(PatchKind::Fan) && this->Store[piece.Mesh].Triangles.empty()))
    {
      contacts.emplace_back(static_cast<Index>(i), static_cast<Index>(i));
    }
  }
  return contacts;
}

void CellPatches::Run(const PatchSource& source, std::vector<CycleJoin>& joins)
{
  this->Undone = false;
  if (!this->UpdateChosen(joins))
  {
    return;
  }
  this->Source = &source;
  this->Joins = joins.data();
  this->Unresolved = false;
  this->Pieces.clear();
  this->Shells.clear();
  this->Group(joins);
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    this->Pieces[i].Start(source.Stitched);
    this->Build(static_cast<Index>(i));
  }
  for (auto contacts = this->Test(); !contacts.empty(); contacts = this->Test())
  {
    if (!this->Change(contacts))
    {
      this->Unresolved = true;
      break;
    }
  }
}

void CellPatches::Forget(std::vector<CycleJoin>& joins)
{
  this->IsBuilt = false;
  this->Unresolved = false;
  this->Pieces.clear();
  this->Shells.clear();
  this->Store = {};
  this->Apart = {};
  for (std::size_t i = this->FirstJoin; i < this->LastJoin; ++i)
  {
    joins[i].Impossible = false;
  }
}

void CellPatches::MoveTo(std::vector<PatchMesh>& meshes)
{
  for (const CellPiece& piece : this->Pieces)
  {
    PatchMesh& mesh = this->Store[piece.Mesh];
    if (!mesh.Cycles.empty())
    {
      meshes.push_back(std::move(mesh));
    }
  }
}
}
