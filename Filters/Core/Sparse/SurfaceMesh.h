// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSurfaceMesh_h
#define OrthoSlicesSurfaceMesh_h

#include "Core/Base/Box.h"
#include "Core/Sparse/ContourCorners.h"
#include "Core/Sparse/GuideCurves.h"
#include "Core/Surface/CornerTable.h"
#include "Core/Surface/LayOutTriangles.h"

#include <vector>

namespace orthoslices
{
/**
 * A reconstructed surface as a mesh whose points may move, closed and oriented outwards (our own).
 * The contours are curves on it: their points are fixed. Whatever else shall guide the surface can
 * be fixed as well. Each triangle is part of a patch and belongs to the patch's cell; the other
 * points belong to the cell of their triangles, as curves separate the cells.
 *
 * Lengths and angles are those after a *stretch* of the directions within the slices: thin things
 * between slices far apart, tubes and blades, look to it about as wide as the slices are apart (and
 * after the map to the world, where families are not at right angles to each other; there, only one
 * family stretches). Without that the least bending would neither keep a tube's radius nor a
 * blade's edge between two slices. Points themselves are in world coordinates, not stretched.
 */
struct SurfaceMesh
{
  CornerTable Corners;
  std::vector<Point3> Points;
  /// Of each point: lies on a contour; AtCorner at a corner of it, which stays in any case.
  std::vector<std::uint8_t> Fixed;
  std::vector<std::uint8_t> Crease; ///< of each point: the surface has an edge there
  std::vector<Index> Cell;          ///< of each triangle: its place in Cells
  std::vector<Box3> Cells; ///< of each patch: where its points may go, the grid's margin taken off

  AxisFrame Metric;             ///< what lengths and angles are before the stretch; see SpatialGrid
  int StretchAxis = -1;         ///< of the only family of slices; -1 where there are several
  std::vector<Point3> Stretch;  ///< of each point along each axis, at least 1
  std::vector<double> Levels{}; ///< see StackEnds
  std::vector<ContourCorner> ContourCorners{}; ///< see KeepCorners
  static constexpr std::uint8_t AtCorner = 2;

  /// From one point to another, stretched.
  Point3 Edge(Index from, Index to) const
  {
    return this->Stretched(
      this->Points[to] - this->Points[from], 0.5 * (this->Stretch[from] + this->Stretch[to]));
  }
  Point3 Stretched(const Point3& vector, const Point3& stretch) const
  {
    if (!this->Metric.IsWorld())
    {
      const Point3 inWorld = this->Metric.ToWorld(vector);
      const Point3& up = this->Metric.Normal(std::max(this->StretchAxis, 0));
      const Point3 across = Dot(inWorld, up) * up;
      return this->StretchAxis >= 0
        ? across + stretch[FirstAxis(this->StretchAxis)] * (inWorld - across)
        : inWorld;
    }
    return { stretch[0] * vector[0], stretch[1] * vector[1], stretch[2] * vector[2] };
  }
  /// Whether lengths at a point are other than in the world.
  bool IsStretched(Index point) const { return this->Stretch[point] != Unstretched; }
  static constexpr Point3 Unstretched{ 1.0, 1.0, 1.0 };

  /// From one point to another in the world, not stretched.
  Point3 InWorld(Index from, Index to) const
  {
    const Point3 edge = this->Points[to] - this->Points[from];
    return this->Metric.IsWorld() ? edge : this->Metric.ToWorld(edge);
  }

  /// The cotangent of a corner's angle, stretched.
  double Cotangent(Index corner) const
  {
    const Index apex = this->Corners.VertexOf(corner);
    const Point3 u = this->Edge(apex, this->Corners.StartOf(corner));
    const Point3 v = this->Edge(apex, this->Corners.EndOf(corner));
    return Dot(u, v) / std::max(Length(Cross(u, v)), 1e-300);
  }

  /// The cell of a point that is not fixed.
  Index CellOf(Index point) const { return this->Cell[this->Corners.CornerAt(point) / 3]; }
};

/// Puts a point on the edge of a corner, after a share of the way from its start to its end. On a
/// curve the point is fixed; it is on a crease if both ends are. Its stretch is that of a thickness
/// between theirs.
void SplitEdge(Index corner, double share, SurfaceMesh& mesh);

/**
 * The surface of `patches` with the arcs and loops of G as curves, whose points are fixed. Cells
 * that are not bounded by planes end half a mean spacing beyond the contours and the guides, an
 * extent being the spacing where there are fewer than two planes.
 *
 * With one family of slices, contours around a patch that is flatter than FlatShare of the spacing
 * become creases: the object ends flat. Where guides show what is beyond the last slice, they
 * decide whether it does there or within a rim farther out (RaiseEnds). At creases, too, points of
 * a contour are stretched by what makes its thickness (twice its area by its length: the radius of
 * a circle) 0.85 of the mean spacing, or 3 spacings at a crease, between 1 and 16 times and until
 * the contour looks 20 spacings long; other points along each axis as the one beside them that is
 * stretched most. With two families this holds for contours between the planes of the other one, up
 * to twice; and along the missing axis points of a patch stay within half the greater spacing of
 * where they were.
 * REQUIRES: the patches are laid out as triangles.
 */
SurfaceMesh MakeSurfaceMesh(const CycleGeometry& geometry, const Patches& patches,
  GuideCurves& guides, const Execution& execution);
}

#endif
