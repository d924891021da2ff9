// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesGuideSurface_h
#define OrthoSlicesGuideSurface_h

#include "Core/Sparse/SurfaceMesh.h"

namespace orthoslices
{
/**
 * Has the surface pass through points that are known from elsewhere, such as contours of slices at
 * any angle. For each guide, the nearest point of the mesh moves there and is fixed, if that is less
 * than `reach` (world units) away. Where it is the nearest one to several guides, the closest of these
 * counts; where it is fixed already, on a contour, the guide moves nothing. Deterministic; time is
 * the number of guides times that of points.
 */
void GuideSurface(const std::vector<Point3>& guides, double reach, SurfaceMesh& mesh);
}

#endif
