// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/RoundnessLoad.h"

#include "Core/Sparse/BendingOperator.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// The smallest radius of curvature that counts, in widths of the cell.
constexpr double LeastRadius = 0.5;
/// How far a point may move, in edges.
constexpr double ShareOfEdge = 0.25;

/// Of each point, outwards, of unit length: the mean of the triangles' normals, weighted by their
/// angles.
Columns FindNormals(const SurfaceMesh& mesh)
{
  const CornerTable& corners = mesh.Corners;
  Columns normals = Columns::Zero(corners.PointCount(), 3);
  for (Index corner = 0; corner < corners.CornerCount(); ++corner)
  {
    if (!corners.IsAlive(corner))
    {
      continue;
    }
    const Index point = corners.VertexOf(corner);
    const Point3 u = mesh.InWorld(point, corners.StartOf(corner));
    const Point3 v = mesh.InWorld(point, corners.EndOf(corner));
    const Point3 normal = Cross(u, v);
    const double length = Length(normal);
    if (length > 0.0)
    {
      const double weight = std::atan2(length, Dot(u, v)) / length;
      normals.row(point) += weight * Eigen::RowVector3d(normal[0], normal[1], normal[2]);
    }
  }
  for (Index point = 0; point < corners.PointCount(); ++point)
  {
    const double length = normals.row(point).norm();
    normals.row(point) /= length > 0.0 ? length : 1.0;
  }
  return normals;
}

Columns PlacesOf(const SurfaceMesh& mesh)
{
  Columns places(mesh.Corners.PointCount(), 3);
  for (Index point = 0; point < mesh.Corners.PointCount(); ++point)
  {
    const Point3 place =
      mesh.Metric.IsWorld() ? mesh.Points[point] : mesh.Metric.ToWorld(mesh.Points[point]);
    places.row(point) << place[0], place[1], place[2];
  }
  return places;
}

/// The width of a cell between planes, of two families the greater one: the middle one of its three
/// extents.
double WidthOf(const Box3& cell)
{
  Point3 extent = cell.High - cell.Low;
  std::sort(extent.begin(), extent.end());
  return extent[1];
}
}

RoundnessLoad KeepRound(const BendingOperator& bending, const SurfaceMesh& mesh)
{
  const Index count = mesh.Corners.PointCount();
  RoundnessLoad load{ std::vector<Point3>(count, Point3{}), std::vector<double>(count, 0.0) };
  const Columns normals = FindNormals(mesh);
  const Columns curvature = bending.Laplacian * PlacesOf(mesh);
  const Columns turning = bending.Laplacian * normals;
  for (Index point = 0; point < count; ++point)
  {
    const double area = bending.Area[point];
    if (mesh.Fixed[point] || !mesh.Corners.IsUsed(point) || mesh.IsStretched(point) ||
      !(area > 0.0))
    {
      continue;
    }
    const double most = 1.0 / (LeastRadius * WidthOf(mesh.Cells[mesh.CellOf(point)]));
    // The sum of the squares of both principal curvatures, and their sum, whose square is at most
    // twice that.
    const double squares =
      std::clamp(-turning.row(point).dot(normals.row(point)) / area, 0.0, 2.0 * most * most);
    const double bound = std::sqrt(2.0 * squares);
    const double sum =
      std::clamp(-curvature.row(point).dot(normals.row(point)) / area, -bound, bound);
    const double force = area * sum * squares;
    const Point3 push{ force * normals(point, 0), force * normals(point, 1),
      force * normals(point, 2) };
    load.Force[point] = mesh.Metric.IsWorld() ? push : mesh.Metric.ToAxes(push);
    // The length of the edges of equal triangles around a point of this area.
    load.Reach[point] = ShareOfEdge * std::sqrt(2.0 / std::sqrt(3.0) * area);
  }
  return load;
}

RoundnessLoad KeepRound(const SurfaceMesh& mesh)
{
  return KeepRound(MakeBendingOperator(EdgeWeights::RoundCotangents, mesh), mesh);
}
}
