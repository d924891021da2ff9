// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellPiece.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Cells/GraftPatch.h"

#include <algorithm>

namespace orthoslices
{
/// The patch that has this cycle as its first one, or null.
const PatchMesh* StitchedPatches::FindFrom(Index cycle) const
{
  const auto at = std::lower_bound(this->Patches.begin(), this->Patches.end(), cycle,
    [](const PatchMesh& m, Index first) { return m.Cycles.front() < first; });
  return at != this->Patches.end() && at->Cycles.front() == cycle ? &*at : nullptr;
}

const PatchMesh* StitchedPatches::Find(const std::vector<Index>& cycles) const
{
  const PatchMesh* patch = this->FindFrom(cycles.front());
  return patch && patch->Cycles == cycles ? patch : nullptr;
}

std::vector<const PatchMesh*> StitchedPatches::FindParts(const std::vector<Index>& cycles) const
{
  std::vector<const PatchMesh*> parts;
  const PatchMesh* lid = nullptr;
  for (const Index cycle : cycles)
  {
    const PatchMesh* patch = this->FindFrom(cycle);
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

void CellPiece::Add(CycleJoin& join)
{
  this->Joins.push_back(&join);
  this->Evidence = std::min(this->Evidence, join.Evidence);
}

namespace
{
/// The form that comes first unless StitchSlabs made the patch.
PatchForm FirstOwnForm(const CellPiece& piece)
{
  return { piece.IsDisc()   ? PatchKind::Fan
      : piece.KeepsStitched ? PatchKind::Grafted
                            : PatchKind::Joined,
    0 };
}
}

void CellPiece::Start(const StitchedPatches& stitched)
{
  const bool whole = stitched.Find(this->Cycles) != nullptr;
  this->KeepsStitched = !whole && !stitched.FindParts(this->Cycles).empty();
  this->Form = whole ? PatchForm{ PatchKind::Stitched, 0 } : FirstOwnForm(*this);
}

PatchForm CellPiece::NextForm() const
{
  const std::size_t next = this->Form.Attempt + 1;
  switch (this->Form.Kind)
  {
    case PatchKind::Stitched:
      return FirstOwnForm(*this);
    case PatchKind::Joined:
      if (next < RingShares.size())
      {
        return { PatchKind::Joined, next };
      }
      return {
        this->KeepsStitched || this->Cycles.size() == 2 ? PatchKind::Shell : PatchKind::Grafted, 0
      };
    case PatchKind::Grafted:
      if (next < GraftAttempts)
      {
        return { PatchKind::Grafted, next };
      }
      return { this->KeepsStitched ? PatchKind::Joined : PatchKind::Shell, 0 };
    case PatchKind::Fan:
    case PatchKind::Shell:
      break;
  }
  return { PatchKind::Shell, 0 };
}

namespace
{
std::vector<std::pair<Index, Index>> PairsOf(const CellPiece& piece)
{
  std::vector<std::pair<Index, Index>> pairs;
  for (const CycleJoin* join : piece.Joins)
  {
    pairs.emplace_back(join->First, join->Second);
  }
  return pairs;
}

/// Grafts what StitchSlabs made, tubes by the best of the other joins, and thin tubes by the rest.
PatchMesh Graft(
  const CycleGeometry& geometry, const StitchedPatches& stitched, const CellPiece& piece)
{
  std::vector<PatchMesh> parts;
  for (const PatchMesh* part : stitched.FindParts(piece.Cycles))
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
      parts.push_back(BuildJoinedPatch(geometry, { pair.first, pair.second },
        { { join->First, join->Second } }, RingShares.front()));
      addCycles(parts.back());
    }
  }
  for (std::size_t i = 0; i < piece.Cycles.size(); ++i)
  {
    if (hasPatch[i] == 0)
    {
      parts.push_back({ PatchKind::Fan, { piece.Cycles[i] }, {}, {} });
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
  return GraftPatches(geometry, parts, grafts, piece.Form.Attempt);
}
}

PatchMesh BuildPiece(
  const CycleGeometry& geometry, const StitchedPatches& stitched, CellPiece& piece)
{
  switch (piece.Form.Kind)
  {
    case PatchKind::Stitched:
      return *stitched.Find(piece.Cycles);
    case PatchKind::Joined:
      if (!piece.Builder)
      {
        piece.Builder =
          std::make_shared<JoinedPatchBuilder>(geometry, piece.Cycles, PairsOf(piece));
      }
      return piece.Builder->Build(RingShares[piece.Form.Attempt]);
    case PatchKind::Grafted:
      return Graft(geometry, stitched, piece);
    case PatchKind::Fan:
    case PatchKind::Shell:
      break;
  }
  return {};
}

std::pair<CellPiece, CellPiece> UndoWeakest(const CellPiece& piece, const StitchedPatches& stitched)
{
  CycleJoin* weakest = *std::min_element(piece.Joins.begin(), piece.Joins.end(),
    [](const CycleJoin* a, const CycleJoin* b) { return a->Evidence < b->Evidence; });
  weakest->Chosen = false;
  weakest->Impossible = true;
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
  std::pair<CellPiece, CellPiece> parts;
  for (const Index cycle : piece.Cycles)
  {
    (has(cycle) ? parts.first : parts.second).Cycles.push_back(cycle);
  }
  for (CycleJoin* join : piece.Joins)
  {
    if (join != weakest)
    {
      (has(join->First) ? parts.first : parts.second).Add(*join);
    }
  }
  parts.first.Start(stitched);
  parts.second.Start(stitched);
  return parts;
}
}
