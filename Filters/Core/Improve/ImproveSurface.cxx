// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/ImproveSurface.h"

#include "Core/Surface/DescribePatches.h"

#include <algorithm>

namespace orthoslices
{
TrianglesLeft ListLeft(const ImprovableMesh& mesh)
{
  const CornerTable& corners = mesh.Corners;
  const Index count = corners.CornerCount() / 3;
  const Index given = count - static_cast<Index>(mesh.Origins.size());
  // New ones are few: they are sorted, and taken in between.
  std::vector<std::pair<Index, Index>> added;
  for (Index i = given; i < count; ++i)
  {
    added.emplace_back(mesh.Origins[i - given], i);
  }
  std::sort(added.begin(), added.end());
  TrianglesLeft result;
  result.Triangles.reserve(static_cast<std::size_t>(count));
  result.Numbers.reserve(static_cast<std::size_t>(count));
  const auto add = [&](Index number, Index i)
  {
    if (corners.IsAlive(3 * i) && !mesh.Borders.IsBeyond(corners, i))
    {
      result.Triangles.push_back(
        { corners.VertexOf(3 * i), corners.VertexOf(3 * i + 1), corners.VertexOf(3 * i + 2) });
      result.Numbers.push_back(number);
    }
  };
  auto next = added.begin();
  for (Index i = 0; i < given; ++i)
  {
    add(i, i);
    for (; next != added.end() && next->first == i; ++next)
    {
      add(i, next->second);
    }
  }
  return result;
}

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

void SetImproved(
  const std::vector<Point3>& points, std::size_t given, const TrianglesLeft& left, Patches& patches)
{
  std::vector<Index> places(points.size(), -1);
  for (const std::array<Index, 3>& triangle : left.Triangles)
  {
    places[triangle[0]] = places[triangle[1]] = places[triangle[2]] = 0;
  }
  ImprovedTriangles& improved = patches.Improved;
  improved = {};
  improved.Origin.reserve(points.size());
  improved.Points.reserve(3 * points.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i] >= 0)
    {
      places[i] = static_cast<Index>(improved.Origin.size());
      improved.Origin.push_back(i < given ? static_cast<std::int64_t>(i) : -1);
      improved.Points.insert(improved.Points.end(), points[i].begin(), points[i].end());
    }
  }
  improved.Corners.reserve(3 * left.Triangles.size());
  for (const std::array<Index, 3>& triangle : left.Triangles)
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
    while (next < left.Numbers.size() && left.Numbers[next] < end)
    {
      ++next;
    }
    patches.Offsets[cycle + 1] = static_cast<std::int64_t>(next);
  }
}

void ImproveSurface(const CycleGeometry& geometry, const SurfaceNormals& normals,
  const ImprovementLimits& limits, const Execution& execution, Patches& patches, const Ranks& ranks)
{
  SurfaceTriangles all = ListTriangles(geometry, patches, execution);
  if (all.Triangles.empty())
  {
    return;
  }
  const std::size_t count = all.Points.size();
  TrianglesLeft left;
  {
    std::vector<Point3> normalAt = ListNormals(normals, patches, geometry.Graph.Count(), count);
    ImprovableMesh mesh{ CornerTable::WithoutLinks(static_cast<Index>(count), all.Triangles),
      std::move(all.Points), std::move(normalAt), ListPlain(patches), geometry.Graph.Count() };
    all = {};
    MeshImprover(geometry.Grid, limits, execution, mesh, ranks).Run();
    left = ListLeft(mesh);
    all.Points = std::move(mesh.Points);
  } // the rest of the mesh takes as much memory as what comes of it
  SetImproved(all.Points, count, left, patches);
}
}
