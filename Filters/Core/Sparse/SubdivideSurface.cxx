// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SubdivideSurface.h"

namespace orthoslices
{
namespace
{
/// Unit normals in the world, weighted by area; zero at creases.
std::vector<Point3> EstimatePointNormals(const SurfaceMesh& mesh)
{
  std::vector<Point3> normals(mesh.Points.size(), Point3{ 0.0, 0.0, 0.0 });
  for (const auto& [a, b, c] : mesh.Corners.ListTriangles())
  {
    const Point3 normal = Cross(mesh.InWorld(a, b), mesh.InWorld(a, c));
    for (const Index corner : { a, b, c })
    {
      normals[corner] = normals[corner] + normal;
    }
  }
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    normals[i] = mesh.Crease[i] ? Point3{ 0.0, 0.0, 0.0 } : Unit(normals[i]);
  }
  return normals;
}

/// The middle of the curve over the edge of a corner.
Point3 FindMiddle(const SurfaceMesh& mesh, const std::vector<Point3>& normals, Index corner)
{
  const Index start = mesh.Corners.StartOf(corner);
  const Index end = mesh.Corners.EndOf(corner);
  const Point3& p = mesh.Points[start];
  const Point3& q = mesh.Points[end];
  Point3 shift = 0.125 * Dot(mesh.InWorld(end, start), normals[start]) * normals[start] +
    0.125 * Dot(mesh.InWorld(start, end), normals[end]) * normals[end];
  shift = mesh.Metric.IsWorld() ? shift : mesh.Metric.ToAxes(shift);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (mesh.Corners.IsCurve(corner) && p[axis] == q[axis])
    {
      shift[axis] = 0.0;
    }
  }
  return Between(p, q, 0.5) + shift;
}
}

TriangleSurface SubdivideSurface(const SurfaceMesh& mesh)
{
  const CornerTable& corners = mesh.Corners;
  const std::vector<Point3> normals = EstimatePointNormals(mesh);
  TriangleSurface surface{ mesh.Points, {}, {} };
  std::vector<Index> middle(static_cast<std::size_t>(corners.CornerCount()), -1);
  for (Index corner = 0; corner < corners.CornerCount(); ++corner)
  {
    if (corners.IsAlive(corner) && middle[corner] < 0)
    {
      middle[corner] = middle[corners.OppositeOf(corner)] =
        static_cast<Index>(surface.Points.size());
      surface.Points.push_back(FindMiddle(mesh, normals, corner));
    }
  }
  for (Index corner = 0; corner < corners.CornerCount(); corner += 3)
  {
    if (!corners.IsAlive(corner))
    {
      continue;
    }
    // The edge of a corner lies opposite to it.
    const Index bc = middle[corner], ca = middle[corner + 1], ab = middle[corner + 2];
    surface.Triangles.push_back({ corners.VertexOf(corner), ab, ca });
    surface.Triangles.push_back({ corners.VertexOf(corner + 1), bc, ab });
    surface.Triangles.push_back({ corners.VertexOf(corner + 2), ca, bc });
    surface.Triangles.push_back({ ab, bc, ca });
  }
  return surface;
}
}
