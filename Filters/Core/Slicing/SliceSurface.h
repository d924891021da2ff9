// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSliceSurface_h
#define OrthoSlicesSliceSurface_h

#include "Core/Base/Execution.h"
#include "Core/Slicing/PlaneContours.h"

#include <vector>

/**
 * Contours of a closed triangle surface on the planes of one axis, as input for the
 * reconstruction.
 *
 *     TriangleSurface surface{ points, triangles, {} };
 *     if (CloseSurface(surface).Kind == SurfaceProblemKind::None)
 *       contours = SliceSurface(surface, 2, planes, Precision::Double, Execution());
 *
 * A vertex is above a plane when its coordinate is at least the plane's. So every triangle that
 * meets a plane has exactly two crossed sides, one of them passed upwards as the triangle's
 * vertices run and one downwards, and the next triangle of the contour is the neighbour across the
 * one passed upwards. In a closed oriented surface this is a permutation of the crossed triangles:
 * contours are its cycles, closed and oriented without any search or tolerance.
 */
namespace orthoslices
{
struct TriangleSurface
{
  std::vector<Point3> Points;
  std::vector<std::array<Index, 3>> Triangles; ///< counter-clockwise seen from outside

  /// Neighbors[t][s] is the triangle across the side of t from its vertex s to s + 1.
  /// Filled by CloseSurface().
  std::vector<std::array<Index, 3>> Neighbors;

  /// Whether contours say on which edge of the surface each of their vertices lies
  /// (PlaneContours::Edges), so that what points carry can be interpolated.
  bool NamesEdges = false;
};

/// Why a surface cannot be sliced.
enum class SurfaceProblemKind : std::uint8_t
{
  None,
  NotFinite,       ///< a coordinate is NaN or infinite
  OpenEdge,        ///< an edge of one triangle
  OverusedEdge,    ///< an edge of more than two triangles
  InconsistentEdge ///< an edge that its two triangles pass in the same direction
};

/// The problem and its edge; both ends are the same where the problem is a point.
struct SurfaceProblem
{
  SurfaceProblemKind Kind = SurfaceProblemKind::None;
  Point3 From{}, To{};
};

/**
 * Checks the surface and prepares it for SliceSurface(): finds the neighbours and turns the
 * triangles outwards if the enclosed volume is negative. Triangles with a repeated vertex are
 * dropped. If the surface is not closed otherwise, points with identical coordinates are joined.
 * Linear time, apart from sorting around vertices and the points to be joined.
 *
 * REQUIRES: triangles refer to existing points.
 */
SurfaceProblem CloseSurface(TriangleSurface& surface);

/// Six times the volume that the surface encloses, positive if it is oriented outwards.
double SixfoldVolume(const TriangleSurface& surface);

/**
 * The contours on every one of the planes `axis` = planes[i], in time linear in triangles and
 * output.
 *
 * REQUIRES: CloseSurface() found no problem; planes are ascending, distinct and already rounded to
 * `precision`.
 *
 * A vertex of a contour lies on an edge of the surface and is computed once, from the lower end to
 * the upper. It keeps a tiny distance from the ends of its edge, so that contours through a vertex
 * of the surface do not touch themselves; see kDepth and kFlatness in the source.
 */
std::vector<PlaneContours> SliceSurface(const TriangleSurface& surface, int axis,
  const std::vector<double>& planes, Precision precision, const Execution& execution);
}

#endif
