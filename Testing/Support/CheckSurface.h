// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   independent checker of the guarantees on a plain list of triangles
 *
 * Slow and obvious on purpose; shares no code with the reconstruction, only its plain types of data
 * (contours, the planes of the grid, the kind of orientation). Everything but volumes and
 * winding numbers is counted from the point ids alone: two points at the same place are two points.
 */

#ifndef OrthoSlicesCheckSurface_h
#define OrthoSlicesCheckSurface_h

#include "Core/Slices/OrientContours.h"
#include "Core/Slices/SpatialGrid.h"
#include "Support/TextContours.h"
#include "Support/TriangleMesh.h"

#include <iosfwd>

namespace orthoslices
{
namespace support
{

struct SurfaceCheck
{
  std::int64_t OpenEdges = 0;           ///< edges of one triangle (G1)
  std::int64_t CrowdedEdges = 0;        ///< edges of three or more triangles (G1)
  std::int64_t DegenerateTriangles = 0; ///< two equal point ids, or a wrong one (G1)
  std::int64_t NonManifoldVertices = 0; ///< vertices whose triangles are not one closed fan (G2)
  std::int64_t InconsistentEdges = 0;   ///< edges that two triangles run through alike (G3)
  std::int64_t UnusedPoints = 0;        ///< points of no triangle
  std::int64_t Components = 0;
  std::int64_t Euler = 0;              ///< of all components together
  std::vector<std::int64_t> Genus;     ///< of each component; only if closed and manifold
  std::vector<double> Volume;          ///< of each component; positive if oriented outwards
  std::vector<std::int64_t> Component; ///< of each triangle

  bool IsClosedManifold() const
  {
    return OpenEdges + CrowdedEdges + DegenerateTriangles + NonManifoldVertices +
      InconsistentEdges ==
      0;
  }
  std::int64_t TotalGenus() const;
  double TotalVolume() const;
};

SurfaceCheck CheckSurface(const TriangleMesh& mesh);

/// For messages of failed tests.
std::ostream& operator<<(std::ostream& os, const SurfaceCheck& check);

/// How often the surface winds around a point: 1 inside, 0 outside, for a point off the surface.
double WindingNumber(const TriangleMesh& mesh, const Point3& point);

/// Contour vertices that are no points of the mesh, within `tolerance` in each coordinate.
std::vector<Point3> FindMissingVertices(
  const Contours& contours, const TriangleMesh& mesh, double tolerance);

/// What the surface says about vertices of the grid, against what the contours say.
struct SideCheck
{
  std::int64_t Compared = 0; ///< vertices that do not lie on the surface
  std::int64_t Skipped = 0;
  std::vector<Point3> Wrong;
};

/**
 * At up to `maximum` random vertices of the grid: the surface has to enclose those, and only those,
 * that lie inside for at least two of the three slices through them. A slice says so by the
 * winding number of its contours; if they are trusted as drawn and run clockwise on the whole, they
 * bound the outside.
 */
SideCheck CheckGridVertices(const TriangleMesh& mesh, const Contours& contours,
  const SpatialGrid& grid, Orientation orientation, std::size_t maximum, std::uint64_t seed);

} // namespace support
} // namespace orthoslices

#endif
