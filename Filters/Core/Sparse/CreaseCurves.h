// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCreaseCurves_h
#define OrthoSlicesCreaseCurves_h

#include "Core/Sparse/SurfaceMesh.h"

namespace orthoslices
{
/// Has the mesh keep the corners of its contours, at which edges of the object may end.
void KeepCorners(std::vector<ContourCorner>&& corners, SurfaceMesh& mesh);

/**
 * Edges of the object from corner to corner (our own addition). Where two contours around a patch
 * have corners that go on in each other, the surface has an edge between them: bent least without
 * it, it would be round between the slices, and dented beside every corner.
 *
 * Two corners of a patch (SurfaceMesh::ContourCorners) belong together if each is the other's
 * nearest among those that lie on other slices, turn to the same side and about as sharply, point
 * about the same way, and are at most one and a half times as far off as the slices are apart
 * there. Their edge becomes a curve on the mesh, whose points are fixed and are creases: straight,
 * or a cubic where it goes on beyond both ends (Catmull and Rom). Corners between which no path of
 * edges near the straight line is left have none.
 */
void DrawCreases(SurfaceMesh& mesh);
}

#endif
