// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellPatches.h"

#include "Core/Cells/SeparatePatches.h"
#include "Core/Reconstruct.h"
#include "Support/RandomInput.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
CellPiece PieceOf(std::vector<Index> cycles, std::vector<CycleJoin>& joins)
{
  CellPiece piece;
  piece.Cycles = std::move(cycles);
  for (CycleJoin& join : joins)
  {
    piece.Add(join);
  }
  return piece;
}

CycleJoin Join(Index first, Index second, double evidence)
{
  CycleJoin join;
  join.First = first;
  join.Second = second;
  join.Evidence = evidence;
  join.Chosen = true;
  return join;
}

/// One letter for each form that is tried: fan, stitched, joined, grafted, shell.
std::string FormsOf(CellPiece piece, const std::vector<PatchMesh>& stitched)
{
  piece.Start(StitchedPatches(stitched));
  std::string forms(1, "FTJGS"[static_cast<int>(piece.Form.Kind)]);
  while (!piece.Is(PatchKind::Shell) && forms.size() < 100)
  {
    const PatchForm before = piece.Form;
    piece.Form = piece.NextForm();
    EXPECT_FALSE(piece.Form == before);
    EXPECT_EQ(piece.Form.Attempt, piece.Form.Kind == before.Kind ? before.Attempt + 1 : 0u);
    forms += "FTJGS"[static_cast<int>(piece.Form.Kind)];
  }
  return forms;
}
}

//----------------------------------------------------------------------------
TEST(CellPiece, FormsInTheOrderInWhichTheyAreTried)
{
  std::vector<CycleJoin> none, one{ Join(3, 5, 1.0) }, two{ Join(3, 5, 1.0), Join(5, 8, 2.0) };
  EXPECT_EQ(FormsOf(PieceOf({ 3 }, none), {}), "FS");
  EXPECT_EQ(FormsOf(PieceOf({ 3, 5 }, one), {}), "JJJS");
  EXPECT_EQ(FormsOf(PieceOf({ 3, 5, 8 }, two), {}), "JJJGGGGGGS");
  const PatchMesh pair{ PatchKind::Stitched, { 3, 5 }, {}, {} };
  EXPECT_EQ(FormsOf(PieceOf({ 3, 5 }, one), { pair }), "TJJJS");
  EXPECT_EQ(FormsOf(PieceOf({ 3, 5, 8 }, two), { pair }), "GGGGGGJJJS");
  EXPECT_EQ(FormsOf(PieceOf({ 5 }, none), { { PatchKind::Stitched, { 5 }, {}, {} } }), "TFS");
}

//----------------------------------------------------------------------------
TEST(CellPiece, StitchedPartsOfCycles)
{
  const std::vector<PatchMesh> patches{ { PatchKind::Stitched, { 1 }, {}, { { 0, 1, 2 } } },
    { PatchKind::Stitched, { 2 }, {}, { { 0, 1, 2 }, { 0, 2, 3 } } },
    { PatchKind::Stitched, { 3, 6 }, {}, {} }, { PatchKind::Stitched, { 4, 9 }, {}, {} } };
  const StitchedPatches stitched(patches);
  EXPECT_EQ(stitched.Find({ 3, 6 }), &patches[2]);
  EXPECT_EQ(stitched.Find({ 3 }), nullptr);
  EXPECT_EQ(stitched.Find({ 3, 6, 9 }), nullptr);
  using Parts = std::vector<const PatchMesh*>;
  EXPECT_EQ(stitched.FindParts({ 1, 2, 3, 4, 6 }), Parts{ &patches[2] });
  // Single cycles only if there is nothing else, and the one with more triangles.
  EXPECT_EQ(stitched.FindParts({ 1, 2, 3, 4 }), Parts{ &patches[1] });
  EXPECT_EQ(stitched.FindParts({ 5, 7 }), Parts{});
}

//----------------------------------------------------------------------------
/// A path of five cycles falls apart where its evidence is least.
TEST(CellPiece, UndoneAtTheWeakestJoin)
{
  std::vector<CycleJoin> joins{ Join(4, 9, 2.0), Join(2, 4, 1.0), Join(2, 7, 0.5),
    Join(7, 11, 3.0) };
  const CellPiece piece = PieceOf({ 2, 4, 7, 9, 11 }, joins);
  EXPECT_EQ(piece.Evidence, 0.5);
  const std::vector<PatchMesh> none;
  const auto parts = UndoWeakest(piece, StitchedPatches(none));
  for (std::size_t i = 0; i < joins.size(); ++i)
  {
    EXPECT_EQ(joins[i].Impossible, i == 2);
    EXPECT_EQ(joins[i].Chosen, i != 2);
  }
  EXPECT_EQ(parts.first.Cycles, (std::vector<Index>{ 2, 4, 9 }));
  EXPECT_EQ(parts.second.Cycles, (std::vector<Index>{ 7, 11 }));
  EXPECT_EQ(parts.first.Joins, (std::vector<CycleJoin*>{ &joins[0], &joins[1] }));
  EXPECT_EQ(parts.second.Joins, (std::vector<CycleJoin*>{ &joins[3] }));
  EXPECT_EQ(parts.first.Evidence, 1.0);
  EXPECT_EQ(parts.second.Evidence, 3.0);
  EXPECT_TRUE(parts.first.Is(PatchKind::Joined));
}

