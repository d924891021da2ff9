// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/AppendData.h"

#include "Bridge/PointArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <limits>
#include <set>
#include <string>

namespace orthoslices
{
namespace
{
/// Consecutive tuples of the arrays of one part.
struct Range
{
  vtkDataSetAttributes* Data;
  vtkIdType Begin, Count;
};

void FillZero(vtkIdType begin, vtkIdType count, vtkAbstractArray* array)
{
  const bool isText = vtkStringArray::SafeDownCast(array) != nullptr;
  for (vtkIdType i = begin * array->GetNumberOfComponents();
       i < (begin + count) * array->GetNumberOfComponents(); ++i)
  {
    array->SetVariantValue(i, isText ? vtkVariant("") : vtkVariant(0));
  }
}

/// The array `name` of all ranges, made like `like`.
vtkSmartPointer<vtkAbstractArray> Concatenate(
  const std::vector<Range>& ranges, vtkAbstractArray* like, vtkIdType total)
{
  auto array = vtkSmartPointer<vtkAbstractArray>::Take(like->NewInstance());
  array->SetName(like->GetName());
  array->SetNumberOfComponents(like->GetNumberOfComponents());
  array->SetNumberOfTuples(total);
  vtkIdType first = 0;
  for (const Range& range : ranges)
  {
    vtkAbstractArray* source = range.Data->GetAbstractArray(like->GetName());
    if (range.Count > 0 && source != nullptr)
    {
      array->InsertTuples(first, range.Count, range.Begin, source);
    }
    else
    {
      FillZero(first, range.Count, array);
    }
    first += range.Count;
  }
  return array;
}

/// All arrays of all ranges.
void AppendArrays(const std::vector<Range>& ranges, vtkDataSetAttributes* whole)
{
  vtkIdType total = 0;
  for (const Range& range : ranges)
  {
    total += range.Count;
  }
  std::set<std::string> done;
  for (const Range& range : ranges)
  {
    for (int i = 0; i < range.Data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = range.Data->GetAbstractArray(i);
      if (done.insert(array->GetName()).second)
      {
        whole->AddArray(Concatenate(ranges, array, total));
      }
    }
  }
}

/// Cells of one kind of all parts.
template <typename CellsOf>
vtkSmartPointer<vtkCellArray> AppendCells(const std::vector<vtkPolyData*>& parts, CellsOf&& cellsOf)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  vtkIdType ids = 0, points = 0;
  for (vtkPolyData* part : parts)
  {
    ids += cellsOf(part)->GetNumberOfConnectivityIds();
  }
  if (ids < std::numeric_limits<std::int32_t>::max())
  {
    cells->Use32BitStorage();
  }
  for (vtkPolyData* part : parts)
  {
    cells->Append(cellsOf(part), points);
    points += part->GetNumberOfPoints();
  }
  return cells;
}

void AppendPoints(const std::vector<vtkPolyData*>& parts, vtkPolyData* whole)
{
  vtkIdType count = 0;
  for (vtkPolyData* part : parts)
  {
    count += part->GetNumberOfPoints();
  }
  const bool isDouble = !parts.empty() && parts.front()->GetPoints()->GetDataType() == VTK_DOUBLE;
  auto points = NewPoints(isDouble, count);
  std::vector<Range> ranges;
  vtkIdType first = 0;
  for (vtkPolyData* part : parts)
  {
    points->InsertPoints(first, part->GetNumberOfPoints(), 0, part->GetPoints());
    ranges.push_back({ part->GetPointData(), 0, part->GetNumberOfPoints() });
    first += part->GetNumberOfPoints();
  }
  whole->SetPoints(points);
  AppendArrays(ranges, whole->GetPointData());
}
}

void AppendPolyData(const std::vector<vtkPolyData*>& parts, vtkPolyData* whole)
{
  AppendPoints(parts, whole);
  whole->SetVerts(AppendCells(parts, [](vtkPolyData* part) { return part->GetVerts(); }));
  whole->SetLines(AppendCells(parts, [](vtkPolyData* part) { return part->GetLines(); }));
  whole->SetPolys(AppendCells(parts, [](vtkPolyData* part) { return part->GetPolys(); }));
  std::vector<Range> ranges;
  for (vtkPolyData* part : parts)
  {
    ranges.push_back({ part->GetCellData(), 0, part->GetNumberOfVerts() });
  }
  for (vtkPolyData* part : parts)
  {
    ranges.push_back({ part->GetCellData(), part->GetNumberOfVerts(), part->GetNumberOfLines() });
  }
  for (vtkPolyData* part : parts)
  {
    const vtkIdType first = part->GetNumberOfVerts() + part->GetNumberOfLines();
    ranges.push_back({ part->GetCellData(), first, part->GetNumberOfPolys() });
  }
  AppendArrays(ranges, whole->GetCellData());
}

void AppendTables(const std::vector<vtkTable*>& parts, vtkTable* whole)
{
  std::vector<Range> ranges;
  for (vtkTable* part : parts)
  {
    ranges.push_back({ part->GetRowData(), 0, part->GetNumberOfRows() });
  }
  AppendArrays(ranges, whole->GetRowData());
}
}
