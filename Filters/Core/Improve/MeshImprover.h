// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMeshImprover_h
#define OrthoSlicesMeshImprover_h

#include "Core/Base/Execution.h"
#include "Core/Improve/PointStar.h"
#include "Core/Slices/SpatialGrid.h"

#include <vector>

namespace orthoslices
{
/// A triangle surface whose triangles are to be shaped well.
struct ImprovableMesh
{
  CornerTable Corners;
  std::vector<Point3> Points;
  std::vector<Point3> Normals;         ///< of the surface at the points; zero where it has none
  std::vector<std::uint8_t> Fixed;     ///< of each point: no triangle at it changes
  std::vector<std::uint8_t> Changed{}; ///< of each triangle: it is another one than it was
};

/// What may be done to a surface.
struct ImprovementLimits
{
  /// How far the surface may move, in world units; beside the worst triangles, 1.4 times as far.
  double Tolerance = 0.0;
  double SmallAngle = 0.0; ///< triangles with a smaller one are to be improved, in degrees
  Index Kept = 0;          ///< the first so many points stay where they are
};

/**
 * Shapes triangles well, by local operations: where one has a small angle, a side of it is turned
 * into the other diagonal, collapses into one of its ends, or a corner moves along the surface,
 * whatever makes the smallest angle around it the greatest. The worst triangles come first. Nothing
 * is done that moves the surface by more than the tolerance, folds it, or changes its topology.
 * Whether distant parts of it come to meet each other is for the caller to find out
 * (FindCrossings). Deterministic.
 */
class MeshImprover
{
public:
  MeshImprover(const SpatialGrid& grid, const ImprovementLimits& limits, ImprovableMesh& mesh);
  /// The execution hears of the triangles that were looked at.
  void Run(const Execution& execution = Execution());

private:
  enum class Kind : std::uint8_t
  {
    None,
    Flip,
    Collapse,
    Move
  };
  struct Operation
  {
    Kind What = Kind::None;
    Index Corner = -1;  ///< the corner opposite to the edge that is flipped or collapses
    Index Point = -1;   ///< that is moved
    Point3 Place{};     ///< and where it goes
    double Shift = 0.0; ///< of the surface
    double Quality = 0.0;
  };
  void RunBelow(double quality, bool withMoves, const Execution& execution);
  bool Improve(Index triangle, bool withMoves);
  bool MayHelp(Index triangle, bool withMoves) const;
  void Touch(Index point);
  void TryFlip(Index corner, Operation& best) const;
  void TryCollapse(Index corner, Operation& best) const;
  void TryMove(Index point, Operation& best) const;
  void Apply(const Operation& operation);
  double QualityOf(Index triangle) const;
  TriangleCorners PlacesOf(Index triangle) const;
  bool IsFree(Index point) const;

  const SpatialGrid& Grid;
  ImprovementLimits Limits;
  ImprovableMesh& Mesh;
  double Tolerance = 0.0;       ///< how far the surface may move now,
  double LeastCosine = 0.0;     ///< and by which angle triangles may turn
  std::vector<double> Shifts;   ///< of each point: how far the surface has moved near it
  Index Now = 1;                ///< counts operations
  std::vector<Index> TouchedAt; ///< of each point: the last operation beside it
  /// Of each triangle: when nothing helped it, without and with moves.
  std::vector<std::array<Index, 2>> FailedAt;
  std::vector<Index> Open; ///< triangles to be looked at
  mutable PointStar Star;  ///< of the point that is looked at
};
}

#endif
