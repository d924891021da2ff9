// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMeshImprover_h
#define OrthoSlicesMeshImprover_h

#include "Core/Base/Execution.h"
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
 */
class MeshImprover
{
public:
  MeshImprover(const SpatialGrid& grid, const ImprovementLimits& limits, const Execution& execution,
    ImprovableMesh& mesh);
  void Run();

private:
  struct Piece;

  void Run(Round round, const Box3& around, double side);
  void RunIn(const BlockGrid& blocks, Round round);
  double SideOfBlocks() const;
  void ListPending();
  bool IsPending(Index triangle) const;
  bool HasFold(Index triangle) const;
  bool HasPressed(Index triangle) const;
  void ListPendingOf(const std::vector<Piece>& pieces);
  void Improve(const Box3& box, const BlockCells& cells, const Index* begin, const Index* end,
    Round round, Piece& piece) const;
  std::size_t MostNewIn(const MeshBlock& block) const;
  void MakeRoom(std::vector<Piece>& pieces);
  void PutBack(Piece& piece);

  const SpatialGrid& Grid;
  ImprovementLimits Limits;
  const Execution& Execute;
  ImprovableMesh& Mesh;
  Index TrianglesAtFirst;
  SurfaceSamples Samples;
  TriangleRuns Runs;
  Round Now = Round::First;
  double Wanted = 0.0;             ///< triangles of less quality are to be improved in this round
  std::vector<std::uint8_t> Tried; ///< of each triangle: whether it was looked at as it is
  std::vector<Index> Pending;      ///< bad triangles that were not
};
}

#endif
