// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace orthoslices
{
namespace support
{

TriangleMesh MeshOf(vtkPolyData* surface)
{
  TriangleMesh mesh;
  mesh.Points.resize(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, mesh.Points[i].data());
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, ids);
    mesh.Triangles.push_back({ -1, -1, -1 });
    for (vtkIdType i = 0; i < 3 && ids->GetNumberOfIds() == 3; ++i)
    {
      mesh.Triangles.back()[i] = ids->GetId(i);
    }
  }
  return mesh;
}

} // namespace support
} // namespace orthoslices
