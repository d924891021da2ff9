// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesDivideCycles_h
#define OrthoSlicesDivideCycles_h

#include "Core/Base/Ranks.h"
#include "Core/Patches/InnerPatches.h"

#include <vector>

namespace orthoslices
{
/**
 * The cycles that one of several processes fills: one behind the other, so that the triangles of all
 * processes in their order are those of one. Work goes by the points of borders and, but for meshes, a
 * constant, which stands for the points inside. A mesh is the work of its first cycle.
 */
Portion DivideCycles(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes, const Ranks& ranks);

/**
 * The cycles to be filled where a part of all is wanted: those of the part, and the others of their
 * cells, as patches of one cell give way to each other.
 */
class ChosenCycles
{
public:
  /// `part` may be null: all are wanted. Keeps the addresses.
  ChosenCycles(const CellGroups& cells, std::size_t count, const Portion* part);

  bool Has(std::size_t cycle) const { return this->Part == nullptr || this->IsChosen[cycle] != 0; }

  /// Of the cells with several cycles, those that have cycles of the part.
  const CellGroups& Cells() const
  {
    return this->Part == nullptr ? this->AllCells : this->OwnCells;
  }

  /// Removes the patches of cycles that are not wanted.
  void LeaveOutOthers(InnerPatches& patches) const;

private:
  const CellGroups& AllCells;
  const Portion* Part;
  std::vector<std::uint8_t> IsChosen;
  CellGroups OwnCells;
};

/// The patches of all processes, each of which has those of its part.
InnerPatches JoinParts(const Ranks& ranks, const InnerPatches& own);

/// Where else than in the part of one process a point of G has triangles.
enum PartsOfPoint : std::uint8_t
{
  BeforePart = 1, ///< in a part before it
  AfterPart = 2
};

/// The parts besides `part` in which each point of G has triangles: bits of PartsOfPoint. A mesh is
/// in the part of its first cycle.
std::vector<std::uint8_t> FindPartsOfPoints(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes, const Portion& part);
}

#endif
