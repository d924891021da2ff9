// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/SeparatePatches.h"

#include "Core/Base/Predicates.h"
#include "Core/Cells/CellShells.h"
#include "Core/Cells/GraftPatch.h"
#include "Core/Cells/JoinPatch.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>

namespace orthoslices
{
namespace
{
/// Where a joined patch has its ring between the two curves, in the order in which they are tried.
constexpr std::array<double, 3> RingShares{ 0.5, 0.3, 0.7 };
/// Of GraftPatches.
constexpr std::size_t GraftAttempts = 6;
/// Forms of patches, above all shapes of a Piece; see PatchStore.
constexpr std::size_t StitchedForm = 100;
constexpr std::size_t ShellForm = 101;

/// All patches that a cell has had. What is tried again need not be built and tested again.
class PatchStore
{
public:
  /// The number of the patch of these cycles or joins that has this form, or -1.
  Index Find(const std::vector<Index>& of, std::size_t form) const
  {
    const auto at = this->Numbers.find({ of, form });
    return at != this->Numbers.end() ? at->second : -1;
  }
  /// The number of a patch. Another one may have had this form before, but with other neighbours.
  Index Add(const std::vector<Index>& of, std::size_t form, PatchMesh&& mesh);

  PatchMesh& operator[](Index number) { return this->Meshes[number]; }

private:
  std::map<std::pair<std::vector<Index>, std::size_t>, Index> Numbers;
  std::vector<PatchMesh> Meshes;
};

Index PatchStore::Add(const std::vector<Index>& of, std::size_t form, PatchMesh&& mesh)
{
  const Index before = this->Find(of, form);
  if (before >= 0 && this->Meshes[before].Points == mesh.Points &&
    this->Meshes[before].Triangles == mesh.Triangles)
  {
    return before;
  }
  this->Meshes.push_back(std::move(mesh));
  const Index number = static_cast<Index>(this->Meshes.size()) - 1;
  this->Numbers[{ of, form }] = number;
  return number;
}

/// A patch on its way: cycles, what bounds them together, and which shape it has now.
struct Piece
{
  std::vector<Index> Cycles; ///< ascending
  std::vector<CycleJoin*> Joins;
  std::size_t Shape = 0; ///< the number of those that were tried before; see below
  double Evidence = std::numeric_limits<double>::infinity(); ///< the least of its joins

  bool Stitched = false;                       ///< it has the patch that StitchSlabs made
  bool KeepsStitched = false;                  ///< StitchSlabs made a patch of some of its cycles
  Index Mesh = -1;                             ///< number of its patch, which is empty for a fan
  std::shared_ptr<JoinedPatchBuilder> Builder; ///< once it is needed

  /// Discs are fans at first, then shells. Joined patches have a ring at each of the RingShares,
  /// then are grafted (first, if that keeps what StitchSlabs made), and are shells at last.
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

/// What the patches of all cells are made from.
struct PatchSource
{
  const CycleGeometry& Geometry;
  const std::vector<double>& CentralPoints;
  const std::vector<PatchMesh>& Stitched;
  bool MayShell; ///< joined patches, too
};
}

/// The patches of one cell.
class PatchSeparator::CellPatches
{
public:
  CellPatches(const Index* first, const Index* last, std::size_t firstJoin, std::size_t lastJoin)
    : First(first)
    , Last(last)
    , FirstJoin(firstJoin)
    , LastJoin(lastJoin)
  {
  }

  void Run(const PatchSource& source, std::vector<CycleJoin>& joins);
  bool IsUndone() const { return this->Undone; }
  void MoveTo(SeparatedPatches& result);

private:
  bool UpdateChosen(const std::vector<CycleJoin>& joins);
  void Group(std::vector<CycleJoin>& joins);
  const PatchMesh* FindStitched(const std::vector<Index>& cycles) const;
  const PatchMesh* FindStitchedFrom(Index cycle) const;
  std::vector<const PatchMesh*> FindStitchedParts(const std::vector<Index>& cycles) const;
  void ChooseStitched(Piece& piece) const;
  PatchMesh Graft(const Piece& piece) const;
  void Build(Index index);
  void BuildShell(Index index);
  void BuildJoined(Piece& piece);
  std::vector<PatchTriangle> ListTriangles();
  void AddFan(Index piece, Index& firstId, std::vector<PatchTriangle>& triangles);
  void AddMesh(Index piece, Index& firstId, std::vector<PatchTriangle>& triangles);
  std::vector<std::pair<Index, Index>> Test();
  bool Change(const std::vector<std::pair<Index, Index>>& contacts);
  Index PieceToChange(Index a, Index b) const;
  void Undo(Index piece);

