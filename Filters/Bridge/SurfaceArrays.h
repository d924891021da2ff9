// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Arrays that are computed from the finished triangles.
 */

#ifndef OrthoSlicesSurfaceArrays_h
#define OrthoSlicesSurfaceArrays_h

#include "Core/Base/Execution.h"
#include "Core/Base/Ranks.h"
#include "Core/Base/Types.h"

class vtkPolyData;

namespace orthoslices
{
struct SharedPoints;

/// Point normals of the triangles around each point, or the given ones (x, y, z of each point, zero
/// or empty where there is none), unless the two contradict each other. Of a piece with `shared`
/// points, those of the whole surface.
void AddNormals(vtkPolyData* surface, const std::vector<float>& smooth, const Execution& execution,
  const SharedPoints* shared = nullptr);

/// Point data "MeanCurvature" and "GaussianCurvature". REQUIRES: point normals.
void AddCurvatures(vtkPolyData* surface);

/// Field data on the shape of the triangles, of all processes that have a part of them.
void AddQuality(vtkPolyData* surface, const Execution& execution, const Ranks& ranks);
}

#endif
