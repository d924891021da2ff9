// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPointArrays_h
#define OrthoSlicesPointArrays_h

#include "Core/Base/Execution.h"

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
inline void CopyPoints(const double* first, const double* last, vtkIdType target, vtkPoints* points)
{
  void* to = points->GetData()->GetVoidPointer(3 * target);
  if (points->GetDataType() == VTK_DOUBLE)
  {
    std::copy(first, last, static_cast<double*>(to));
  }
  else
  {
    std::transform(
      first, last, static_cast<float*>(to), [](double x) { return static_cast<float>(x); });
  }
}

/// The same of all coordinates, in parallel.
inline void CopyPoints(
  const std::vector<double>& xyz, vtkIdType target, const Execution& execution, vtkPoints* points)
{
  execution.For(xyz.size() / 3,
    [&](std::size_t begin, std::size_t end)
    {
      CopyPoints(xyz.data() + 3 * begin, xyz.data() + 3 * end,
        target + static_cast<vtkIdType>(begin), points);
    });
}
}

#endif
