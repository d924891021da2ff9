// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLightenArcs_h
#define OrthoSlicesLightenArcs_h

#include "Core/Base/Execution.h"
#include "Core/Cells/PatchMesh.h"
#include "Core/Patches/EstimateNormals.h"

#include <vector>

namespace orthoslices
{
/// The part of a curve between two places on it, against the straight side that takes its place.
struct CurveDeviation
{
  double Farthest = 0.0; ///< the greatest distance of a vertex from the side
  /// The height of a parabola over the side with the same mean distance from it; positive on the right,
  /// seen in the direction of the curve.
  double Height = 0.0;
};

/// A place on a curve: on the side that begins at a point, so far along it.
struct CurvePlace
{
  std::size_t Side = 0;
  double Share = 0.0; ///< 0 at the beginning of the side, 1 at its end
  Point2 Place{};
};

/// A curve in the plane with fewer vertices: places on the curve, the first and the last among them, and
/// the deviations of the sides between them.
struct LightCurve
{
  std::vector<CurvePlace> Places;
  std::vector<CurveDeviation> Sides;
};

/**
 * Draws a curve with as few sides as keep all of its vertices within `tolerance`: sides of equal length
 * where that takes no more of them, so that triangles beside them can be well shaped; else vertices that
 * MarkKept keeps.
 */
LightCurve LightenCurve(const std::vector<Point2>& curve, double tolerance);

/// G with fewer vertices, for triangles. Only the points of G are others.
struct LightGraph
{
  NodeGraph Graph;
  std::vector<double> Positions; ///< of its nodes along their edges
  SurfaceNormals Normals;        ///< at the points of Graph

  bool Any() const { return !this->Positions.empty(); }
};

/// What arcs are lightened by.
struct ArcSurface
{
  const CycleGeometry& Geometry;
  const CellGroups& Cells;
  const std::vector<PatchMesh>& Meshes;
  const SurfaceNormals& Normals;
};

/**
 * Draws all arcs with few vertices, and moves vertices and node points towards the side to which
 * the contours bulge, by about the distance that sides leave between them and the contours: so the
 * surface lies as much outside of the contours as inside, and is as accurate with a third of the
 * triangles.
 *
 * `accuracy` is the tolerance as a share of MeanSpacingInSlices of each slice: no vertex of a contour is
 * farther from the arcs in its plane. Corners of contours stay. Node points stay on their edges, in
 * their order. Arcs around patches of several cycles, or in cells with several patches, and loops keep
 * all vertices, as these patches are known to be apart as they are; so do faces whose arcs would cross.
 * Arcs are embedded in their faces, and both patches beside an arc have what is left of it: no cracks.
 */
LightGraph LightenArcs(const ArcSurface& surface, double accuracy, const Execution& execution);
}

#endif
