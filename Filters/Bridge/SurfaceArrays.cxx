// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/SurfaceArrays.h"

#include "Core/Surface/TriangleMeasures.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
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

/// Sums the area vectors of the triangles at each point; in a fixed order, so always the same.
template <typename Coordinate, typename Id>
void SumAreas(const Coordinate* xyz, const Id* triangle, vtkIdType count, float* normals)
{
  for (const Id* end = triangle + 3 * count; triangle != end; triangle += 3)
  {
    const Coordinate* a = xyz + 3 * static_cast<vtkIdType>(triangle[0]);
    const Coordinate* b = xyz + 3 * static_cast<vtkIdType>(triangle[1]);
    const Coordinate* c = xyz + 3 * static_cast<vtkIdType>(triangle[2]);
    const double ab[3] = { double(b[0]) - a[0], double(b[1]) - a[1], double(b[2]) - a[2] };
    const double ac[3] = { double(c[0]) - a[0], double(c[1]) - a[1], double(c[2]) - a[2] };
    const float area[3] = { static_cast<float>(ab[1] * ac[2] - ab[2] * ac[1]),
      static_cast<float>(ab[2] * ac[0] - ab[0] * ac[2]),
      static_cast<float>(ab[0] * ac[1] - ab[1] * ac[0]) };
    for (int corner = 0; corner < 3; ++corner)
    {
      float* normal = normals + 3 * static_cast<vtkIdType>(triangle[corner]);
      normal[0] += area[0];
      normal[1] += area[1];
      normal[2] += area[2];
    }
  }
}

void AddArray(const char* name, const std::vector<float>& values, vtkPointData* data)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

/// At each point, the sum of the area vectors at the corners of the triangles around: where these
/// are slivers, those of the next triangles decide.
template <typename Id>
std::vector<float> SumAround(
  const Id* triangle, vtkIdType count, vtkIdType points, const float* areas)
{
  std::vector<float> sums(3 * static_cast<std::size_t>(points), 0.0f);
  for (const Id* end = triangle + 3 * count; triangle != end; triangle += 3)
  {
    for (int k = 0; k < 3; ++k)
    {
      const float sum =
        areas[3 * triangle[0] + k] + areas[3 * triangle[1] + k] + areas[3 * triangle[2] + k];
      for (int corner = 0; corner < 3; ++corner)
      {
        sums[3 * triangle[corner] + k] += sum;
      }
    }
  }
  return sums;
}

/// Whether a normal is within 30 degrees of an area vector.
bool IsSimilar(const float* normal, const float* area)
{
  double product = 0.0, squared = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    product += double(normal[k]) * area[k];
    squared += double(area[k]) * area[k];
  }
  return product > 0.0 && product * product > 0.75 * squared;
}
}

void AddNormals(vtkPolyData* surface, const std::vector<float>& smooth, const Execution& execution)
{
  const vtkIdType count = surface->GetNumberOfPoints();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  normals->Fill(0.0);
  float* out = normals->GetPointer(0);
  std::vector<float> around;
  VisitTriangles(surface,
    [&](const auto* xyz, const auto* triangles, vtkIdType triangleCount)
    {
      SumAreas(xyz, triangles, triangleCount, out);
      if (!smooth.empty())
      {
        around = SumAround(triangles, triangleCount, count, out);
      }
    });
  execution.For(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        float* n = out + 3 * i;
        const float* s = smooth.empty() ? n : smooth.data() + 3 * i;
        if (!smooth.empty() && (IsSimilar(s, n) || IsSimilar(s, around.data() + 3 * i)))
        {
          std::copy_n(s, 3, n);
          continue;
        }
        const double length = std::hypot(double(n[0]), double(n[1]), double(n[2]));
        const double scale = length > 0.0 ? 1.0 / length : 0.0;
        std::transform(n, n + 3, n, [&](float x) { return static_cast<float>(scale * x); });
      }
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

void AddQuality(vtkPolyData* surface, const Execution& execution)
{
  TriangleQuality quality;
  VisitTriangles(surface,
    [&](const auto* xyz, const auto* triangles, vtkIdType count)
    { quality = MeasureQuality(xyz, triangles, count, execution); });
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
}
}
