// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/SurfaceArrays.h"

#include "Bridge/ExecuteWithVtk.h"
#include "Bridge/VisitTriangles.h"
#include "Core/Surface/EqualPoints.h"
#include "Core/Surface/PointNormals.h"
#include "Core/Surface/TriangleMeasures.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
void AddArray(const char* name, const std::vector<float>& values, vtkPointData* data)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

}

void AddNormals(vtkPolyData* surface, const std::vector<float>& smooth, const Execution& execution,
  const SharedPoints* shared)
{
  const vtkIdType count = surface->GetNumberOfPoints();
  const std::size_t parts = static_cast<std::size_t>(NumberOfThreads());
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  VisitTriangles(surface,
    [&](const auto* xyz, const auto* triangles, vtkIdType triangleCount)
    {
      ComputePointNormals(xyz, count, triangles, triangleCount, smooth, execution,
        normals->GetPointer(0), parts, shared);
    });
  surface->GetPointData()->SetNormals(normals);
}

void AddCurvatures(vtkPolyData* surface)
{
  auto* normals = vtkFloatArray::FastDownCast(surface->GetPointData()->GetNormals());
  const std::size_t points = static_cast<std::size_t>(surface->GetNumberOfPoints());
  Curvatures curvatures;
  VisitTriangles(surface,
    [&](const auto* xyz, const auto* triangles, vtkIdType count)
    { curvatures = MeasureCurvatures(xyz, points, normals->GetPointer(0), triangles, count); });
  AddArray("MeanCurvature", curvatures.Mean, surface->GetPointData());
  AddArray("GaussianCurvature", curvatures.Gaussian, surface->GetPointData());
}

void AddQuality(vtkPolyData* surface, const Execution& execution, const Ranks& ranks)
{
  TriangleQuality quality;
  VisitTriangles(surface,
    [&](const auto* xyz, const auto* triangles, vtkIdType count)
    { quality = JoinQualities(MeasureQuality(xyz, triangles, count, execution), count, ranks); });
  const auto add = [&](const char* name, double value)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    surface->GetFieldData()->AddArray(array);
  };
  add("SmallestAngle", quality.SmallestAngle);
  add("ShareOfTrianglesAbove20Degrees", quality.ShareAbove20Degrees);
  add("LargestAspectRatio", quality.LargestAspectRatio);
  vtkNew<vtkIdTypeArray> same;
  same->SetName("NumberOfPointsEqualInFloat");
  // Of points of several pieces, those of the first one count.
  auto* ghosts = vtkUnsignedCharArray::FastDownCast(
    surface->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  VisitTriangles(surface,
    [&](const auto* xyz, const auto*, vtkIdType)
    {
      same->InsertNextValue(CountEqualInFloat(xyz, surface->GetNumberOfPoints(), execution, ranks,
        ghosts != nullptr ? ghosts->GetPointer(0) : nullptr));
    });
  surface->GetFieldData()->AddArray(same);
}
}
