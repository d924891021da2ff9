// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/ReadTriangles.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
namespace
{
bool HasTrianglesOnly(vtkPolyData* input)
{
  return input->GetNumberOfStrips() == 0 && input->GetPolys()->GetMaxCellSize() <= 3;
}
}

vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataSet* input)
{
  if (auto* surface = vtkPolyData::SafeDownCast(input))
  {
    return surface;
  }
  auto copy = vtk::TakeSmartPointer(input->NewInstance()); // without the caller's pipeline
  copy->ShallowCopy(input);
  vtkNew<vtkDataSetSurfaceFilter> faces;
  faces->SetInputData(copy);
  faces->Update();
  return faces->GetOutput();
}

TriangleSurface ReadTriangles(vtkPolyData* input)
{
  TriangleSurface surface;
  if (!input->GetPoints())
  {
    return surface;
  }
  vtkNew<vtkTriangleFilter> triangulate;
  if (!HasTrianglesOnly(input))
  {
    vtkNew<vtkPolyData> copy; // without the caller's pipeline
    copy->ShallowCopy(input);
    triangulate->SetInputData(copy);
    triangulate->PassVertsOff();
    triangulate->PassLinesOff();
    triangulate->Update();
    input = triangulate->GetOutput();
  }
  surface.Points.resize(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    input->GetPoint(static_cast<vtkIdType>(i), surface.Points[i].data());
  }
  surface.Triangles.reserve(static_cast<std::size_t>(input->GetNumberOfPolys()));
  vtkIdType size;
  const vtkIdType* ids;
  auto cell = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    cell->GetCurrentCell(size, ids);
    if (size == 3)
    {
      surface.Triangles.push_back(
        { static_cast<Index>(ids[0]), static_cast<Index>(ids[1]), static_cast<Index>(ids[2]) });
    }
  }
  return surface;
}

std::array<double, 2> BoundsOf(const TriangleSurface& surface, int axis)
{
  std::array<double, 2> bounds{ std::numeric_limits<double>::max(),
    std::numeric_limits<double>::lowest() };
  for (const auto& triangle : surface.Triangles)
  {
    for (const Index vertex : triangle)
    {
      bounds[0] = std::min(bounds[0], surface.Points[vertex][axis]);
      bounds[1] = std::max(bounds[1], surface.Points[vertex][axis]);
    }
  }
  return bounds;
}
}
