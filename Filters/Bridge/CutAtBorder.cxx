// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/CutAtBorder.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace orthoslices
{
namespace
{
/// Points of a plane are beside it by no more than so many steps of the precision once they are
/// turned.
constexpr double TurnedSteps = 16.0;

/// Keeps what lies below a coordinate of an axis, or above it.
class PlaneCutter
{
public:
  PlaneCutter(
    vtkPolyData* surface, const AxisFrame& frame, int axis, double coordinate, bool keepsBelow);
  void Run();

private:
  void AddTriangle(vtkIdType cell, const vtkIdType* corners);
  vtkIdType Copy(vtkIdType point);
  vtkIdType Cut(vtkIdType inside, vtkIdType outside);
  void PartFans(vtkIdType point, const std::vector<std::size_t>& triangles);
  void PartFans();

  vtkPolyData* Surface;
  int Axis;
  double Coordinate;
  bool IsWorld;                  ///< whether the axis is that of the world
  std::vector<double> Height;    ///< of the points over the plane, positive where they go
  std::vector<vtkIdType> Copies; ///< of the points; -1 if there is none yet
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> Cuts; ///< new points on edges
  vtkNew<vtkPoints> Points;
  std::vector<std::array<vtkIdType, 3>> Triangles;
  vtkNew<vtkPointData> PointArrays;
  vtkNew<vtkCellData> CellArrays;
};

PlaneCutter::PlaneCutter(
  vtkPolyData* surface, const AxisFrame& frame, int axis, double coordinate, bool keepsBelow)
  : Surface(surface)
  , Axis(axis)
  , Coordinate(coordinate)
  , IsWorld(frame.IsWorld())
  , Copies(surface->GetNumberOfPoints(), -1)
{
  const bool isFloat = surface->GetPoints()->GetDataType() == VTK_FLOAT;
  const double step = TurnedSteps *
    (isFloat ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon());
  for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
  {
    double p[3];
    surface->GetPoint(point, p);
    const double at = this->IsWorld ? p[axis] : Dot(frame.Normal(axis), Point3{ p[0], p[1], p[2] });
    const double height = keepsBelow ? at - coordinate : coordinate - at;
    // What lies on the plane before it is turned is beside it by rounding afterwards.
    const double rounding =
      this->IsWorld ? 0.0 : step * (std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]));
    this->Height.push_back(std::abs(height) <= rounding ? 0.0 : height);
  }
  this->Points->SetDataType(surface->GetPoints()->GetDataType());
  this->PointArrays->InterpolateAllocate(surface->GetPointData(), surface->GetNumberOfPoints());
  this->CellArrays->CopyAllocate(surface->GetCellData(), surface->GetNumberOfCells());
}

vtkIdType PlaneCutter::Copy(vtkIdType point)
{
  if (this->Copies[point] < 0)
  {
    this->Copies[point] = this->Points->InsertNextPoint(this->Surface->GetPoint(point));
    this->PointArrays->CopyData(this->Surface->GetPointData(), point, this->Copies[point]);
  }
  return this->Copies[point];
}

/// The point at which an edge passes the plane.
vtkIdType PlaneCutter::Cut(vtkIdType inside, vtkIdType outside)
{
  const auto added = this->Cuts.insert({ { inside, outside }, -1 });
  if (added.second)
  {
    const double share = this->Height[inside] / (this->Height[inside] - this->Height[outside]);
    double p[3], q[3];
    this->Surface->GetPoint(inside, p);
    this->Surface->GetPoint(outside, q);
    for (int i = 0; i < 3; ++i)
    {
      p[i] += share * (q[i] - p[i]);
    }
    if (this->IsWorld)
    {
      p[this->Axis] = this->Coordinate;
    }
    added.first->second = this->Points->InsertNextPoint(p);
    this->PointArrays->InterpolateEdge(
      this->Surface->GetPointData(), added.first->second, inside, outside, share);
  }
  return added.first->second;
}

