// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/ImproveSurface.h"

#include "Core/Base/Box.h"
#include "Core/Improve/FindCrossings.h"
#include "Core/Surface/DescribePatches.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// How often the surface is improved anew, less and less of it where triangles would meet.
constexpr int MaxRounds = 12;

/// Fixes the corners that triangles had before, of those that are not apart, and so many rings of
/// points around them. Only triangles that were changed have to be as they were.
void FixAround(const ImprovableMesh& mesh, const CornerTable& before,
  const std::vector<std::pair<Index, Index>>& pairs, int rings, std::vector<std::uint8_t>& isFixed)
{
  std::vector<Index> points;
  for (const auto& [first, second] : pairs)
  {
    for (const Index triangle : { first, second })
    {
      for (Index i = 0; i < 3 && mesh.Changed[triangle] != 0; ++i)
      {
        points.push_back(before.VertexOf(3 * triangle + i));
      }
    }
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::size_t last = points.size();
    for (std::size_t i = 0; i < last; ++i)
    {
      if (before.IsUsed(points[i]))
      {
        before.ForCornersAt(points[i],
          [&](Index corner) { points.push_back(before.VertexOf(CornerTable::Next(corner))); });
      }
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }
  for (const Index point : points)
  {
    isFixed[point] = 1;
  }
}

/// The triangles that are left, with their numbers before.
void ListLeft(const CornerTable& corners, std::vector<std::array<Index, 3>>& triangles,
  std::vector<Index>& numbers)
{
  triangles.clear();
  numbers.clear();
  for (Index corner = 0; corner < corners.CornerCount(); corner += 3)
  {
    if (corners.IsAlive(corner))
    {
      triangles.push_back(
        { corners.VertexOf(corner), corners.VertexOf(corner + 1), corners.VertexOf(corner + 2) });
      numbers.push_back(corner / 3);
    }
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

/// Numbers the points that are in use from 0 on.
void SetImproved(const ImprovableMesh& mesh, const std::vector<std::array<Index, 3>>& triangles,
  const std::vector<Index>& numbers, Patches& patches)
{
  ImprovedTriangles& improved = patches.Improved;
  improved = {};
  std::vector<Index> places(mesh.Points.size(), -1);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (mesh.Corners.IsUsed(static_cast<Index>(i)))
    {
      places[i] = static_cast<Index>(improved.Origin.size());
      improved.Origin.push_back(static_cast<std::int64_t>(i));
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
  const std::vector<Point3> normalAt = ListNormals(normals, patches, geometry.Graph.Count(), count);
  const CornerTable corners(static_cast<Index>(count), all.Triangles);
  std::vector<std::uint8_t> isFixed(count, 0);
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> numbers;
  for (int round = 0; round < MaxRounds; ++round)
  {
    ImprovableMesh mesh{ corners, all.Points, normalAt, isFixed };
    MeshImprover(geometry.Grid, limits, mesh).Run(execution);
    ListLeft(mesh.Corners, triangles, numbers);
    std::vector<std::uint8_t> isChanged;
    for (const Index number : numbers)
    {
      isChanged.push_back(mesh.Changed[number]);
    }
    std::vector<std::pair<Index, Index>> pairs =
      FindCrossings(mesh.Points, triangles, isChanged, execution);
    if (pairs.empty())
    {
      SetImproved(mesh, triangles, numbers, patches);
      return;
    }
    for (auto& [first, second] : pairs)
    {
      first = numbers[first];
      second = numbers[second];
    }
    FixAround(mesh, corners, pairs, round / 3, isFixed);
  }
}
}
