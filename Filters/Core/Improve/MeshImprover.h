// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMeshImprover_h
#define OrthoSlicesMeshImprover_h

#include "Core/Base/Execution.h"
#include "Core/Improve/BlockChange.h"
#include "Core/Improve/BlockGrid.h"
#include "Core/Improve/BlockImprover.h"
#include "Core/Slices/SpatialGrid.h"

#include <vector>

namespace orthoslices
{
/**
 * Shapes triangles well, by local operations: where one has a small angle, a side of it is turned
 * into the other diagonal, collapses into one of its ends, or a corner moves along the surface,
 * whatever makes the smallest angle around it the greatest. The worst triangles come first. Where
 * nothing of that may be done, long sides are split. No operation moves the surface by more than
 * the tolerance, folds it, changes its topology, or makes triangles meet but in their common
 * corners and sides (CrossingGuard). REQUIRES: the surface has all of this before.
 *
 * The surface is divided into blocks (MeshBlock), which are improved at the same time, and then
 * again with faces elsewhere, until each triangle has been looked at with all that is around it.
 * Neither blocks nor their order depend on the number of threads, so the result does not either.
 * Several processes that have the same surface improve it together: each does so with some of the
 * blocks, and hands on what has changed. The mesh's table has no opposite corners afterwards.
 */
class MeshImprover
{
public:
  MeshImprover(const SpatialGrid& grid, const ImprovementLimits& limits, const Execution& execution,
    ImprovableMesh& mesh, const Ranks& ranks = Ranks());
  void Run();

private:
  void Run(Round round, const Box3& around, double side);
  void RunIn(const BlockGrid& blocks);
  double SideOfBlocks() const;
  void ListPending();
  bool IsPending(Index triangle) const;
  bool HasPressed(Index triangle) const;
  void RunIn(const BlockGrid& blocks, const BlockLists& lists, const Portion& portion);
  BlockChange Improve(
    const Box3& box, const BlockCells& cells, const Index* begin, const Index* end) const;
  std::size_t MostNewIn(const MeshBlock& block) const;
  BlockChange::Counts CountAll() const;
  void MakeRoom(std::vector<BlockChange>& changes);
  void PutBack(std::vector<BlockChange>& changes);
  void PutBack(const BlockChange& change);
  void ListPendingOf(const BlockChange& change, std::vector<Index>& pending) const;

  const SpatialGrid& Grid;
  ImprovementLimits Limits;
  const Execution& Execute;
  ImprovableMesh& Mesh;
  const Ranks Processes;
  Index TrianglesAtFirst;
  SurfaceSamples Samples;
  TriangleRuns Runs;
  Round Now = Round::First;
  double Wanted = 0.0; ///< triangles of less quality are to be improved in this round
  TriangleMarks Marks;
  std::vector<Index> Pending; ///< bad triangles that were not
};
}

#endif
