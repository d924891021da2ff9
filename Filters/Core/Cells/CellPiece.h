// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCellPiece_h
#define OrthoSlicesCellPiece_h

#include "Core/Cells/CycleJoin.h"
#include "Core/Cells/JoinPatch.h"

#include <limits>
#include <memory>
#include <tuple>
#include <vector>

namespace orthoslices
{
/// Where a joined patch has its ring between its two curves, in the order in which they are tried:
/// half-way first, which leaves most room on both sides.
constexpr std::array<double, 3> RingShares{ 0.5, 0.3, 0.7 };
/// How many grafts of a piece are tried: with the triangles that GraftPatches ranks first, by both
/// of its orders, and two more of each.
constexpr std::size_t GraftAttempts = 6;

/// A form in which a patch is tried.
struct PatchForm
{
  PatchKind Kind = PatchKind::Fan;
  std::size_t Attempt = 0; ///< of RingShares if it is Joined, of GraftPatches if it is Grafted

  bool operator==(const PatchForm& other) const
  {
    return this->Kind == other.Kind && this->Attempt == other.Attempt;
  }
  bool operator<(const PatchForm& other) const
  {
    return std::tie(this->Kind, this->Attempt) < std::tie(other.Kind, other.Attempt);
  }
};

/// A view of the patches that StitchSlabs made, which ascend by their first cycles.
class StitchedPatches
{
public:
  explicit StitchedPatches(const std::vector<PatchMesh>& patches)
    : Patches(patches)
  {
  }

  /// The patch of just these cycles, or null.
  const PatchMesh* Find(const std::vector<Index>& cycles) const;
  /// The patches of several of these cycles. Of a single cycle, which may as well be an end of a
  /// tube, only the largest one, and only if there are no others.
  std::vector<const PatchMesh*> FindParts(const std::vector<Index>& cycles) const;

private:
  const PatchMesh* FindFrom(Index cycle) const;

  const std::vector<PatchMesh>& Patches;
};

/**
 * A patch of a cell on its way: its cycles, what joins them, and the form that it has now.
 *
 * The forms are tried in this order. Cycles of which StitchSlabs made the patch get that one. A
 * disc is a fan, then a shell. A joined patch has its ring at each of the RingShares, then is
 * grafted, and is a shell at last; if StitchSlabs made a patch of some of its cycles, grafts come
 * first, as they keep it. There is nothing to graft on a tube between two cycles.
 */
struct CellPiece
{
  std::vector<Index> Cycles; ///< ascending
  std::vector<CycleJoin*> Joins;
  double Evidence = std::numeric_limits<double>::infinity(); ///< the least of its joins

  PatchForm Form;
  bool KeepsStitched = false;                  ///< StitchSlabs made a patch of some of its cycles
  Index Mesh = -1;                             ///< number of its patch, which is empty for a fan
  std::shared_ptr<JoinedPatchBuilder> Builder; ///< once it is needed

  bool IsDisc() const { return this->Joins.empty(); }
  bool Is(PatchKind kind) const { return this->Form.Kind == kind; }

  void Add(CycleJoin& join);
  /// Takes on the first form.
  void Start(const StitchedPatches& stitched);
  /// The form to try after the present one. REQUIRES: it is no shell.
  PatchForm NextForm() const;
};

/// The patch of a piece in its present form. REQUIRES: the piece is no shell, which depends on all
/// pieces of its cell. A fan has no triangles here.
PatchMesh BuildPiece(
  const CycleGeometry& geometry, const StitchedPatches& stitched, CellPiece& piece);

/// The two pieces that are left of a joined one without the join of least evidence, which becomes
/// impossible.
std::pair<CellPiece, CellPiece> UndoWeakest(
  const CellPiece& piece, const StitchedPatches& stitched);
}

#endif
