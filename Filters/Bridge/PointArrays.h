// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPointArrays_h
#define OrthoSlicesPointArrays_h

#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

namespace orthoslices
{
inline vtkSmartPointer<vtkPoints> NewPoints(bool doublePrecision, vtkIdType count)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(doublePrecision ? VTK_DOUBLE : VTK_FLOAT);
  points->SetNumberOfPoints(count);
  return points;
}

/// Copies coordinates to the points from number `first` on.
inline void CopyPoints(const std::vector<double>& xyz, vtkIdType first, vtkPoints* points)
{
  void* target = points->GetData()->GetVoidPointer(3 * first);
  if (points->GetDataType() == VTK_DOUBLE)
  {
    std::copy(xyz.begin(), xyz.end(), static_cast<double*>(target));
  }
  else
  {
    std::transform(xyz.begin(), xyz.end(), static_cast<float*>(target),
      [](double x) { return static_cast<float>(x); });
  }
}
}

#endif