//----------------------------------------------------------------------------
TEST(PatchStore, SamePatchSameNumber)
{
  PatchStore store;
  const PatchMesh a{ PatchKind::Shell, { 1 }, { { 0.0, 0.0, 0.0 } }, { { 0, 1, -1 } } };
  PatchMesh b = a;
  b.Points.front()[2] = 1.0;
  const PatchStore::Name name{ { 1 }, { PatchKind::Shell, 0 } };
  EXPECT_EQ(store.Find(name), -1);
  const Index first = store.Add(name, PatchMesh(a));
  EXPECT_EQ(store.Find(name), first);
  EXPECT_EQ(store.Add(name, PatchMesh(a)), first);
  const Index second = store.Add(name, PatchMesh(b));
  EXPECT_NE(second, first);
  EXPECT_EQ(store.Find(name), second);
  // The same numbers mean cycles or joins, by the form.
  EXPECT_EQ(store.Find({ { 1 }, { PatchKind::Joined, 0 } }), -1);
  EXPECT_EQ(store.Find({ { 1 }, { PatchKind::Grafted, 0 } }), -1);
  EXPECT_EQ(store[first].Points.front()[2], 0.0);
}

//----------------------------------------------------------------------------
namespace
{
void ExpectSame(const SeparatedPatches& a, const SeparatedPatches& b)
{
  EXPECT_EQ(a.SharedCells, b.SharedCells);
  EXPECT_EQ(a.Unresolved, b.Unresolved);
  ASSERT_EQ(a.Meshes.size(), b.Meshes.size());
  for (std::size_t i = 0; i < a.Meshes.size(); ++i)
  {
    EXPECT_EQ(a.Meshes[i].Kind, b.Meshes[i].Kind);
    EXPECT_EQ(a.Meshes[i].Cycles, b.Meshes[i].Cycles);
    EXPECT_EQ(a.Meshes[i].Points, b.Meshes[i].Points);
    EXPECT_EQ(a.Meshes[i].Triangles, b.Meshes[i].Triangles);
  }
}

/// Chooses joins and builds them until all that are chosen can be built.
void BuildAll(
  const CycleGeometry& geometry, PatchSeparator& separator, std::vector<CycleJoin>& joins)
{
  do
  {
    ChooseJoins(geometry, {}, joins);
  } while (!separator.Run(Execution(), joins));
}
}

/// A cell that is forgotten is built anew from what is there now, and the others stay: after its
/// central points have moved, the whole is as if it had been built from the moved ones at once.
TEST(SeparatePatches, ForgottenCellsAreBuiltAnew)
{
  int forgotten = 0, changed = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(40); ++seed)
  {
    const Input input = seed % 2 == 0 ? RandomContradictoryInput(seed) : RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
    const CycleGeometry geometry = GeometryOf(result);
    std::vector<double> centralPoints = result.Surface.CentralPoints;
    std::vector<CycleJoin> joins = result.Joins;
    for (CycleJoin& join : joins)
    {
      join.Impossible = false;
    }
    std::vector<CycleJoin> fresh = joins;
    const std::vector<PatchMesh> none;
    PatchSeparator separator(geometry, result.Cells, centralPoints, none, true);
    BuildAll(geometry, separator, joins);
    // The central points of the cells with an even number move to a corner of their cycle.
    std::vector<Index> cycles;
    for (std::size_t i = 0; i < result.Cells.Several.size(); i += 2)
    {
      const auto& range = result.Cells.Several[i];
      for (Index c = range.first; c < range.second; ++c)
      {
        const Index cycle = result.Cells.Cycles[c];
        const Point3 corner = result.Graph.PointAt(geometry.GetBorders({ cycle }).front());
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          double& x = centralPoints[3 * static_cast<std::size_t>(cycle) + axis];
          x += 0.5 * (corner[axis] - x);
        }
        cycles.push_back(cycle);
      }
    }
    separator.Forget(cycles, joins);
    BuildAll(geometry, separator, joins);
    PatchSeparator atOnce(geometry, result.Cells, centralPoints, none, true);
    BuildAll(geometry, atOnce, fresh);
    const bool sameJoins = std::equal(joins.begin(), joins.end(), fresh.begin(),
      [](const CycleJoin& a, const CycleJoin& b) { return a.Chosen == b.Chosen; });
    const SeparatedPatches patches = separator.Take();
    EXPECT_EQ(patches.SharedCells, static_cast<Index>(result.Cells.Several.size()));
    // What is impossible in a cell may depend on the joins that were tried there before.
    if (sameJoins)
    {
      ExpectSame(patches, atOnce.Take());
      ++changed;
    }
    forgotten += static_cast<int>(cycles.size());
  }
  EXPECT_GT(forgotten, 200);
  EXPECT_GT(changed, 30);
}
