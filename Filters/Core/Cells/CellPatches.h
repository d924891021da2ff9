// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCellPatches_h
#define OrthoSlicesCellPatches_h

#include "Core/Cells/CellPiece.h"
#include "Core/Cells/FindContacts.h"

#include <map>
#include <utility>
#include <vector>

namespace orthoslices
{
/// What the patches of all cells are made from.
struct PatchSource
{
  const CycleGeometry& Geometry;
  const std::vector<double>& CentralPoints; ///< x, y, z for each cycle
  StitchedPatches Stitched;
  bool MayShell; ///< whether joined patches may become shells, too
};

/// All patches that a cell has had. What is tried again need not be built and tested again.
class PatchStore
{
public:
  /// Names a patch: the numbers of its joins if it is joined or grafted, else those of its cycles.
  using Name = std::pair<std::vector<Index>, PatchForm>;

  /// The number of the last patch with this name, or -1.
  Index Find(const Name& name) const;
  /// The number of a patch. Another one may have had this name before, but with other neighbours.
  Index Add(const Name& name, PatchMesh&& mesh);

  PatchMesh& operator[](Index number) { return this->Meshes[number]; }

private:
  std::map<Name, Index> Numbers;
  std::vector<PatchMesh> Meshes;
};

/**
 * The patches of one cell with several cycles, for joins that may change from one run to the next.
 * Where two patches may touch, one of them is tried in its next form, see CellPiece, and a joined
 * patch that has no next one loses the join with the least evidence.
 */
class CellPatches
{
public:
  /// The cycles [first, last), which ascend and stay where they are, and the numbers of the joins
  /// between them, from `firstJoin` to `lastJoin` - 1.
  CellPatches(const Index* first, const Index* last, std::size_t firstJoin, std::size_t lastJoin);

  /// Builds the patches for the joins that are chosen, unless it has done so for the same ones.
  /// What cannot be made is not chosen any more, and marked as impossible.
  void Run(const PatchSource& source, std::vector<CycleJoin>& joins);
  /// Whether the last run undid a join.
  bool IsUndone() const { return this->Undone; }
  /// Whether patches may touch each other still: all of them are shells of discs.
  bool IsUnresolved() const { return this->Unresolved; }
  /// Builds everything anew at the next run, for borders, central points or stitched patches that
  /// have changed. The joins of the cell count as possible again.
  void Forget(std::vector<CycleJoin>& joins);
  /// Moves the patches that are no fans to the end of a list.
  void MoveTo(std::vector<PatchMesh>& meshes);

  const Index* begin() const { return this->First; }
  const Index* end() const { return this->Last; }

private:
  bool UpdateChosen(const std::vector<CycleJoin>& joins);
  void Group(std::vector<CycleJoin>& joins);
  std::vector<Index> NumbersOfJoins(const CellPiece& piece) const;
  void Build(Index index);
  PatchMesh BuildShell(Index index);
  CellTriangles ListTriangles();
  std::vector<std::pair<Index, Index>> Test();
  bool Change(const std::vector<std::pair<Index, Index>>& contacts);
  std::vector<std::uint8_t> PiecesToChange(
    const std::vector<std::pair<Index, Index>>& contacts) const;
  Index PieceToChange(Index a, Index b) const;
  bool HasToBeUndone(const CellPiece& piece) const;
  void Undo(Index index);

  const PatchSource* Source = nullptr;
  const Index* First;
  const Index* Last;
  std::size_t FirstJoin, LastJoin;
  const CycleJoin* Joins = nullptr; ///< of all cells
  bool IsBuilt = false;
  std::vector<Index> Chosen; ///< the joins from which the patches were built
  std::vector<CellPiece> Pieces;
  PatchStore Store;
  KnownApart Apart;                      ///< by numbers of the store
  std::vector<PatchMesh> Shells;         ///< of each piece, once they are needed
  std::vector<std::uint8_t> HasNoAreaIn; ///< pieces with a triangle without area
  bool Undone = false;
  bool Unresolved = false;
};
}

#endif
