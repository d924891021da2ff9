// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesVisitTriangles_h
#define OrthoSlicesVisitTriangles_h

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace orthoslices
{
/// Calls visit(coordinates, point ids, number of triangles) with the types of the surface.
template <typename Visit>
void VisitTriangles(vtkPolyData* surface, Visit&& visit)
{
  vtkCellArray* cells = surface->GetPolys();
  const vtkIdType count = cells->GetNumberOfCells();
  const auto withIds = [&](const auto* xyz)
  {
    if (cells->IsStorage64Bit())
    {
      visit(xyz, cells->GetConnectivityArray64()->GetPointer(0), count);
    }
    else
    {
      visit(xyz, cells->GetConnectivityArray32()->GetPointer(0), count);
    }
  };
  vtkDataArray* points = surface->GetPoints()->GetData();
  if (auto* doubles = vtkDoubleArray::FastDownCast(points))
  {
    withIds(doubles->GetPointer(0));
  }
  else
  {
    withIds(vtkFloatArray::FastDownCast(points)->GetPointer(0));
  }
}
}

#endif
