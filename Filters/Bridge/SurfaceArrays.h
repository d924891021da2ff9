// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Arrays that are computed from the finished triangles.
 */

#ifndef OrthoSlicesSurfaceArrays_h
#define OrthoSlicesSurfaceArrays_h

#include "Core/Base/Execution.h"
#include "Core/Base/Types.h"

class vtkPolyData;

namespace orthoslices
{
/// Point normals of the triangles around each point, or the given ones (x, y, z of each point, zero
/// or empty where there is none), unless the two contradict each other.
void AddNormals(vtkPolyData* surface, const std::vector<float>& smooth, const Execution& execution);

/// Point data "MeanCurvature" and "GaussianCurvature". REQUIRES: point normals.
void AddCurvatures(vtkPolyData* surface);

/// Field data on the shape of the triangles.
void AddQuality(vtkPolyData* surface, const Execution& execution);
}

#endif
