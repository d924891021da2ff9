// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPatchForms_h
#define OrthoSlicesPatchForms_h

#include "Core/Labels/StructurePatches.h"

namespace orthoslices
{
/// The forms that patches of several structures in one cell can have in place of their own. Each function
/// returns false, and leaves the patches as they are, where that is impossible.
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
  /// Fans around one point. Not if a structure has two of the patches: its surface would touch itself.
  bool BecomeCommon(const PatchGroup& group);
  /**
   * Fans around one point, from which some patches take theirs a part of the way to their border, so that
   * no structure has two patches around one point. It is tried which of them keep it, and how far the
   * others go. A patch of several cycles stays as it is. False if the patches touch each other in all trials;
   * then they are what the last one has made of them.
   */
  bool BecomeClaims(const PatchGroup& group);

private:
  bool HasMesh(const PatchGroup& group) const;
  bool CanBeCommon(const PatchGroup& group) const;
  Point3 FanCenter(const PatchGroup& group) const;
  Point3 CommonCenter(const PatchGroup& group) const;
  PatchGroup FindClaiming(const PatchGroup& group, std::size_t kept) const;
  bool BecomeClaims(const PatchGroup& group, std::size_t kept, double way);

  StructurePatches& Cell;
};
}

#endif
