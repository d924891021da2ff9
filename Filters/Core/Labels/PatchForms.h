// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPatchForms_h
#define OrthoSlicesPatchForms_h

#include "Core/Labels/StructurePatches.h"

#include <map>

namespace orthoslices
{
/// Whether the triangles are a surface with a border of so many points, each side of it passed
/// once, in its direction.
bool IsBordered(const InnerPatch& patch, std::size_t size);

/// The forms that patches of several structures in one cell can have in place of their own. Each
/// function returns false, and leaves the patches as they are, where that is impossible.
class PatchForms
{
public:
  explicit PatchForms(StructurePatches& cell)
    : Cell(cell)
  {
  }

  /// A fan around a point of its own.
  bool BecomeFan(Index patch);
  /// Sheets between the curves in which structures meet: see SheetBuilder.
  bool BecomeSheets(const PatchGroup& group);
  /// The same where more than two points are ends of such curves: they meet in one point.
  bool BecomeStar(const PatchGroup& group);
  /// Fans around one point. Not if a structure has two of the patches: its surface would touch
  /// itself.
  bool BecomeCommon(const PatchGroup& group);
  /**
   * Fans around one point, from which some patches take theirs a part of the way to their border,
   * so that no structure has two patches around one point. It is tried which of them keep it, and
   * how far the others go: all as far at first, then one after another. A patch of several cycles
   * stays as it is. False if the patches touch each other in all trials; then, if none is of
   * several cycles, some patches of one structure touch in the common point, and those of different
   * structures nowhere.
   */
  bool BecomeClaims(const PatchGroup& group);

private:
  bool HasMesh(const PatchGroup& group) const;
  bool CanBeCommon(const PatchGroup& group) const;
  Point3 FanCenter(const PatchGroup& group) const;
  Point3 CommonCenter(const PatchGroup& group) const;
  /// Points around which patches are fans: the first one is that of all sides that no patch claims.
  struct Claims
  {
    std::vector<Point3> Centers;
    std::map<CellEdge, Index> ClaimedBy; ///< of a side, the place of its point in Centers
    std::map<Index, Index> BaseOf;       ///< of a patch that claims its sides, the same
  };

  PatchGroup FindClaiming(const PatchGroup& group, std::size_t kept) const;
  void AddClaim(Index patch, const Point3& center, Claims& claims) const;
  bool Build(const PatchGroup& group, const Claims& claims);
  bool ClaimAll(const PatchGroup& group, std::size_t kept, double way);
  bool ClaimInTurn(const PatchGroup& group, std::size_t kept);
  bool ClaimNext(const PatchGroup& group, Index patch, Claims& claims);
  std::vector<Point3> PlacesFor(Index patch, const Point3& common) const;
  bool IsShared(const PatchGroup& group, const Point3& center) const;

  StructurePatches& Cell;
};
}

#endif