  const PatchSource* Source = nullptr;
  const Index* First; ///< of its cycles
  const Index* Last;
  std::size_t FirstJoin, LastJoin;
  const CycleJoin* Joins = nullptr; ///< of all cells
  bool IsBuilt = false;
  std::vector<Index> Chosen; ///< the joins from which the patches were built
  std::vector<Piece> Pieces;
  PatchStore Store;
  KnownApart Apart;
  std::vector<PatchMesh> Shells;         ///< of each piece, once they are needed
  std::vector<std::uint8_t> HasNoAreaIn; ///< pieces with a triangle without area
  std::vector<Index> Border, NodePlaces;
  bool Undone = false;
  bool Unresolved = false;
};

/// False if the joins are the same as before.
bool PatchSeparator::CellPatches::UpdateChosen(const std::vector<CycleJoin>& joins)
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
void PatchSeparator::CellPatches::Group(std::vector<CycleJoin>& joins)
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
    Piece& piece = this->Pieces[pieceOf[placeOf(joins[i].First)]];
    piece.Joins.push_back(&joins[i]);
    piece.Evidence = std::min(piece.Evidence, joins[i].Evidence);
  }
}

/// The patch that StitchSlabs made with this cycle as its first, or null.
const PatchMesh* PatchSeparator::CellPatches::FindStitchedFrom(Index cycle) const
{
  const std::vector<PatchMesh>& stitched = this->Source->Stitched;
  const auto at = std::lower_bound(stitched.begin(), stitched.end(), cycle,
    [](const PatchMesh& m, Index first) { return m.Cycles.front() < first; });
  return at != stitched.end() && at->Cycles.front() == cycle ? &*at : nullptr;
}

/// The patch that StitchSlabs made of these cycles, or null.
const PatchMesh* PatchSeparator::CellPatches::FindStitched(const std::vector<Index>& cycles) const
{
  const PatchMesh* patch = this->FindStitchedFrom(cycles.front());
  return patch && patch->Cycles == cycles ? patch : nullptr;
}

/// The patches that StitchSlabs made of some of these cycles. Of a single cycle, which may as well
/// be an end of a tube, only the largest one, and only if there are no others.
std::vector<const PatchMesh*> PatchSeparator::CellPatches::FindStitchedParts(
  const std::vector<Index>& cycles) const
{
  std::vector<const PatchMesh*> parts;
  const PatchMesh* lid = nullptr;
  for (const Index cycle : cycles)
  {
    const PatchMesh* patch = this->FindStitchedFrom(cycle);
    if (!patch ||
      !std::includes(cycles.begin(), cycles.end(), patch->Cycles.begin(), patch->Cycles.end()))
    {
      continue;
    }
    if (patch->Cycles.size() > 1)
    {
      parts.push_back(patch);
    }
    else if (!lid || lid->Triangles.size() < patch->Triangles.size())
    {
      lid = patch;
    }
  }
  if (parts.empty() && lid)
  {
    parts.push_back(lid);
  }
  return parts;
}

void PatchSeparator::CellPatches::ChooseStitched(Piece& piece) const
{
  piece.Stitched = this->FindStitched(piece.Cycles) != nullptr;
  piece.KeepsStitched = !piece.Stitched && !this->FindStitchedParts(piece.Cycles).empty();
}

