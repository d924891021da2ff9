// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSeparatePatches_h
#define OrthoSlicesSeparatePatches_h

#include "Core/Base/Execution.h"
#include "Core/Cells/ChooseJoins.h"

#include <vector>

namespace orthoslices
{
class CellPatches;

/// The patches that are no fans, ascending by their first cycle.
struct SeparatedPatches
{
  Index SharedCells = 0; ///< cells with several cycles
  std::vector<PatchMesh> Meshes;
  std::vector<Index> Unresolved; ///< cycles of the cells in which patches may still touch
};

/**
 * Builds the patches of cells with several cycles so that they are disjoint (our own addition).
 *
 * The fan of one cycle cannot touch itself, and fans of different cells meet in shared arcs only.
 * But two patches in one cell may cross, and one that joins several cycles may cross itself. Every
 * pair of triangles is tested. Where two may touch, the joined patch with the least evidence is
 * tried in other shapes and at last undone: the join is marked as Impossible. Fans that may touch
 * each other become shells, for which all cycles of the cell have room: see BuildShells. If
 * nothing else helps, all patches of the cell become shells. Cycles of which `stitched` has the
 * patch get that one first. Cells without planes on two axes are so wide that a shell between
 * several cycles would be no surface to be wanted: there it is built `atAnyPrice` only.
 *
 * Only rounding can spoil that, where arcs lie closer together than it moves the copies. Such
 * cells are unresolved: EmbedArcs has to draw their arcs anew.
 */
class PatchSeparator
{
public:
  /// Keeps the addresses of all that it is given. `cells` are those of all cycles.
  PatchSeparator(const CycleGeometry& geometry, const CellGroups& cells,
    const std::vector<double>& centralPoints, const std::vector<PatchMesh>& stitched,
    bool atAnyPrice);
  ~PatchSeparator();

  /**
   * Builds the patches for the joins that are chosen; false if one of them was undone. Others may
   * be chosen then. When it is run again, only cells with other joins than before are built anew.
   * REQUIRES: always the same list of joins, ascending by cell.
   */
  bool Run(const Execution& execution, std::vector<CycleJoin>& joins);

  /// Cycles of the cells in which the patches that were built last may touch.
  std::vector<Index> Unresolved() const;

  /**
   * Says that the borders or central points of these cycles have changed: the next run builds their
   * cells anew, and no others, and the joins in them count as possible until it has tried them. So
   * when arcs have been drawn anew because a cell was unresolved, the cells that share these arcs
   * are all that is redone. The addresses and the cycles stay the same.
   */
  void Forget(const std::vector<Index>& cycles, std::vector<CycleJoin>& joins);

  /// What was built last. Moves it out: the next run builds all cells anew.
  SeparatedPatches Take();

private:
  void ListCells(const std::vector<CycleJoin>& joins);

  const CycleGeometry& Geometry;
  const CellGroups& Groups;
  const std::vector<double>& CentralPoints;
  const std::vector<PatchMesh>& Stitched;
  bool MayShell; ///< joined patches, too
  std::vector<CellPatches> Cells;
};
}

#endif
