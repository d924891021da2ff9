// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesImproveSurface_h
#define OrthoSlicesImproveSurface_h

#include "Core/Improve/MeshImprover.h"
#include "Core/Surface/LayOutTriangles.h"

#include <vector>

namespace orthoslices
{
/// Triangles that are left of a surface, each with the number of one that was where it is, by which
/// they are in ascending order.
struct TrianglesLeft
{
  std::vector<std::array<Index, 3>> Triangles;
  std::vector<Index> Numbers;
};

/// Those of an improved mesh, without what is beyond its borders.
TrianglesLeft ListLeft(const ImprovableMesh& mesh);

/// The surface's normals at all points; zero where it has none.
std::vector<Point3> ListNormals(
  const SurfaceNormals& normals, const Patches& patches, Index graphPoints, std::size_t count);

/// Of each triangle of a patch that is no smooth one, the number of its cycle; else -1.
std::vector<Index> ListPlain(const Patches& patches);

/// Sets Patches::Improved: those of the points that are corners, numbered from 0 on. Points after
/// the first `given` ones are new.
void SetImproved(const std::vector<Point3>& points, std::size_t given, const TrianglesLeft& left,
  Patches& patches);

/**
 * Shapes the triangles of a surface well (MeshImprover), so that no two meet but in their common
 * edge or vertex: changed triangles are tested against all near them, and where any may meet, the
 * surface stays as it was around that place, farther and farther until none do. If that does not
 * come to an end soon, all of it stays. The triangles become Patches::Improved; those of each patch
 * stay those of that patch. Several processes, of which each has the whole surface, share the work.
 * REQUIRES: the patches are laid out as triangles.
 */
void ImproveSurface(const CycleGeometry& geometry, const SurfaceNormals& normals,
  const ImprovementLimits& limits, const Execution& execution, Patches& patches,
  const Ranks& ranks = Ranks());
}

#endif
