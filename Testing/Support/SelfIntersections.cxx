// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/SelfIntersections.h"

#ifdef ORTHOGONAL_SLICES_HAVE_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#endif

namespace orthoslices
{
namespace support
{

#ifdef ORTHOGONAL_SLICES_HAVE_CGAL

std::int64_t CountSelfIntersections(const TriangleMesh& mesh)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Mesh copy;
  for (const Point3& p : mesh.Points)
  {
    copy.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  }
  const auto vertex = [](std::int64_t id)
  { return Mesh::Vertex_index(static_cast<Mesh::size_type>(id)); };
  for (const auto& t : mesh.Triangles)
  {
    copy.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  }
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(copy, std::back_inserter(pairs));
  return static_cast<std::int64_t>(pairs.size());
}

#else

std::int64_t CountSelfIntersections(const TriangleMesh&) { return -1; }

#endif

} // namespace support
} // namespace orthoslices
