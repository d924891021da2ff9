// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CapLoops.h"

#include "vtkCellArray.h"
#include "vtkContourTriangulator.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <set>
#include <utility>

namespace orthoslices
{
namespace baselines
{
namespace
{

using Loops = std::vector<std::vector<vtkIdType>>;
using Triangle = std::array<vtkIdType, 3>;

//------------------------------------------------------------------------------
// Whether the sides that have no opposite are the loops' edges, each once.
bool IsBoundedBy(const std::vector<Triangle>& triangles, const Loops& loops)
{
  std::set<std::pair<vtkIdType, vtkIdType>> sides;
  for (const Triangle& t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto opposite = sides.find({ t[(k + 1) % 3], t[k] });
      if (opposite != sides.end())
      {
        sides.erase(opposite);
      }
      else if (!sides.insert({ t[k], t[(k + 1) % 3] }).second)
      {
        return false;
      }
    }
  }
  std::size_t edges = 0;
  for (const std::vector<vtkIdType>& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      if (sides.count({ loop[i], loop[(i + 1) % loop.size()] }) == 0)
      {
        return false;
      }
      ++edges;
    }
  }
  return edges == sides.size();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakePolygons(const Loops& loops, vtkPoints* points)
{
  vtkNew<vtkPoints> own; // of the loops only, in their order
  own->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const std::vector<vtkIdType>& loop : loops)
  {
    const vtkIdType first = own->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(loop.size() + 1));
    for (const vtkIdType id : loop)
    {
      lines->InsertCellPoint(own->InsertNextPoint(points->GetPoint(id)));
    }
    lines->InsertCellPoint(first);
  }
  auto polygons = vtkSmartPointer<vtkPolyData>::New();
  polygons->SetPoints(own);
  polygons->SetLines(lines);
  return polygons;
}

//------------------------------------------------------------------------------
// Triangles in either orientation, by ids of the surface.
std::vector<Triangle> Triangulate(const Loops& loops, vtkPoints* points)
{
  std::vector<vtkIdType> surfaceIds;
  for (const std::vector<vtkIdType>& loop : loops)
  {
    surfaceIds.insert(surfaceIds.end(), loop.begin(), loop.end());
  }
  vtkNew<vtkContourTriangulator> triangulator;
  triangulator->SetInputData(MakePolygons(loops, points));
  triangulator->TriangulationErrorDisplayOff();
  triangulator->Update();
  vtkCellArray* cells = triangulator->GetOutput()->GetPolys();
  std::vector<Triangle> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    triangles.push_back(
      { surfaceIds[ids->GetId(0)], surfaceIds[ids->GetId(1)], surfaceIds[ids->GetId(2)] });
  }
  return triangles;
}

//------------------------------------------------------------------------------
void Reverse(std::vector<Triangle>& triangles)
{
  for (Triangle& t : triangles)
  {
    std::swap(t[1], t[2]);
  }
}

//------------------------------------------------------------------------------
std::vector<Triangle> MakeFan(const std::vector<vtkIdType>& loop, vtkPoints* points)
{
  std::array<double, 3> centre{ 0.0, 0.0, 0.0 };
  for (const vtkIdType id : loop)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      centre[axis] += points->GetPoint(id)[axis] / static_cast<double>(loop.size());
    }
  }
  const vtkIdType hub = points->InsertNextPoint(centre.data());
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    triangles.push_back({ loop[i], loop[(i + 1) % loop.size()], hub });
  }
  return triangles;
}

} // anonymous namespace

//------------------------------------------------------------------------------
void CapLoops(
  const std::vector<std::vector<vtkIdType>>& loops, vtkPoints* points, vtkCellArray* cells)
{
  if (loops.empty())
  {
    return;
  }
  std::vector<Triangle> triangles = Triangulate(loops, points);
  if (!IsBoundedBy(triangles, loops))
  {
    Reverse(triangles);
  }
  if (!IsBoundedBy(triangles, loops))
  {
    if (loops.size() > 1)
    {
      for (const std::vector<vtkIdType>& loop : loops)
      {
        CapLoops({ loop }, points, cells);
      }
      return;
    }
    triangles = MakeFan(loops.front(), points);
  }
  for (const Triangle& triangle : triangles)
  {
    cells->InsertNextCell(3, triangle.data());
  }
}

} // namespace baselines
} // namespace orthoslices
