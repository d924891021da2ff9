// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/ImproveSurface.h"

#include "Core/Base/Box.h"
#include "Core/Improve/FindCrossings.h"
#include "Core/Sparse/SurfaceMesh.h"
#include "Core/Surface/DescribePatches.h"

#include <algorithm>

#include <time.h>
#include <cstdio>
#include <cstdlib>
static double Now() { timespec t; clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t); return t.tv_sec + 1e-9 * t.tv_nsec; }
static double T0;
#define TICK(x) do { if (getenv("TICK")) { double n = Now(); fprintf(stderr, "    %s %.4f\n", x, n - T0); T0 = n; } } while (0)
namespace orthoslices
{
namespace
{
/// How often the surface is improved anew, less and less of it where triangles would meet.
constexpr int MaxRounds = 12;

/// Fixes the corners of triangles that are not apart, as they are and as they were, and so many rings of
/// points around them.
void FixAround(const ImprovableMesh& mesh, const CornerTable& before,
  const std::vector<std::pair<Index, Index>>& pairs, int rings, std::vector<std::uint8_t>& isFixed)
{
  std::vector<Index> points;
  const auto add = [&](Index point)
  {
    if (static_cast<std::size_t>(point) < isFixed.size())
    {
      points.push_back(point);
    }
  };
  for (const auto& [first, second] : pairs)
  {
    for (const Index triangle : { first, second })
    {
      for (Index i = 0; i < 3; ++i)
      {
        add(mesh.Corners.VertexOf(3 * triangle + i));
        add(before.VertexOf(3 * mesh.Parent[triangle] + i));
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
        before.ForCornersAt(
          points[i], [&](Index corner) { points.push_back(before.VertexOf(CornerTable::Next(corner))); });
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

/// The triangles that are left, with their numbers, in the order of those that they were parts of.
void ListLeft(const ImprovableMesh& mesh, std::vector<std::array<Index, 3>>& triangles,
  std::vector<Index>& numbers)
{
  const CornerTable& corners = mesh.Corners;
  triangles.clear();
  numbers.clear();
  for (Index corner = 0; corner < corners.CornerCount(); corner += 3)
  {
    if (corners.IsAlive(corner))
    {
      numbers.push_back(corner / 3);
    }
  }
  std::stable_sort(numbers.begin(), numbers.end(),
    [&](Index a, Index b) { return mesh.Parent[a] < mesh.Parent[b]; });
  for (const Index number : numbers)
  {
    triangles.push_back({ corners.VertexOf(3 * number), corners.VertexOf(3 * number + 1),
      corners.VertexOf(3 * number + 2) });
  }
}

/// Numbers the points that are in use from 0 on. Those up to `count` were there before.
void SetImproved(const ImprovableMesh& mesh, const std::vector<std::array<Index, 3>>& triangles,
  const std::vector<Index>& numbers, std::size_t count, Patches& patches)
{
  ImprovedTriangles& improved = patches.Improved;
  improved = {};
  std::vector<Index> places(mesh.Points.size(), -1);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (mesh.Corners.IsUsed(static_cast<Index>(i)))
    {
      places[i] = static_cast<Index>(improved.Origin.size());
      improved.Origin.push_back(i < count ? static_cast<std::int64_t>(i) : -1);
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
    while (next < numbers.size() && mesh.Parent[numbers[next]] < end)
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
  T0 = Now();
  SurfaceTriangles all = ListTriangles(geometry, patches, execution);
  if (all.Triangles.empty())
  {
    return;
  }
  const std::size_t count = all.Points.size();
  const std::vector<float> smooth = ListSmoothNormals(
    normals, patches, geometry.Graph.Count(), static_cast<std::int64_t>(count));
  std::vector<Point3> normalAt(count, Point3{ 0.0, 0.0, 0.0 });
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!smooth.empty())
    {
      normalAt[i] = { smooth[3 * i], smooth[3 * i + 1], smooth[3 * i + 2] };
    }
  }
  TICK("list");
  const CornerTable corners(static_cast<Index>(count), all.Triangles);
  TICK("corners");
  std::vector<std::uint8_t> isFixed(count, 0);
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> numbers;
  for (int round = 0; round < MaxRounds; ++round)
  {
    ImprovableMesh mesh{ corners, all.Points, normalAt, isFixed };
    MeshImprover(geometry.Grid, limits, mesh).Run();
    TICK("run");
    ListLeft(mesh, triangles, numbers);
    std::vector<std::uint8_t> isChanged;
    for (const Index number : numbers)
    {
      isChanged.push_back(mesh.Changed[number]);
    }
    std::vector<std::pair<Index, Index>> pairs =
      FindCrossings(mesh.Points, triangles, isChanged, execution);
    TICK("find");
    if (getenv("TICK")) fprintf(stderr, "    pairs %zu\n", pairs.size());
    if (pairs.empty())
    {
      SetImproved(mesh, triangles, numbers, count, patches);
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
