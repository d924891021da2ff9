// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeparatePatches.h"

#include "CellShells.h"
#include "GraftPatch.h"
#include "JoinPatch.h"
#include "Predicates.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
namespace
{
/// Where a joined patch has its ring between the two curves, in the order in which they are tried.
constexpr std::array<double, 3> RingShares{ 0.5, 0.3, 0.7 };
/// Of GraftPatches.
constexpr std::size_t GraftAttempts = 6;

/// A patch on its way: cycles, what bounds them together, and which shape it has now.
struct Piece
{
  std::vector<Index> Cycles; ///< ascending
  std::vector<CycleJoin*> Joins;
  std::size_t Shape = 0; ///< the number of those that were tried before; see below
  double Evidence = std::numeric_limits<double>::infinity(); ///< the least of its joins

  bool Stitched = false;      ///< it has the patch that StitchSlabs made
  bool KeepsStitched = false; ///< StitchSlabs made a patch of some of its cycles

  /// Discs are fans at first, then shells. Joined patches are grafted, if that keeps what StitchSlabs
  /// made, have a ring at each of the RingShares, are grafted then, and are shells at last.
  std::size_t FirstGraft() const { return this->KeepsStitched ? 0 : RingShares.size(); }
  bool IsGrafted() const
  {
    return this->Shape >= this->FirstGraft() && this->Shape < this->FirstGraft() + GraftAttempts;
  }
  std::size_t GraftAttempt() const { return this->Shape - this->FirstGraft(); }
  double RingShare() const
  {
    return RingShares[this->Shape - (this->KeepsStitched ? GraftAttempts : 0)];
  }
  std::size_t LastShape() const
  {
    return this->Joins.empty() ? 1 : RingShares.size() + GraftAttempts;
  }
  bool IsFan() const { return this->Joins.empty() && this->Shape == 0 && !this->Stitched; }
  bool IsShell() const { return !this->Stitched && this->Shape == this->LastShape(); }
  std::size_t NextShape() const
  {
    // There is nothing to graft on a tube.
    const bool skip =
      !this->KeepsStitched && this->Shape + 1 == RingShares.size() && this->Cycles.size() == 2;
    return this->Shape + (skip ? 1 + GraftAttempts : 1);
  }
};

/// The patches of one cell.
class CellPatches
{
public:
  CellPatches(const CycleGeometry& geometry, const std::vector<double>& centralPoints,
    const std::vector<PatchMesh>& stitched, bool mayShell)
    : Geometry(geometry)
    , CentralPoints(centralPoints)
    , StitchedPatches(stitched)
    , MayShell(mayShell)
  {
  }

  void Run(const Index* first, const Index* last, CycleJoin* firstJoin, CycleJoin* lastJoin,
    SeparatedPatches& result);

private:
  void Group(CycleJoin* firstJoin, CycleJoin* lastJoin);
  const PatchMesh* FindStitched(const std::vector<Index>& cycles) const;
  std::vector<PatchMesh> FindStitchedParts(const std::vector<Index>& cycles) const;
  void ChooseStitched(Piece& piece) const;
  PatchMesh Graft(const Piece& piece) const;
  void Build(Index index);
  std::vector<PatchTriangle> ListTriangles();
  void AddFan(Index piece, Index& firstId, std::vector<PatchTriangle>& triangles);
  void AddMesh(Index piece, Index& firstId, std::vector<PatchTriangle>& triangles);
  bool Change(const std::vector<std::pair<Index, Index>>& contacts);
  Index PieceToChange(Index a, Index b) const;
  void Undo(Index piece);

