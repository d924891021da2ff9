// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/WriteContours.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <utility>

namespace orthoslices
{
namespace
{
/// Points of all contours of one axis, plane by plane.
template <typename ArrayType>
void WritePoints(int axis, const std::vector<double>& planes,
  const std::vector<PlaneContours>& contours, vtkIdType count, vtkPoints* points)
{
  using ValueType = typename ArrayType::ValueType;
  vtkNew<ArrayType> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  ValueType* point = coordinates->GetPointer(0);
  for (std::size_t plane = 0; plane < planes.size(); ++plane)
  {
    for (std::size_t i = 0; i < contours[plane].U.size(); ++i, point += 3)
    {
      point[axis] = static_cast<ValueType>(planes[plane]);
      point[FirstAxis(axis)] = static_cast<ValueType>(contours[plane].U[i]);
      point[SecondAxis(axis)] = static_cast<ValueType>(contours[plane].V[i]);
    }
  }
  points->SetData(coordinates);
}

/// Polylines that end where they start, with the cell arrays.
void WriteLines(const std::vector<double>& planes, const std::vector<PlaneContours>& contours,
  vtkPolyData* output)
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  vtkNew<vtkIntArray> index;
  index->SetName("PlaneIndex");
  vtkNew<vtkDoubleArray> coordinate;
  coordinate->SetName("PlaneCoordinate");
  vtkIdType first = 0;
  offsets->InsertNextValue(0);
  for (std::size_t plane = 0; plane < planes.size(); ++plane)
  {
    for (Index i = 0; i < contours[plane].Count(); ++i)
    {
      const vtkIdType end = first + contours[plane].Offsets[i + 1] - contours[plane].Offsets[i];
      for (vtkIdType id = first; id < end; ++id)
      {
        connectivity->InsertNextValue(id);
      }
      connectivity->InsertNextValue(first);
      offsets->InsertNextValue(connectivity->GetNumberOfValues());
      index->InsertNextValue(static_cast<int>(plane));
      coordinate->InsertNextValue(planes[plane]);
      first = end;
    }
  }
  vtkNew<vtkCellArray> lines;
  lines->SetData(offsets, connectivity);
  output->SetLines(lines);
  output->GetCellData()->AddArray(index);
  output->GetCellData()->AddArray(coordinate);
}
}

void WriteContours(int axis, Precision precision, const std::vector<double>& planes,
  const std::vector<PlaneContours>& contours, vtkPolyData* output)
{
  vtkIdType count = 0;
  for (const PlaneContours& plane : contours)
  {
    count += static_cast<vtkIdType>(plane.U.size());
  }
  vtkNew<vtkPoints> points;
  if (precision == Precision::Double)
  {
    WritePoints<vtkDoubleArray>(axis, planes, contours, count, points);
  }
  else
  {
    WritePoints<vtkFloatArray>(axis, planes, contours, count, points);
  }
  output->SetPoints(points);
  WriteLines(planes, contours, output);
  vtkNew<vtkDoubleArray> all;
  all->SetName("PlaneCoordinates");
  all->SetNumberOfValues(static_cast<vtkIdType>(planes.size()));
  std::copy(planes.begin(), planes.end(), all->GetPointer(0));
  output->GetFieldData()->AddArray(all);
}

void WriteContours(int axis, Precision precision, const std::vector<double>& planes,
  std::vector<LabelContours>&& contours, int labelType, vtkPolyData* output)
{
  std::vector<PlaneContours> plain;
  const auto labels = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(labelType));
  labels->SetName("Label");
  for (LabelContours& plane : contours)
  {
    for (const double label : plane.Labels)
    {
      labels->InsertNextTuple1(label);
    }
    plain.push_back(std::move(plane.Contours));
  }
  WriteContours(axis, precision, planes, plain, output);
  output->GetCellData()->AddArray(labels);
}
}