/// What StitchSlabs made, tubes by the best of the other joins, and thin tubes by the rest.
PatchMesh PatchSeparator::CellPatches::Graft(const Piece& piece) const
{
  std::vector<PatchMesh> parts;
  for (const PatchMesh* part : this->FindStitchedParts(piece.Cycles))
  {
    parts.push_back(*part);
  }
  DisjointSets known(static_cast<Index>(piece.Cycles.size()));
  std::vector<std::uint8_t> hasPatch(piece.Cycles.size(), 0);
  const auto placeOf = [&](Index cycle)
  { return static_cast<Index>(PlaceIn(piece.Cycles, cycle)); };
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
      parts.push_back(BuildJoinedPatch(this->Source->Geometry, { pair.first, pair.second },
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
  return GraftPatches(this->Source->Geometry, parts, grafts, piece.GraftAttempt());
}

void PatchSeparator::CellPatches::Build(Index index)
{
  Piece& piece = this->Pieces[index];
  if (piece.IsShell())
  {
    this->BuildShell(index);
    return;
  }
  if (!piece.Joins.empty() && !piece.Stitched)
  {
    this->BuildJoined(piece);
    return;
  }
  const std::size_t form = piece.Stitched ? StitchedForm : 0;
  piece.Mesh = this->Store.Find(piece.Cycles, form);
  if (piece.Mesh < 0)
  {
    piece.Mesh = this->Store.Add(piece.Cycles, form,
      piece.Stitched ? PatchMesh(*this->FindStitched(piece.Cycles)) : PatchMesh());
  }
}

/// Shells depend on all pieces of the cell.
void PatchSeparator::CellPatches::BuildShell(Index index)
{
  if (this->Shells.empty())
  {
    std::vector<std::vector<Index>> groups;
    for (const Piece& each : this->Pieces)
    {
      groups.push_back(each.Cycles);
    }
    this->Shells = BuildShells(this->Source->Geometry, this->First, this->Last, groups);
  }
  Piece& piece = this->Pieces[index];
  piece.Mesh = this->Store.Add(piece.Cycles, ShellForm, PatchMesh(this->Shells[index]));
}

void PatchSeparator::CellPatches::BuildJoined(Piece& piece)
{
  std::vector<Index> of;
  std::vector<std::pair<Index, Index>> pairs;
  for (const CycleJoin* join : piece.Joins)
  {
    of.push_back(static_cast<Index>(join - this->Joins));
    pairs.emplace_back(join->First, join->Second);
  }
  // Numbers of joins, unlike those of cycles: forms from 1.
  const std::size_t form = 1 + piece.Shape;
  piece.Mesh = this->Store.Find(of, form);
  if (piece.Mesh < 0)
  {
    if (piece.IsGrafted())
    {
      piece.Mesh = this->Store.Add(of, form, this->Graft(piece));
      return;
    }
    if (!piece.Builder)
    {
      piece.Builder =
        std::make_shared<JoinedPatchBuilder>(this->Source->Geometry, piece.Cycles, pairs);
    }
    piece.Mesh = this->Store.Add(of, form, piece.Builder->Build(piece.RingShare()));
  }
}

void PatchSeparator::CellPatches::AddFan(
  Index piece, Index& firstId, std::vector<PatchTriangle>& triangles)
{
  const Index cycle = this->Pieces[piece].Cycles.front();
  this->Source->Geometry.GetBoundary(cycle, this->Border, this->NodePlaces);
  const double* c = this->Source->CentralPoints.data() + 3 * static_cast<std::size_t>(cycle);
  const Point3 center{ c[0], c[1], c[2] };
  --firstId;
  for (std::size_t i = 0; i < this->Border.size(); ++i)
  {
    const Index a = this->Border[i];
    const Index b = this->Border[(i + 1) % this->Border.size()];
    triangles.push_back({ piece,
      { center, this->Source->Geometry.Graph.PointAt(a), this->Source->Geometry.Graph.PointAt(b) },
      { firstId, a, b } });
  }
}

void PatchSeparator::CellPatches::AddMesh(
  Index piece, Index& firstId, std::vector<PatchTriangle>& triangles)
{
  const PatchMesh& mesh = this->Store[this->Pieces[piece].Mesh];
  const std::vector<Index> borders = this->Source->Geometry.GetBorders(mesh.Cycles);
  for (const auto& triangle : mesh.Triangles)
  {
    std::array<Point3, 3> corners;
    std::array<Index, 3> ids;
    for (int i = 0; i < 3; ++i)
    {
      const Index place = triangle[i];
      corners[i] =
        place >= 0 ? this->Source->Geometry.Graph.PointAt(borders[place]) : mesh.Points[-1 - place];
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
std::vector<PatchTriangle> PatchSeparator::CellPatches::ListTriangles()
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
void PatchSeparator::CellPatches::Undo(Index index)
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
}

/// Which of two pieces that touch is in the wrong; both, if they are discs: -1.
Index PatchSeparator::CellPatches::PieceToChange(Index a, Index b) const
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
bool PatchSeparator::CellPatches::Change(const std::vector<std::pair<Index, Index>>& contacts)
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
    const bool isLast = !this->Source->MayShell && !this->Pieces[i].Joins.empty() &&
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

/// Pieces that are in the way of each other, or, named twice, wrong in themselves.
std::vector<std::pair<Index, Index>> PatchSeparator::CellPatches::Test()
{
  std::vector<PatchTriangle> triangles = this->ListTriangles();
  std::vector<PatchShape> shapes;
  this->Apart.Numbers.clear();
  for (const Piece& piece : this->Pieces)
  {
    shapes.push_back(piece.IsFan() ? PatchShape::Fan
        : piece.IsShell()          ? PatchShape::Shell
                                   : PatchShape::Joined);
    this->Apart.Numbers.push_back(piece.Mesh);
  }
  std::vector<std::pair<Index, Index>> contacts = FindContacts(triangles, shapes, &this->Apart);
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    // What has no triangles was not possible.
    if (this->HasNoAreaIn[i] != 0 ||
      (!this->Pieces[i].IsFan() && this->Store[this->Pieces[i].Mesh].Triangles.empty()))
    {
      contacts.emplace_back(static_cast<Index>(i), static_cast<Index>(i));
    }
  }
  return contacts;
}

void PatchSeparator::CellPatches::Run(const PatchSource& source, std::vector<CycleJoin>& joins)
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
    this->ChooseStitched(this->Pieces[i]);
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

void PatchSeparator::CellPatches::MoveTo(SeparatedPatches& result)
{
  for (const Piece& piece : this->Pieces)
  {
    PatchMesh& mesh = this->Store[piece.Mesh];
    if (!mesh.Cycles.empty())
    {
      result.Meshes.push_back(std::move(mesh));
    }
  }
  if (this->Unresolved)
  {
    result.Unresolved.insert(result.Unresolved.end(), this->First, this->Last);
  }
}

PatchSeparator::PatchSeparator(const CycleGeometry& geometry, const CellGroups& cells,
  const std::vector<double>& centralPoints, const std::vector<PatchMesh>& stitched, bool atAnyPrice)
  : Geometry(geometry)
  , Groups(cells)
  , CentralPoints(centralPoints)
  , Stitched(stitched)
{
  const SpatialGrid& grid = geometry.Grid;
  const int open =
    (grid.Count(0) == 0 ? 1 : 0) + (grid.Count(1) == 0 ? 1 : 0) + (grid.Count(2) == 0 ? 1 : 0);
  this->MayShell = atAnyPrice || open < 2;
}

PatchSeparator::~PatchSeparator() = default;

/// The joins of the cells are in the same order as these.
void PatchSeparator::ListCells(const std::vector<CycleJoin>& joins)
{
  const CellCycles& cycles = this->Geometry.Cycles;
  std::size_t next = 0;
  for (const auto& range : this->Groups.Several)
  {
    const Index* inOrder = this->Groups.Cycles.data();
    const auto& cell = cycles.Cell[inOrder[range.first]];
    const std::size_t firstJoin = next;
    while (next < joins.size() && cycles.Cell[joins[next].First] == cell)
    {
      ++next;
    }
    this->Cells.emplace_back(inOrder + range.first, inOrder + range.second, firstJoin, next);
  }
}

bool PatchSeparator::Run(const Execution& execution, std::vector<CycleJoin>& joins)
{
  if (this->Cells.empty())
  {
    this->ListCells(joins);
  }
  const PatchSource source{ this->Geometry, this->CentralPoints, this->Stitched, this->MayShell };
  execution.For(this->Cells.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Cells[i].Run(source, joins);
      }
    });
  return std::none_of(this->Cells.begin(), this->Cells.end(),
    [](const CellPatches& cell) { return cell.IsUndone(); });
}

SeparatedPatches PatchSeparator::Take()
{
  SeparatedPatches result;
  result.SharedCells = static_cast<Index>(this->Cells.size());
  for (CellPatches& cell : this->Cells)
  {
    cell.MoveTo(result);
  }
  this->Cells.clear();
  std::sort(result.Meshes.begin(), result.Meshes.end(),
    [](const PatchMesh& a, const PatchMesh& b) { return a.Cycles.front() < b.Cycles.front(); });
  return result;
}
}