  const CycleGeometry& Geometry;
  const std::vector<double>& CentralPoints;
  const std::vector<PatchMesh>& StitchedPatches;
  bool MayShell; ///< joined patches, too
  const Index* First = nullptr;
  const Index* Last = nullptr;
  std::vector<Piece> Pieces;
  std::vector<PatchMesh> Meshes;         ///< of each piece; empty for fans
  std::vector<PatchMesh> Shells;         ///< of each piece, once they are needed
  std::vector<std::uint8_t> HasNoAreaIn; ///< pieces with a triangle without area
  std::vector<Index> Border, NodePlaces;
  bool Undone = false;
};

/// Cycles that are joined become one piece.
void CellPatches::Group(CycleJoin* firstJoin, CycleJoin* lastJoin)
{
  const Index count = static_cast<Index>(this->Last - this->First);
  DisjointSets sets(count);
  const auto placeOf = [&](Index cycle)
  { return static_cast<Index>(std::lower_bound(this->First, this->Last, cycle) - this->First); };
  for (CycleJoin* join = firstJoin; join != lastJoin; ++join)
  {
    if (join->Chosen)
    {
      sets.Unite(placeOf(join->First), placeOf(join->Second));
    }
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
  for (CycleJoin* join = firstJoin; join != lastJoin; ++join)
  {
    if (join->Chosen)
    {
      Piece& piece = this->Pieces[pieceOf[placeOf(join->First)]];
      piece.Joins.push_back(join);
      piece.Evidence = std::min(piece.Evidence, join->Evidence);
    }
  }
}

/// The patch that StitchSlabs made of these cycles, or null.
const PatchMesh* CellPatches::FindStitched(const std::vector<Index>& cycles) const
{
  const auto at = std::lower_bound(this->StitchedPatches.begin(), this->StitchedPatches.end(),
    cycles.front(), [](const PatchMesh& m, Index cycle) { return m.Cycles.front() < cycle; });
  return at != this->StitchedPatches.end() && at->Cycles == cycles ? &*at : nullptr;
}

/// The patches that StitchSlabs made of some of these cycles; of a single one, the longest, only if
/// there are no others.
std::vector<PatchMesh> CellPatches::FindStitchedParts(const std::vector<Index>& cycles) const
{
  std::vector<PatchMesh> parts;
  std::vector<PatchMesh> lid;
  for (const Index cycle : cycles)
  {
    const auto at = std::lower_bound(this->StitchedPatches.begin(), this->StitchedPatches.end(),
      cycle, [](const PatchMesh& m, Index front) { return m.Cycles.front() < front; });
    if (at != this->StitchedPatches.end() && at->Cycles.front() == cycle &&
      std::includes(cycles.begin(), cycles.end(), at->Cycles.begin(), at->Cycles.end()))
    {
      const bool isLid = at->Cycles.size() == 1;
      if (!isLid)
      {
        parts.push_back(*at);
      }
      else if (lid.empty() || lid.front().Triangles.size() < at->Triangles.size())
      {
        lid.assign(1, *at);
      }
    }
  }
  return parts.empty() ? lid : parts;
}

void CellPatches::ChooseStitched(Piece& piece) const
{
  piece.Stitched = this->FindStitched(piece.Cycles) != nullptr;
  piece.KeepsStitched = !piece.Stitched && !this->FindStitchedParts(piece.Cycles).empty();
}

/// What StitchSlabs made, tubes by the best of the other joins, and thin tubes by the rest.
PatchMesh CellPatches::Graft(const Piece& piece) const
{
  std::vector<PatchMesh> parts = this->FindStitchedParts(piece.Cycles);
  DisjointSets known(static_cast<Index>(piece.Cycles.size()));
  std::vector<std::uint8_t> hasPatch(piece.Cycles.size(), 0);
  const auto placeOf = [&](Index cycle)
  {
    return static_cast<Index>(
      std::lower_bound(piece.Cycles.begin(), piece.Cycles.end(), cycle) - piece.Cycles.begin());
  };
  const auto addCycles = [&](const PatchMesh& part)
  {
    for (const Index cycle : part.Cycles)
    {
      hasPatch[placeOf(cycle)] = 1;
      known.Unite(placeOf(part.Cycles.front()), placeOf(cycle));
    }
  };
  std::for_each(parts.begin(), parts.end(), addCycles);
  std::vector<const CycleJoin*> inOrder(piece.Joins.begin(), piece.Joins.end());
  std::stable_sort(inOrder.begin(), inOrder.end(),
    [](const CycleJoin* a, const CycleJoin* b) { return a->Evidence > b->Evidence; });
  for (const CycleJoin* join : inOrder)
  {
    if (hasPatch[placeOf(join->First)] == 0 && hasPatch[placeOf(join->Second)] == 0)
    {
      const auto pair = std::minmax(join->First, join->Second);
      parts.push_back(BuildJoinedPatch(this->Geometry, { pair.first, pair.second },
        { { join->First, join->Second } }, RingShares.front()));
      addCycles(parts.back());
    }
  }
  for (std::size_t i = 0; i < piece.Cycles.size(); ++i)
  {
    if (hasPatch[i] == 0)
    {
      parts.push_back({ PatchKind::Joined, { piece.Cycles[i] }, {}, {} });
    }
  }
  std::vector<std::pair<Index, Index>> grafts;
  for (const CycleJoin* join : inOrder)
  {
    if (known.Unite(placeOf(join->First), placeOf(join->Second)))
    {
      grafts.emplace_back(join->First, join->Second);
    }
  }
  return GraftPatches(this->Geometry, parts, grafts, piece.GraftAttempt());
}

void CellPatches::Build(Index index)
{
  const Piece& piece = this->Pieces[index];
  PatchMesh& mesh = this->Meshes[index];
  if (piece.Stitched)
  {
    mesh = *this->FindStitched(piece.Cycles);
    return;
  }
  if (piece.IsFan())
  {
    mesh = PatchMesh();
    return;
  }
  if (piece.IsShell())
  {
    if (this->Shells.empty())
    {
      std::vector<std::vector<Index>> groups;
      for (const Piece& each : this->Pieces)
      {
        groups.push_back(each.Cycles);
      }
      this->Shells = BuildShells(this->Geometry, this->First, this->Last, groups);
    }
    mesh = this->Shells[index];
    return;
  }
  if (piece.IsGrafted())
  {
    mesh = this->Graft(piece);
    return;
  }
  std::vector<std::pair<Index, Index>> pairs;
  for (const CycleJoin* join : piece.Joins)
  {
    pairs.emplace_back(join->First, join->Second);
  }
  mesh = BuildJoinedPatch(this->Geometry, piece.Cycles, pairs, piece.RingShare());
}

void CellPatches::AddFan(Index piece, Index& firstId, std::vector<PatchTriangle>& triangles)
{
  const Index cycle = this->Pieces[piece].Cycles.front();
  this->Geometry.GetBoundary(cycle, this->Border, this->NodePlaces);
  const double* c = this->CentralPoints.data() + 3 * static_cast<std::size_t>(cycle);
  const Point3 center{ c[0], c[1], c[2] };
  --firstId;
  for (std::size_t i = 0; i < this->Border.size(); ++i)
  {
    const Index a = this->Border[i];
    const Index b = this->Border[(i + 1) % this->Border.size()];
    triangles.push_back(
      { piece, { center, this->Geometry.Graph.PointAt(a), this->Geometry.Graph.PointAt(b) },
        { firstId, a, b } });
  }
}

void CellPatches::AddMesh(Index piece, Index& firstId, std::vector<PatchTriangle>& triangles)
{
  const PatchMesh& mesh = this->Meshes[piece];
  const std::vector<Index> borders = this->Geometry.GetBorders(mesh.Cycles);
  for (const auto& triangle : mesh.Triangles)
  {
    std::array<Point3, 3> corners;
    std::array<Index, 3> ids;
    for (int i = 0; i < 3; ++i)
    {
      const Index place = triangle[i];
      corners[i] =
        place >= 0 ? this->Geometry.Graph.PointAt(borders[place]) : mesh.Points[-1 - place];
      ids[i] = place >= 0 ? borders[place] : firstId + place;
    }
    if (HasNoArea(corners))
    {
      this->HasNoAreaIn[piece] = 1;
    }
    triangles.push_back({ piece, corners, ids });
  }
  firstId -= static_cast<Index>(mesh.Points.size());
}

/// Points of G by their numbers, others by numbers below zero.
std::vector<PatchTriangle> CellPatches::ListTriangles()
{
  std::vector<PatchTriangle> triangles;
  this->HasNoAreaIn.assign(this->Pieces.size(), 0);
  Index firstId = 0;
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    const Index piece = static_cast<Index>(i);
    this->Pieces[i].IsFan() ? this->AddFan(piece, firstId, triangles)
                            : this->AddMesh(piece, firstId, triangles);
  }
  return triangles;
}

/// Takes the join with the least evidence out of a joined patch. The parts are tried anew.
void CellPatches::Undo(Index index)
{
  const Piece piece = this->Pieces[index];
  CycleJoin* weakest = *std::min_element(piece.Joins.begin(), piece.Joins.end(),
    [](const CycleJoin* a, const CycleJoin* b) { return a->Evidence < b->Evidence; });
  weakest->Chosen = false;
  weakest->Impossible = true;
  this->Undone = true;
  // The side of the first cycle of that join, by passes over the tree.
  std::vector<Index> side(1, weakest->First);
  const auto has = [&](Index cycle)
  { return std::find(side.begin(), side.end(), cycle) != side.end(); };
  for (std::size_t pass = 0; pass < piece.Joins.size(); ++pass)
  {
    for (const CycleJoin* join : piece.Joins)
    {
      if (join != weakest && has(join->First) != has(join->Second))
      {
        side.push_back(has(join->First) ? join->Second : join->First);
      }
    }
  }
  Piece parts[2];
  for (const Index cycle : piece.Cycles)
  {
    parts[has(cycle) ? 0 : 1].Cycles.push_back(cycle);
  }
  for (CycleJoin* join : piece.Joins)
  {
    if (join != weakest)
    {
      Piece& part = parts[has(join->First) ? 0 : 1];
      part.Joins.push_back(join);
      part.Evidence = std::min(part.Evidence, join->Evidence);
    }
  }
  for (Piece& part : parts)
  {
    this->ChooseStitched(part);
  }
  this->Pieces[index] = parts[0];
  this->Pieces.push_back(parts[1]);
  this->Meshes.emplace_back();
}

/// Which of two pieces that touch is in the wrong; both, if they are discs: -1.
Index CellPatches::PieceToChange(Index a, Index b) const
{
  const Piece& first = this->Pieces[a];
  const Piece& second = this->Pieces[b];
  if (first.Joins.empty() && second.Joins.empty())
  {
    return -1;
  }
  // Shells have room beside each other only.
  if (first.IsShell() != second.IsShell())
  {
    return first.IsShell() ? b : a;
  }
  return first.Evidence <= second.Evidence ? a : b;
}

/// Changes what is in the way. False if there are only shells of discs left.
bool CellPatches::Change(const std::vector<std::pair<Index, Index>>& contacts)
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
    change[contact.first] |= this->Pieces[contact.first].IsShell() ? 0 : 1;
    change[contact.second] |= this->Pieces[contact.second].IsShell() ? 0 : 1;
  }
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
    const bool isLast = !this->MayShell && !this->Pieces[i].Joins.empty() &&
      !this->Pieces[i].Stitched && this->Pieces[i].NextShape() == this->Pieces[i].LastShape();
    if (this->Pieces[i].IsShell() || isLast)
    {
      this->Undo(static_cast<Index>(i));
      undone = true;
      continue;
    }
    this->Pieces[i].Shape =
      this->Pieces[i].Stitched ? this->Pieces[i].Shape : this->Pieces[i].NextShape();
    this->Pieces[i].Stitched = false;
  }
  // Shells depend on what is joined.
  if (undone)
  {
    this->Shells.clear();
  }
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    if (i >= count || change[i] != 0 || (undone && this->Pieces[i].IsShell()))
    {
      this->Build(static_cast<Index>(i));
    }
  }
  return any;
}

