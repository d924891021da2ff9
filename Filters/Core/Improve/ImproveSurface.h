// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesImproveSurface_h
#define OrthoSlicesImproveSurface_h

#include "Core/Improve/MeshImprover.h"
#include "Core/Surface/LayOutTriangles.h"

namespace orthoslices
{
/**
 * Shapes the triangles of a surface well (MeshImprover), so that no two meet but in their common
 * edge or vertex: changed triangles are tested against all near them, and where any may meet, the
 * surface stays as it was around that place, farther and farther until none do. If that does not
 * come to an end soon, all of it stays. The triangles become Patches::Improved; those of each patch
 * stay those of that patch.
 * REQUIRES: the patches are laid out as triangles.
 */
void ImproveSurface(const CycleGeometry& geometry, const SurfaceNormals& normals,
  const ImprovementLimits& limits, const Execution& execution, Patches& patches);
}

#endif
