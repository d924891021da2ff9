// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesWriteContours_h
#define OrthoSlicesWriteContours_h

#include "Core/Slicing/SliceLabels.h"

#include <vector>

class vtkPolyData;

namespace orthoslices
{
/**
 * An output of vtkOrthogonalSlicer: the contours on planes across `axis`, one closed polyline each,
 * with the cell arrays "PlaneIndex" and "PlaneCoordinate" and the field array "PlaneCoordinates".
 * `contours` has one entry for each of the planes, which ascend.
 */
void WriteContours(int axis, Precision precision, const std::vector<double>& planes,
  const std::vector<PlaneContours>& contours, vtkPolyData* output);

/// The same with the cell array "Label" of the VTK type `labelType`.
void WriteContours(int axis, Precision precision, const std::vector<double>& planes,
  std::vector<LabelContours>&& contours, int labelType, vtkPolyData* output);
}

#endif
