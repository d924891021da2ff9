// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   small closed triangle meshes of known topology, with curves on them
 *
 * For tests of stages that work on a mesh whose points may move (Core/Sparse). All are oriented
 * outwards.
 */

#ifndef OrthoSlicesClosedMeshes_h
#define OrthoSlicesClosedMeshes_h

#include "Core/Sparse/SurfaceMesh.h"
#include "Support/TriangleMesh.h"

#include <vector>

namespace orthoslices
{
namespace support
{

/// Points, and triangles of their numbers.
struct PlainMesh
{
  std::vector<Point3> Points;
  std::vector<std::array<Index, 3>> Triangles;

  /// The other mesh becomes a part of this one.
  void Append(const PlainMesh& other);
};

PlainMesh TetrahedronMesh();
PlainMesh OctahedronMesh();
/// A ring of `around` quadrilaterals along, `across` of them around the tube.
PlainMesh TorusMesh(Index around, Index across);

/**
 * Rings of points on circles around the z axis, one for each height, joined by quadrilaterals cut
 * in two, and closed by a fan around a point at each end. Ring k has the points
 * k `segments` to (k + 1) `segments` - 1, counter-clockwise as seen from above; the lower and the
 * upper end are the last two points.
 */
PlainMesh RingMesh(Index segments, const std::vector<double>& radii,
  const std::vector<double>& heights, double bottom, double top);

/// A ball of radius 1 whose rings, as in RingMesh, lie in pairs: `step` apart, from `lowest` on, and
/// `gap` within a pair.
PlainMesh BallOfPairs(Index segments, double lowest, double step, double gap);

/**
 * A mesh whose rings, as in RingMesh, are contours on z-slices: fixed, marked as curves, with cells
 * between them. Cells are as wide as `room` around the z axis, and the outermost ones reach `room`
 * beyond the rings.
 */
SurfaceMesh RingSurface(
  const PlainMesh& mesh, Index segments, const std::vector<double>& heights, double room);

/// The triangles that are left of a mesh, and the points that these use.
TriangleMesh CopyUsed(const CornerTable& corners, const std::vector<Point3>& points);

/// Nothing fixed, no curves, one cell of this size around the origin.
SurfaceMesh FreeSurface(const PlainMesh& mesh, double room);

/// Meshes a surface anew, with edges of this length, and fairs it, in the order of
/// MakeVirtualSlices. If it is not to be pulled to the middles of its slabs, its axis is forgotten
/// before the last step.
void MakeFair(double length, SurfaceMesh& mesh, bool isPulled = true);

} // namespace support
} // namespace orthoslices

#endif
