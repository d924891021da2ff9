// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the points of a model or an image carry, on the vertices of its contours: interpolated
 * linearly, as vtkCutter does it. Arrays that have no values in between, such as those of strings,
 * are left out.
 */

#ifndef OrthoSlicesPassPointData_h
#define OrthoSlicesPassPointData_h

#include "Bridge/ReadSamples.h"
#include "Core/Slicing/PlaneContours.h"

#include <vector>

class vtkPointData;
class vtkPolyData;

namespace orthoslices
{
/// From the ends of the edges that the vertices lie on. REQUIRES: contours with Edges, and `output`
/// as from WriteContours of them.
void PassPointData(
  vtkPointData* input, const std::vector<PlaneContours>& contours, vtkPolyData* output);

/**
 * From the samples around each vertex, which lies on the plane of one sample across `axis`; on the
 * padding, from the nearest ones. REQUIRES: `output` as from WriteContours, before it is moved to the
 * world, of contours on the planes of `samples`.
 */
void PassSampleData(vtkPointData* input, const SampleGrid& grid, int axis,
  const std::vector<Index>& samples, vtkPolyData* output);
}

#endif
