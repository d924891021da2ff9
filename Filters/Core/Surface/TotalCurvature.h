// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTotalCurvature_h
#define OrthoSlicesTotalCurvature_h

#include "Core/Surface/LayOutTriangles.h"

namespace orthoslices
{
/// The integral of the absolute mean curvature over a closed surface, a length: half of the sum over
/// all sides of triangles of their length times the angle by which the surface turns there. 2 pi
/// times the diameter for a ball; the rim of a notch adds half of its length times the angle.
double TotalCurvature(const SurfaceTriangles& surface);
}

#endif
