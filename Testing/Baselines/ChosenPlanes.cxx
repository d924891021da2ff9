// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChosenPlanes.h"

#include "PlanarContours.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace orthoslices
{
namespace baselines
{
namespace
{

//------------------------------------------------------------------------------
std::size_t NearestTo(double coordinate, const std::vector<Slice>& slices)
{
  const auto distance = [coordinate](const Slice& s)
  { return std::abs(s.Coordinate - coordinate); };
  const auto nearest = std::min_element(slices.begin(), slices.end(),
    [&](const Slice& a, const Slice& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - slices.begin());
}

//------------------------------------------------------------------------------
// The middle one of the slices with contours, of which there is one.
std::size_t MiddleOfAll(const std::vector<Slice>& slices)
{
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    if (!slices[i].Loops.empty())
    {
      used.push_back(i);
    }
  }
  return used[used.size() / 2];
}

//------------------------------------------------------------------------------
// For each slice its number among the chosen ones, or -1.
std::vector<int> ChooseEvenly(const std::vector<Slice>& slices, std::size_t number)
{
  std::vector<int> places(slices.size(), -1);
  if (number == 1)
  {
    places[MiddleOfAll(slices)] = 0;
    return places;
  }
  number = std::min(number, slices.size());
  for (std::size_t i = 0; i < number; ++i)
  {
    places[(2 * i + 1) * slices.size() / (2 * number)] = static_cast<int>(i);
  }
  return places;
}

//------------------------------------------------------------------------------
// A family without contours, with the precision of SOURCE.
vtkSmartPointer<vtkPolyData> MakeFamily(vtkPolyData* source)
{
  auto family = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(source->GetPoints()->GetDataType());
  family->SetPoints(points);
  family->SetLines(vtkNew<vtkCellArray>());
  vtkNew<vtkIntArray> planes;
  planes->SetName("PlaneIndex");
  family->GetCellData()->AddArray(planes);
  return family;
}

//------------------------------------------------------------------------------
// Adds the points CONTOUR of SOURCE, as they are, as a closed polyline.
void AppendContour(vtkIdList* contour, vtkPolyData* source, vtkPolyData* family)
{
  vtkIdType size = contour->GetNumberOfIds();
  const bool isClosed = contour->GetId(0) == contour->GetId(size - 1);
  size -= isClosed ? 1 : 0;
  const vtkIdType first = family->GetNumberOfPoints();
  family->GetLines()->InsertNextCell(static_cast<int>(size + 1));
  for (vtkIdType i = 0; i < size; ++i)
  {
    family->GetLines()->InsertCellPoint(
      family->GetPoints()->InsertNextPoint(source->GetPoint(contour->GetId(i))));
  }
  family->GetLines()->InsertCellPoint(first);
}

//------------------------------------------------------------------------------
// Contours are filed by the slice that is nearest to their first point.
vtkSmartPointer<vtkPolyData> ChooseContours(vtkPolyData* source, int axis, std::size_t number)
{
  const std::vector<Slice> slices = ExtractSlices(source, axis);
  if (number == 0 || slices.empty())
  {
    return nullptr;
  }
  const std::vector<int> places = ChooseEvenly(slices, number);
  const vtkSmartPointer<vtkPolyData> family = MakeFamily(source);
  vtkNew<vtkIdList> contour;
  for (vtkIdType i = 0; i < source->GetNumberOfCells(); ++i)
  {
    source->GetCellPoints(i, contour);
    const int place = contour->GetNumberOfIds() < 3
      ? -1
      : places[NearestTo(source->GetPoint(contour->GetId(0))[axis], slices)];
    if (place >= 0)
    {
      AppendContour(contour, source, family);
      vtkIntArray::SafeDownCast(family->GetCellData()->GetArray("PlaneIndex"))
        ->InsertNextValue(place);
    }
  }
  return family->GetNumberOfLines() > 0 ? family : nullptr;
}

//------------------------------------------------------------------------------
int AxisOfMostPlanes(const SliceSets& slices)
{
  int best = 2;
  std::size_t most = 0;
  for (const int axis : { 2, 1, 0 })
  {
    const std::size_t number = ExtractSlices(slices.Families[axis], axis).size();
    if (number > most)
    {
      most = number;
      best = axis;
    }
  }
  return best;
}

} // anonymous namespace

//------------------------------------------------------------------------------
SliceSets ChoosePlanes(const SliceSets& slices, const std::array<int, 3>& numbers)
{
  SliceSets chosen;
  for (int axis = 0; axis < 3; ++axis)
  {
    chosen.Families[axis] =
      ChooseContours(slices.Families[axis], axis, static_cast<std::size_t>(numbers[axis]));
  }
  return chosen;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> RotateAxes(vtkPolyData* data, int steps)
{
  if (!data)
  {
    return nullptr;
  }
  auto rotated = vtkSmartPointer<vtkPolyData>::New();
  rotated->ShallowCopy(data);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double from[3], to[3];
    data->GetPoint(i, from);
    for (int axis = 0; axis < 3; ++axis)
    {
      to[(axis + steps) % 3] = from[axis];
    }
    points->SetPoint(i, to);
  }
  rotated->SetPoints(points);
  return rotated;
}

//------------------------------------------------------------------------------
AlongMostPlanes::AlongMostPlanes(std::unique_ptr<Baseline> method)
  : Method(std::move(method))
{
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> AlongMostPlanes::Reconstruct(const SliceSets& slices) const
{
  const int axis = AxisOfMostPlanes(slices);
  SliceSets stack;
  stack.Families[2] = RotateAxes(slices.Families[axis], 2 - axis);
  return RotateAxes(this->Method->Reconstruct(stack), 1 + axis);
}

} // namespace baselines
} // namespace orthoslices