void CellPatches::Run(const Index* first, const Index* last, CycleJoin* firstJoin,
  CycleJoin* lastJoin, SeparatedPatches& result)
{
  this->First = first;
  this->Last = last;
  this->Pieces.clear();
  this->Shells.clear();
  this->Undone = false;
  this->Group(firstJoin, lastJoin);
  this->Meshes.assign(this->Pieces.size(), PatchMesh());
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    this->ChooseStitched(this->Pieces[i]);
    this->Build(static_cast<Index>(i));
  }
  while (true)
  {
    std::vector<PatchTriangle> triangles = this->ListTriangles();
    std::vector<PatchShape> shapes;
    for (const Piece& piece : this->Pieces)
    {
      shapes.push_back(piece.IsFan() ? PatchShape::Fan
          : piece.IsShell()          ? PatchShape::Shell
                                     : PatchShape::Joined);
    }
    std::vector<std::pair<Index, Index>> contacts = FindContacts(triangles, shapes);
    for (std::size_t i = 0; i < this->Pieces.size(); ++i)
    {
      // What has no triangles was not possible.
      if (this->HasNoAreaIn[i] != 0 ||
        (!this->Pieces[i].IsFan() && this->Meshes[i].Triangles.empty()))
      {
        contacts.emplace_back(static_cast<Index>(i), static_cast<Index>(i));
      }
    }
    if (contacts.empty())
    {
      break;
    }
    if (!this->Change(contacts))
    {
      result.Unresolved.insert(result.Unresolved.end(), first, last);
      break;
    }
  }
  for (PatchMesh& mesh : this->Meshes)
  {
    if (!mesh.Cycles.empty())
    {
      result.Meshes.push_back(std::move(mesh));
    }
  }
  result.Undone |= this->Undone;
}
}

