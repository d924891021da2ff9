// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlanarContours.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace baselines
{
namespace
{

//------------------------------------------------------------------------------
// One contour before it is sorted into its slice.
struct Contour
{
  double Coordinate = 0.0;
  int PlaneIndex = -1; // -1 if unknown
  Loop Vertices;
};

//------------------------------------------------------------------------------
// Equal consecutive points become one.
Contour ReadCell(vtkPolyData* contours, int axis, vtkIdType size, const vtkIdType* ids)
{
  Contour contour;
  Loop& loop = contour.Vertices;
  for (vtkIdType i = 0; i < size; ++i)
  {
    double p[3];
    contours->GetPoint(ids[i], p);
    contour.Coordinate += p[axis] / static_cast<double>(size);
    const Point2 point{ p[(axis + 1) % 3], p[(axis + 2) % 3] };
    if (loop.empty() || loop.back() != point)
    {
      loop.push_back(point);
    }
  }
  while (loop.size() > 1 && loop.front() == loop.back())
  {
    loop.pop_back();
  }
  return contour;
}

//------------------------------------------------------------------------------
// FIRSTCELL is the number of the first of CELLS among all cells.
void ReadCells(vtkPolyData* contours, int axis, vtkCellArray* cells, vtkIdType firstCell,
  std::vector<Contour>& result)
{
  vtkDataArray* planes = contours->GetCellData()->GetArray("PlaneIndex");
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    Contour contour = ReadCell(contours, axis, size, ids);
    if (planes)
    {
      const vtkIdType id = firstCell + cell->GetCurrentCellId();
      contour.PlaneIndex = static_cast<int>(planes->GetComponent(id, 0));
    }
    if (contour.Vertices.size() >= 3)
    {
      result.push_back(std::move(contour));
    }
  }
}

//------------------------------------------------------------------------------
// Empty slices between two planes whose indices are not consecutive.
void InsertEmptySlices(double below, double above, int missing, std::vector<Slice>& slices)
{
  for (int i = 1; i <= missing; ++i)
  {
    slices.push_back({ below + i * (above - below) / (missing + 1), {} });
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::array<double, 3> PlaceInSpace(int axis, double coordinate, const Point2& point)
{
  std::array<double, 3> position;
  position[axis] = coordinate;
  position[(axis + 1) % 3] = point[0];
  position[(axis + 2) % 3] = point[1];
  return position;
}

//------------------------------------------------------------------------------
double SignedArea(const Loop& loop)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point2& a = loop[i];
    const Point2& b = loop[(i + 1) % loop.size()];
    twice += (a[0] - loop[0][0]) * (b[1] - loop[0][1]) - (a[1] - loop[0][1]) * (b[0] - loop[0][0]);
  }
  return 0.5 * twice;
}

//------------------------------------------------------------------------------
double Perimeter(const Loop& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point2& a = loop[i];
    const Point2& b = loop[(i + 1) % loop.size()];
    length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return length;
}

//------------------------------------------------------------------------------
bool IsInside(const Point2& point, const Loop& loop)
{
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point2& a = loop[i];
    const Point2& b = loop[(i + 1) % loop.size()];
    if ((a[1] <= point[1]) != (b[1] <= point[1]))
    {
      const double along = (point[1] - a[1]) / (b[1] - a[1]);
      inside ^= point[0] < a[0] + along * (b[0] - a[0]);
    }
  }
  return inside;
}

//------------------------------------------------------------------------------
std::vector<Slice> ExtractSlices(vtkPolyData* contours, int axis)
{
  std::vector<Contour> read;
  if (!contours || contours->GetNumberOfPoints() == 0)
  {
    return {};
  }
  const vtkIdType firstLine = contours->GetNumberOfVerts();
  const vtkIdType firstPolygon = firstLine + contours->GetNumberOfLines();
  ReadCells(contours, axis, contours->GetLines(), firstLine, read);
  ReadCells(contours, axis, contours->GetPolys(), firstPolygon, read);
  std::stable_sort(read.begin(), read.end(),
    [](const Contour& a, const Contour& b) { return a.Coordinate < b.Coordinate; });

  const double tolerance = 1e-6 * contours->GetLength();
  std::vector<Slice> slices;
  for (std::size_t i = 0; i < read.size(); ++i)
  {
    if (slices.empty() || read[i].Coordinate - slices.back().Coordinate > tolerance)
    {
      if (i > 0)
      {
        const int missing = read[i].PlaneIndex - read[i - 1].PlaneIndex - 1;
        InsertEmptySlices(read[i - 1].Coordinate, read[i].Coordinate, missing, slices);
      }
      slices.push_back({ read[i].Coordinate, {} });
    }
    slices.back().Loops.push_back(std::move(read[i].Vertices));
  }
  return slices;
}

//------------------------------------------------------------------------------
std::vector<int> NestingDepths(const Slice& slice)
{
  std::vector<int> depths(slice.Loops.size(), 0);
  for (std::size_t i = 0; i < slice.Loops.size(); ++i)
  {
    for (std::size_t j = 0; j < slice.Loops.size(); ++j)
    {
      depths[i] += i != j && IsInside(slice.Loops[i].front(), slice.Loops[j]);
    }
  }
  return depths;
}

//------------------------------------------------------------------------------
void OrientByNesting(Slice& slice)
{
  const std::vector<int> depths = NestingDepths(slice);
  for (std::size_t i = 0; i < slice.Loops.size(); ++i)
  {
    const bool counterClockwise = SignedArea(slice.Loops[i]) > 0.0;
    if (counterClockwise != (depths[i] % 2 == 0))
    {
      std::reverse(slice.Loops[i].begin(), slice.Loops[i].end());
    }
  }
}

} // namespace baselines
} // namespace orthoslices
