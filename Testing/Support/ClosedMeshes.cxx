// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/ClosedMeshes.h"

#include "Core/Sparse/FairSurface.h"
#include "Core/Sparse/RemeshSurface.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace support
{
namespace
{
const double Turn = 2.0 * std::acos(-1.0);

SurfaceMesh Plain(const PlainMesh& mesh)
{
  const std::size_t points = mesh.Points.size();
  SurfaceMesh surface{ CornerTable(static_cast<Index>(points), mesh.Triangles), mesh.Points,
    std::vector<std::uint8_t>(points, 0), std::vector<std::uint8_t>(points, 0),
    std::vector<Index>(mesh.Triangles.size(), 0), {}, AxisFrame(), -1,
    std::vector<Point3>(points, SurfaceMesh::Unstretched) };
  return surface;
}

Box3 BoxOf(double room, double low, double high)
{
  Box3 box;
  box.Low = { -room, -room, low };
  box.High = { room, room, high };
  return box;
}
}

void PlainMesh::Append(const PlainMesh& other)
{
  const Index first = static_cast<Index>(this->Points.size());
  this->Points.insert(this->Points.end(), other.Points.begin(), other.Points.end());
  for (const auto& [a, b, c] : other.Triangles)
  {
    this->Triangles.push_back({ first + a, first + b, first + c });
  }
}

PlainMesh TetrahedronMesh()
{
  return { { { 1, 1, 1 }, { -1, -1, 1 }, { -1, 1, -1 }, { 1, -1, -1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } } };
}

PlainMesh OctahedronMesh()
{
  return { { { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 }, { 1, 0, 5 }, { 2, 1, 5 }, { 3, 2, 5 },
      { 0, 3, 5 } } };
}

PlainMesh TorusMesh(Index around, Index across)
{
  PlainMesh mesh;
  for (Index i = 0; i < around; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      const double s = Turn * i / around, t = Turn * j / across;
      const double radius = 1.0 + 0.4 * std::cos(t);
      mesh.Points.push_back({ radius * std::cos(s), radius * std::sin(s), 0.4 * std::sin(t) });
      const auto at = [&](Index k, Index l) { return k % around * across + l % across; };
      mesh.Triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      mesh.Triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return mesh;
}

PlainMesh RingMesh(Index segments, const std::vector<double>& radii,
  const std::vector<double>& heights, double bottom, double top)
{
  PlainMesh mesh;
  const Index rings = static_cast<Index>(radii.size());
  for (Index ring = 0; ring < rings; ++ring)
  {
    for (Index i = 0; i < segments; ++i)
    {
      const double angle = Turn * i / segments;
      mesh.Points.push_back(
        { radii[ring] * std::cos(angle), radii[ring] * std::sin(angle), heights[ring] });
      const Index a = ring * segments + i, b = ring * segments + (i + 1) % segments;
      if (ring + 1 < rings)
      {
        mesh.Triangles.push_back({ a, b, b + segments });
        mesh.Triangles.push_back({ a, b + segments, a + segments });
      }
      if (ring == 0)
      {
        mesh.Triangles.push_back({ b, a, rings * segments });
      }
      if (ring + 1 == rings)
      {
        mesh.Triangles.push_back({ a, b, rings * segments + 1 });
      }
    }
  }
  mesh.Points.push_back({ 0.0, 0.0, bottom });
  mesh.Points.push_back({ 0.0, 0.0, top });
  return mesh;
}

PlainMesh BallOfPairs(Index segments, double lowest, double step, double gap)
{
  std::vector<double> heights, radii;
  for (double z = lowest; z < 0.01 - lowest; z += step)
  {
    for (const double height : { z, z + gap })
    {
      heights.push_back(height);
      radii.push_back(std::sqrt(1.0 - height * height));
    }
  }
  return RingMesh(segments, radii, heights, -1.0, 1.0);
}

SurfaceMesh RingSurface(
  const PlainMesh& mesh, Index segments, const std::vector<double>& heights, double room)
{
  SurfaceMesh surface = Plain(mesh);
  const Index rings = static_cast<Index>(heights.size());
  for (Index slab = 0; slab <= rings; ++slab)
  {
    surface.Cells.push_back(BoxOf(room, slab > 0 ? heights[slab - 1] : heights.front() - room,
      slab < rings ? heights[slab] : heights.back() + room));
  }
  std::fill_n(surface.Fixed.begin(), rings * segments, std::uint8_t(1));
  for (Index ring = 0; ring < rings; ++ring)
  {
    for (Index i = 0; i < segments; ++i)
    {
      surface.Corners.MarkCurve(
        surface.Corners.FindEdge(ring * segments + i, ring * segments + (i + 1) % segments));
    }
  }
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    double middle = 0.0;
    for (const Index corner : mesh.Triangles[t])
    {
      middle += mesh.Points[corner][2] / 3.0;
    }
    const auto above = std::upper_bound(heights.begin(), heights.end(), middle);
    surface.Cell[t] = static_cast<Index>(above - heights.begin());
  }
  return surface;
}

SurfaceMesh FreeSurface(const PlainMesh& mesh, double room)
{
  SurfaceMesh surface = Plain(mesh);
  surface.Cells.push_back(BoxOf(room, -room, room));
  return surface;
}

TriangleMesh CopyUsed(const CornerTable& corners, const std::vector<Point3>& points)
{
  TriangleMesh plain;
  std::vector<std::int64_t> number(points.size(), -1);
  for (const auto& triangle : corners.ListTriangles())
  {
    std::array<std::int64_t, 3> ids;
    for (int i = 0; i < 3; ++i)
    {
      std::int64_t& id = number[triangle[i]];
      if (id < 0)
      {
        id = static_cast<std::int64_t>(plain.Points.size());
        plain.Points.push_back(points[triangle[i]]);
      }
      ids[i] = id;
    }
    plain.Triangles.push_back(ids);
  }
  return plain;
}

void MakeFair(double length, SurfaceMesh& mesh, bool isPulled)
{
  CollapseShortEdges(length, mesh);
  FlipEdges(mesh);
  RefineEdges(length, mesh);
  CollapseShortEdges(length, mesh);
  FairSurface(EdgeWeights::Uniform, mesh);
  SplitLongEdges(length, mesh);
  CollapseShortEdges(length, mesh);
  FlipEdges(mesh);
  mesh.StretchAxis = isPulled ? mesh.StretchAxis : -1;
  FairSurface(EdgeWeights::Cotangents, mesh);
}

} // namespace support
} // namespace orthoslices
