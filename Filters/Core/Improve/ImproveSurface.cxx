// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/ImproveSurface.h"

#include "Core/Surface/DescribePatches.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// The triangles that are left, in the order of those that they were part of at first, and the
/// numbers of these.
void ListLeft(const ImprovableMesh& mesh, std::vector<std::array<Index, 3>>& triangles,
  std::vector<Index>& numbers)
{
  const CornerTable& corners = mesh.Corners;
  const Index count = corners.CornerCount() / 3;
  const Index given = count - static_cast<Index>(mesh.Origins.size());
  std::vector<std::pair<Index, Index>> left;
  for (Index i = 0; i < count; ++i)
  {
    if (corners.IsAlive(3 * i))
    {
      left.emplace_back(i < given ? i : mesh.Origins[i - given], i);
    }
  }
  if (count > given)
  {
    std::sort(left.begin(), left.end());
  }
  for (const auto& [number, i] : left)
  {
    triangles.push_back(
      { corners.VertexOf(3 * i), corners.VertexOf(3 * i + 1), corners.VertexOf(3 * i + 2) });
    numbers.push_back(number);
  }
}

/// The surface's normals at all points; zero where it has none.
std::vector<Point3> ListNormals(
  const SurfaceNormals& normals, const Patches& patches, Index graphPoints, std::size_t count)
{
  const std::vector<float> smooth =
    ListSmoothNormals(normals, patches, graphPoints, static_cast<std::int64_t>(count));
  std::vector<Point3> result(count, Point3{ 0.0, 0.0, 0.0 });
  for (std::size_t i = 0; 3 * i < smooth.size(); ++i)
  {
    result[i] = { smooth[3 * i], smooth[3 * i + 1], smooth[3 * i + 2] };
  }
  return result;
}

/// Of each triangle of a patch that is no smooth one, the number of its cycle; else -1.
std::vector<Index> ListPlain(const Patches& patches)
{
  std::vector<Index> plain(static_cast<std::size_t>(patches.TriangleCount()), -1);
  std::size_t inner = 0;
  for (std::size_t cycle = 0; cycle + 1 < patches.Offsets.size(); ++cycle)
  {
    if (inner < patches.Inner.Cycle.size() &&
      static_cast<std::size_t>(patches.Inner.Cycle[inner]) == cycle)
    {
      ++inner;
      continue;
    }
    std::fill(plain.begin() + patches.Offsets[cycle], plain.begin() + patches.Offsets[cycle + 1],
      static_cast<Index>(cycle));
  }
  return plain;
}

/// Numbers the points that are in use from 0 on. Those after the first `given` ones are new.
void SetImproved(const ImprovableMesh& mesh, const std::vector<std::array<Index, 3>>& triangles,
  const std::vector<Index>& numbers, std::size_t given, Patches& patches)
{
  ImprovedTriangles& improved = patches.Improved;
  improved = {};
  std::vector<Index> places(mesh.Points.size(), -1);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (mesh.Corners.IsUsed(static_cast<Index>(i)))
    {
      places[i] = static_cast<Index>(improved.Origin.size());
      improved.Origin.push_back(i < given ? static_cast<std::int64_t>(i) : -1);
      improved.Points.insert(improved.Points.end(), mesh.Points[i].begin(), mesh.Points[i].end());
    }
  }
  improved.Corners.reserve(3 * triangles.size());
  for (const std::array<Index, 3>& triangle : triangles)
  {
    for (const Index corner : triangle)
    {
      improved.Corners.push_back(places[corner]);
    }
  }
  std::size_t next = 0;
  for (std::size_t cycle = 0; cycle + 1 < patches.Offsets.size(); ++cycle)
  {
    // The end of this patch becomes that of its triangles that are left.
    const std::int64_t end = patches.Offsets[cycle + 1];
    while (next < numbers.size() && numbers[next] < end)
    {
      ++next;
    }
    patches.Offsets[cycle + 1] = static_cast<std::int64_t>(next);
  }
}
}

void ImproveSurface(const CycleGeometry& geometry, const SurfaceNormals& normals,
  const ImprovementLimits& limits, const Execution& execution, Patches& patches)
{
  SurfaceTriangles all = ListTriangles(geometry, patches, execution);
  if (all.Triangles.empty())
  {
    return;
  }
  const std::size_t count = all.Points.size();
  std::vector<Point3> normalAt = ListNormals(normals, patches, geometry.Graph.Count(), count);
  ImprovableMesh mesh{ CornerTable(static_cast<Index>(count), all.Triangles), std::move(all.Points),
    std::move(normalAt), ListPlain(patches), geometry.Graph.Count() };
  MeshImprover(geometry.Grid, limits, execution, mesh).Run();
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> numbers;
  ListLeft(mesh, triangles, numbers);
  SetImproved(mesh, triangles, numbers, count, patches);
}
}