SeparatedPatches SeparatePatches(const CycleGeometry& geometry, const CellGroups& cells,
  const std::vector<double>& centralPoints, const std::vector<PatchMesh>& stitched, bool atAnyPrice,
  const Execution& execution, std::vector<CycleJoin>& joins)
{
  const SpatialGrid& grid = geometry.Grid;
  const int open =
    (grid.Count(0) == 0 ? 1 : 0) + (grid.Count(1) == 0 ? 1 : 0) + (grid.Count(2) == 0 ? 1 : 0);
  const bool mayShell = atAnyPrice || open < 2;
  // The joins of each cell, which are in the same order.
  std::vector<std::pair<std::size_t, std::size_t>> joinsOf(cells.Several.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < joinsOf.size(); ++i)
  {
    const auto& cell = geometry.Polygons.Cell[cells.Cycles[cells.Several[i].first]];
    joinsOf[i].first = next;
    while (next < joins.size() && geometry.Polygons.Cell[joins[next].First] == cell)
    {
      ++next;
    }
    joinsOf[i].second = next;
  }
  std::vector<SeparatedPatches> found(cells.Several.size());
  execution.For(found.size(),
    [&](std::size_t begin, std::size_t end)
    {
      CellPatches cell(geometry, centralPoints, stitched, mayShell);
      for (std::size_t i = begin; i < end; ++i)
      {
        cell.Run(cells.Cycles.data() + cells.Several[i].first,
          cells.Cycles.data() + cells.Several[i].second, joins.data() + joinsOf[i].first,
          joins.data() + joinsOf[i].second, found[i]);
      }
    });
  SeparatedPatches result;
  result.SharedCells = static_cast<Index>(found.size());
  for (SeparatedPatches& part : found)
  {
    std::move(part.Meshes.begin(), part.Meshes.end(), std::back_inserter(result.Meshes));
    result.Unresolved.insert(
      result.Unresolved.end(), part.Unresolved.begin(), part.Unresolved.end());
    result.Undone |= part.Undone;
  }
  std::sort(result.Meshes.begin(), result.Meshes.end(),
    [](const PatchMesh& a, const PatchMesh& b) { return a.Cycles.front() < b.Cycles.front(); });
  return result;
}
}
