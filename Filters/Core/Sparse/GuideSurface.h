// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesGuideSurface_h
#define OrthoSlicesGuideSurface_h

#include "Core/Sparse/GuideCurves.h"
#include "Core/Sparse/SurfaceMesh.h"

namespace orthoslices
{
/**
 * Has a surface pass through contours of other slices. Slice by slice, the mesh is cut along the
 * plane of the slice. What lies on the plane then runs from contour to contour of the surface, as
 * the pieces of the slice do. Where a piece and a part of the cut are in the same slab of the
 * stack, or cell of several families, run in the same direction, and are each other's closest by
 * their ends, which are within `reach` (world units) in the sum, that part becomes a curve on the
 * mesh: its points move onto the piece, at the same share of its length, and are fixed, with an
 * edge for every `edgeLength` of the piece at least. Points of slices before stay where they are;
 * where contours of two slices do not meet, the points between change from one to the other evenly.
 *
 * Pieces without such a part guide nothing. Returns the number of pieces that do, and sets that of
 * each slice. Deterministic; time
 * is the number of slices times that of triangles, and of pieces of a slice squared.
 */
Index GuideSurface(GuideCurves& guides, double reach, double edgeLength, SurfaceMesh& mesh);
}

#endif
