// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesGuideSurface_h
#define OrthoSlicesGuideSurface_h

#include "Core/Sparse/SurfaceMesh.h"

namespace orthoslices
{
/**
 * Has the surface pass through points that are known from elsewhere, such as contours of slices at
 * any angle: of the free points of the mesh, each that is the nearest one to a guide moves there and
 * is fixed, if that is no farther than `reach`. Points closer to contours than an edge are left to
 * these. Deterministic; time is the number of guides times that of points.
 */
void GuideSurface(const std::vector<Point3>& guides, double reach, SurfaceMesh& mesh);
}

#endif
