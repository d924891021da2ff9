// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/PassPointData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Point data of the output that take values of those arrays of the input that have values between
/// two points. Ids and marks of ghosts are those of points that there are no more.
void Allocate(vtkPointData* input, vtkPointData* usable, vtkPolyData* output)
{
  usable->ShallowCopy(input);
  for (int i = usable->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (usable->GetArray(i) == nullptr || usable->GetArray(i) == usable->GetGlobalIds() ||
      usable->GetArray(i) == usable->GetPedigreeIds())
    {
      usable->RemoveArray(i);
    }
  }
  usable->RemoveArray("vtkGhostType");
  output->GetPointData()->InterpolateAllocate(usable, output->GetNumberOfPoints());
}

/// The two samples around a coordinate, at most the first and last one, and the share of the second.
struct Neighbors
{
  Neighbors(const SampleAxis& axis, double coordinate)
  {
    const auto begin = axis.Coordinates.begin() + 1, end = axis.Coordinates.end() - 1;
    const Index above = static_cast<Index>(std::upper_bound(begin, end, coordinate) - begin);
    this->First = std::max<Index>(above - 1, 0);
    this->Second = std::min(above, axis.Count() - 1);
    const double width = axis.Coordinate(this->Second) - axis.Coordinate(this->First);
    this->Share = width > 0.0 ? (coordinate - axis.Coordinate(this->First)) / width : 0.0;
  }

  Index First, Second;
  double Share;
};
}

void PassPointData(
  vtkPointData* input, const std::vector<PlaneContours>& contours, vtkPolyData* output)
{
  vtkNew<vtkPointData> usable;
  Allocate(input, usable, output);
  vtkIdType point = 0;
  for (const PlaneContours& plane : contours)
  {
    for (const EdgePlace& edge : plane.Edges)
    {
      output->GetPointData()->InterpolateEdge(usable, point++, edge.From, edge.To, edge.Fraction);
    }
  }
}

void PassSampleData(vtkPointData* input, const SampleGrid& grid, int axis,
  const std::vector<Index>& samples, vtkPolyData* output)
{
  vtkNew<vtkPointData> usable;
  Allocate(input, usable, output);
  const SampleAxis& u = grid.Axes[FirstAxis(axis)];
  const SampleAxis& v = grid.Axes[SecondAxis(axis)];
  vtkDataArray* plane = output->GetCellData()->GetArray("PlaneIndex");
  vtkNew<vtkIdList> ids, corners;
  corners->SetNumberOfIds(4);
  for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
  {
    output->GetLines()->GetCellAtId(line, ids);
    const Index sample = samples[static_cast<std::size_t>(plane->GetComponent(line, 0))];
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      double x[3];
      output->GetPoint(ids->GetId(i), x);
      const Neighbors along(u, x[FirstAxis(axis)]), across(v, x[SecondAxis(axis)]);
      const vtkIdType start = grid.First + sample * grid.Axes[axis].Stride;
      corners->SetId(0, start + along.First * u.Stride + across.First * v.Stride);
      corners->SetId(1, start + along.Second * u.Stride + across.First * v.Stride);
      corners->SetId(2, start + along.First * u.Stride + across.Second * v.Stride);
      corners->SetId(3, start + along.Second * u.Stride + across.Second * v.Stride);
      double weights[] = { (1.0 - along.Share) * (1.0 - across.Share),
        along.Share * (1.0 - across.Share), (1.0 - along.Share) * across.Share,
        along.Share * across.Share };
      output->GetPointData()->InterpolatePoint(usable, ids->GetId(i), corners, weights);
    }
  }
  // The scalars that were cut are the same all along: nothing to color by.
  output->GetPointData()->SetActiveScalars(nullptr);
}
}
