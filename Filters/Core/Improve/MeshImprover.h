// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMeshImprover_h
#define OrthoSlicesMeshImprover_h

#include "Core/Base/Execution.h"
#include "Core/Improve/OperationFinder.h"

#include <vector>

namespace orthoslices
{
/**
 * Shapes triangles well, by local operations: where one has a small angle, a side of it is turned
 * into the other diagonal, collapses into one of its ends, or a corner moves along the surface,
 * whatever makes the smallest angle around it the greatest. The worst triangles come first. Where
 * nothing of that may be done, long sides are split. No operation moves the surface by more than
 * the tolerance, folds it, changes its topology, or makes triangles meet but in their common
 * corners and sides (CrossingGuard). REQUIRES: the surface has all of this before. The result does
 * not depend on the number of threads.
 */
class MeshImprover
{
public:
  MeshImprover(const SpatialGrid& grid, const ImprovementLimits& limits, const Execution& execution,
    ImprovableMesh& mesh);
  void Run();

private:
  void RunBelow(double quality, Means means);
  std::vector<Index> ListWorse(double quality, Means means);
  bool MayHelp(Index triangle, Means means) const;
  void ImproveTogether(const std::vector<Index>& triangles, Means means);
  void ApplyFound(const std::vector<Index>& triangles, Means means);
  bool IsUntouched(const LocalOperation& found, Index before) const;
  bool IsStillAllowed(LocalOperation& found);
  void Apply(const LocalOperation& operation);
  void ApplySplit(const LocalOperation& operation);
  void Touch(Index point);
  void Note(Index triangle);
  void ForgetFailures();

  ImprovementLimits Limits;
  const Execution& Execute;
  ImprovableMesh& Mesh;
  ImprovementState State;
  CrossingGuard Guard;
  std::size_t TrianglesAtFirst;
  Index Now = 1;                ///< counts operations
  std::vector<Index> TouchedAt; ///< of each point: the last operation beside it
  /// Of each triangle: when nothing helped it, by Means.
  std::vector<std::array<Index, MeansCount>> FailedAt;
  Index Listed = 0;                  ///< counts lists of open triangles
  std::vector<Index> ListedAt;       ///< of each triangle: the last one that it is in
  std::vector<Index> Open;           ///< triangles to be looked at
  std::vector<LocalOperation> Found; ///< of the triangles that are looked at together
  std::vector<Box3> Extents;         ///< of what has been done to some of these
};
}

#endif
