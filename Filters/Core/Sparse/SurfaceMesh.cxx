// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SurfaceMesh.h"

#include "Core/Graph/CycleGeometry.h"

namespace orthoslices
{
namespace
{
std::vector<Point3> ListPoints(const NodeGraph& graph, const Patches& patches)
{
  std::vector<Point3> points;
  const auto append = [&](const std::vector<double>& values)
  {
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
    {
      points.push_back({ values[i], values[i + 1], values[i + 2] });
    }
  };
  append(graph.Points);
  append(patches.CentralPoints);
  append(ListOtherPoints(patches));
  return points;
}

std::vector<std::array<Index, 3>> ListTriangles(
  const CycleGeometry& geometry, const Patches& patches, const Execution& execution)
{
  std::vector<std::int32_t> ids(3 * static_cast<std::size_t>(patches.TriangleCount()));
  WriteTriangles(patches, geometry, execution, ids.data());
  std::vector<std::array<Index, 3>> triangles(ids.size() / 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    triangles[t] = { ids[3 * t], ids[3 * t + 1], ids[3 * t + 2] };
  }
  return triangles;
}

/// Where points of a cell may go.
Box3 BoundCell(const SpatialGrid& grid, const Box3& contours, const std::array<Index, 3>& cell)
{
  Box3 box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double beyond = 0.5 * grid.MeanSpacing(axis);
    const Index slab = cell[axis];
    const double margin = grid.Margin(axis, slab);
    box.Low[axis] =
      slab > 0 ? grid.Planes[axis][slab - 1] + margin : contours.Low[axis] - beyond;
    box.High[axis] = slab < grid.Count(axis) ? grid.Planes[axis][slab] - margin
                                             : contours.High[axis] + beyond;
  }
  return box;
}
}

SurfaceMesh MakeSurfaceMesh(
  const CycleGeometry& geometry, const Patches& patches, const Execution& execution)
{
  std::vector<Point3> points = ListPoints(geometry.Graph, patches);
  SurfaceMesh mesh{ CornerTable(static_cast<Index>(points.size()),
                      ListTriangles(geometry, patches, execution)),
    std::move(points), {}, {}, {}, {} };
  mesh.Fixed.assign(mesh.Points.size(), 0);
  mesh.Crease.assign(mesh.Points.size(), 0);
  std::fill_n(mesh.Fixed.begin(), geometry.Graph.Count(), std::uint8_t(1));
  Box3 contours;
  for (Index point = 0; point < geometry.Graph.Count(); ++point)
  {
    contours.Add(mesh.Points[point]);
  }
  std::vector<Index> border, places;
  mesh.Cell.resize(static_cast<std::size_t>(patches.TriangleCount()));
  for (Index cycle = 0; cycle < geometry.Cycles.Count(); ++cycle)
  {
    mesh.Cells.push_back(BoundCell(geometry.Grid, contours, geometry.Cycles.Cell[cycle]));
    std::fill(mesh.Cell.begin() + patches.Offsets[cycle],
      mesh.Cell.begin() + patches.Offsets[cycle + 1], cycle);
    geometry.GetBoundary(cycle, border, places);
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      const Index edge = mesh.Corners.FindEdge(border[i], border[(i + 1) % border.size()]);
      if (edge >= 0)
      {
        mesh.Corners.MarkCurve(edge);
      }
    }
  }
  return mesh;
}
}