void PlaneCutter::AddTriangle(vtkIdType cell, const vtkIdType* corners)
{
  std::vector<vtkIdType> polygon;
  for (int i = 0; i < 3; ++i)
  {
    const vtkIdType from = corners[i], to = corners[(i + 1) % 3];
    if (this->Height[from] <= 0.0)
    {
      polygon.push_back(this->Copy(from));
    }
    if (this->Height[from] < 0.0 && this->Height[to] > 0.0)
    {
      polygon.push_back(this->Cut(from, to));
    }
    if (this->Height[from] > 0.0 && this->Height[to] < 0.0)
    {
      polygon.push_back(this->Cut(to, from));
    }
  }
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    this->CellArrays->CopyData(
      this->Surface->GetCellData(), cell, static_cast<vtkIdType>(this->Triangles.size()));
    this->Triangles.push_back({ polygon[0], polygon[i - 1], polygon[i] });
  }
}

/// A point of the plane at which parts of the surface touch that have nothing else in common
/// becomes one for each, so that the boundary passes each of its points once.
void PlaneCutter::PartFans(vtkIdType point, const std::vector<std::size_t>& triangles)
{
  std::map<vtkIdType, std::size_t> after; // triangles by the corner that follows the point
  std::set<vtkIdType> ends;               // the corners before it
  const vtkIdType copy = this->Copies[point];
  const auto cornerAt = [&](std::size_t triangle, int further)
  {
    const auto& corners = this->Triangles[triangle];
    const auto at = std::find(corners.begin(), corners.end(), copy) - corners.begin();
    return corners[(at + further) % 3];
  };
  for (const std::size_t triangle : triangles)
  {
    after[cornerAt(triangle, 1)] = triangle;
    ends.insert(cornerAt(triangle, 2));
  }
  // The corners at which a part begins. The first part keeps the point.
  std::vector<vtkIdType> starts;
  for (const auto& corner : after)
  {
    if (ends.count(corner.first) == 0)
    {
      starts.push_back(corner.first);
    }
  }
  for (std::size_t i = 1; i < starts.size(); ++i)
  {
    const vtkIdType part = this->Points->InsertNextPoint(this->Surface->GetPoint(point));
    this->PointArrays->CopyData(this->Surface->GetPointData(), point, part);
    for (auto next = after.find(starts[i]); next != after.end();)
    {
      auto& corners = this->Triangles[next->second];
      const vtkIdType end = cornerAt(next->second, 2);
      std::replace(corners.begin(), corners.end(), copy, part);
      next = after.find(end);
    }
  }
}

/// The same for all points of the plane.
void PlaneCutter::PartFans()
{
  std::map<vtkIdType, std::vector<std::size_t>> around;
  std::map<vtkIdType, vtkIdType> points; // on the plane, by their copies
  for (std::size_t point = 0; point < this->Copies.size(); ++point)
  {
    if (this->Copies[point] >= 0 && this->Height[point] == 0.0)
    {
      points[this->Copies[point]] = static_cast<vtkIdType>(point);
    }
  }
  for (std::size_t triangle = 0; triangle < this->Triangles.size() && !points.empty(); ++triangle)
  {
    for (const vtkIdType corner : this->Triangles[triangle])
    {
      const auto at = points.find(corner);
      if (at != points.end())
      {
        around[at->second].push_back(triangle);
      }
    }
  }
  for (const auto& at : around)
  {
    this->PartFans(at.first, at.second);
  }
}

void PlaneCutter::Run()
{
  vtkCellArray* triangles = this->Surface->GetPolys();
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    triangles->GetCellAtId(cell, size, corners);
    // Points of triangles that go altogether are not copied.
    if (this->Height[corners[0]] < 0.0 || this->Height[corners[1]] < 0.0 ||
      this->Height[corners[2]] < 0.0)
    {
      this->AddTriangle(cell, corners);
    }
  }
  this->PartFans();
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : this->Triangles)
  {
    cells->InsertNextCell(3, triangle.data());
  }
  this->PointArrays->Squeeze();
  this->CellArrays->Squeeze();
  this->Surface->SetPoints(this->Points);
  this->Surface->SetPolys(cells);
  this->Surface->GetPointData()->ShallowCopy(this->PointArrays);
  this->Surface->GetCellData()->ShallowCopy(this->CellArrays);
}
}

void CutAtBorder(const Box3& border, const AxisFrame& frame, vtkPolyData* surface)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::isfinite(border.Low[axis]))
    {
      PlaneCutter(surface, frame, axis, border.Low[axis], false).Run();
    }
    if (std::isfinite(border.High[axis]))
    {
      PlaneCutter(surface, frame, axis, border.High[axis], true).Run();
    }
  }
}
}
