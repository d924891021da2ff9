// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSubdivideSurface_h
#define OrthoSlicesSubdivideSurface_h

#include "Core/Slicing/SliceSurface.h"
#include "Core/Sparse/SurfaceMesh.h"

namespace orthoslices
{
/**
 * Divides each triangle into four whose new corners lie on a curved surface through the old ones:
 * in the middle of the cubic curves that leave both ends of an edge at right angles to the normals
 * there (A. Vlachos et al., "Curved PN Triangles", 2001). Normals are those of the triangles
 * around, weighted by area. What flat triangles cut off of a ball becomes a quarter. Old points
 * stay, with their numbers; midpoints on contours stay on their slice; edges end straight where the
 * surface has a crease.
 */
TriangleSurface SubdivideSurface(const SurfaceMesh& mesh);
}

#endif
