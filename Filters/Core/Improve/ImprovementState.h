// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesImprovementState_h
#define OrthoSlicesImprovementState_h

#include "Core/Improve/CrossingGuard.h"
#include "Core/Improve/PointStar.h"
#include "Core/Improve/SurfaceSamples.h"
#include "Core/Slices/SpatialGrid.h"

#include <vector>

namespace orthoslices
{
/// A block of a surface while it is improved, and what may be done to it now.
struct ImprovementState
{
  /// Samples are those of the whole surface.
  ImprovementState(const SpatialGrid& grid, MeshBlock& block, const SurfaceSamples& samples);

  const Point3& At(Index point) const { return this->Mesh.Points[point]; }
  TriangleCorners PlacesOf(Index triangle) const
  {
    const CornerTable& corners = this->Mesh.Corners;
    return { this->At(corners.VertexOf(3 * triangle)), this->At(corners.VertexOf(3 * triangle + 1)),
      this->At(corners.VertexOf(3 * triangle + 2)) };
  }
  double QualityOf(Index triangle) const { return this->Qualities[triangle]; }
  /// Whether a triangle is part of the surface: it is not gone, nor beyond a border.
  bool IsPart(Index triangle) const
  {
    const CornerTable& corners = this->Mesh.Corners;
    return corners.IsAlive(3 * triangle) && !this->Mesh.Borders.IsBeyond(corners, triangle);
  }
  /// Whether the edge of a corner is so short against the tolerance that its ends should be one point.
  bool IsShort(Index corner) const;
  /// Looks at a triangle, which has changed. Whether it is part of the surface.
  bool Update(Index triangle);
  /// A place for a point, or for one beside it, within the bounds of the surface.
  Point3 MoveIntoBounds(Index point, const Point3& place) const;

  const SpatialGrid& Grid;
  const MeshBlock& Block;
  ImprovableMesh& Mesh; ///< that of the block
  BoxTree Boxes;        ///< of the triangles
  SurfaceSamples Samples;
  std::vector<double> Qualities; ///< of each triangle: its SquaredSine; 1 if it is none
  double Slack = 1.0;            ///< how many tolerances the surface may move,
  double LeastCosine = 0.0;      ///< by which angle triangles may turn,
  double LeastOfCollapse = 0.0;  ///< and the least gain of a collapse, as a factor of the quality
};
}

#endif
