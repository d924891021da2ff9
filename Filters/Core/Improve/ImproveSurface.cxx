// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/ImproveSurface.h"

#include "Core/Base/Box.h"
#include "Core/Improve/FindCrossings.h"
#include "Core/Sparse/SurfaceMesh.h"
#include "Core/Surface/DescribePatches.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// How often the surface is improved anew, less and less of it where triangles would meet.
constexpr int MaxRounds = 5;

/// Fixes the points in boxes around triangles, wider by a share of their diagonals.
void FixAround(const ImprovableMesh& mesh, const std::vector<std::pair<Index, Index>>& pairs,
  double share, const std::vector<Point3>& points, std::vector<std::uint8_t>& isFixed)
{
  std::vector<Box3> boxes;
  for (const auto& [first, second] : pairs)
  {
    Box3 box;
    for (const Index triangle : { first, second })
    {
      for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
      {
        box.Add(mesh.Points[mesh.Corners.VertexOf(corner)]);
      }
    }
    const double wider = share * box.Diagonal();
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Low[axis] -= wider;
      box.High[axis] += wider;
    }
    boxes.push_back(box);
  }
  std::sort(boxes.begin(), boxes.end(),
    [](const Box3& a, const Box3& b) { return a.Low < b.Low; });
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    Box3 at;
    at.Add(points[i]);
    const bool isNear = std::any_of(
      boxes.begin(), boxes.end(), [&](const Box3& box) { return box.Meets(at); });
    isFixed[i] = isNear ? 1 : isFixed[i];
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

/// Numbers the points that are in use from 0 on.
void SetImproved(const ImprovableMesh& mesh, const std::vector<std::array<Index, 3>>& triangles,
  const std::vector<Index>& numbers, const std::vector<std::int64_t>& origins, Patches& patches)
{
  ImprovedTriangles& improved = patches.Improved;
  improved = {};
  std::vector<Index> places(mesh.Points.size(), -1);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (mesh.Corners.IsUsed(static_cast<Index>(i)))
    {
      places[i] = static_cast<Index>(improved.Origin.size());
      improved.Origin.push_back(origins[i]);
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
  const std::vector<float> smooth = ListSmoothNormals(
    normals, patches, geometry.Graph.Count(), static_cast<std::int64_t>(count));
  std::vector<std::int64_t> origins(count);
  std::vector<Point3> normalAt(count, Point3{ 0.0, 0.0, 0.0 });
  for (std::size_t i = 0; i < count; ++i)
  {
    origins[i] = static_cast<std::int64_t>(i);
    if (!smooth.empty())
    {
      normalAt[i] = { smooth[3 * i], smooth[3 * i + 1], smooth[3 * i + 2] };
    }
  }
  const CornerTable corners(static_cast<Index>(count), all.Triangles);
  std::vector<std::uint8_t> isFixed(count, 0);
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> numbers;
  double share = 1.0;
  for (int round = 0; round < MaxRounds; ++round, share *= 2.0)
  {
    ImprovableMesh mesh{ corners, all.Points, normalAt, isFixed };
    MeshImprover(geometry.Grid, limits, mesh).Run();
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
      SetImproved(mesh, triangles, numbers, origins, patches);
      return;
    }
    for (auto& [first, second] : pairs)
    {
      first = numbers[first];
      second = numbers[second];
    }
    FixAround(mesh, pairs, share, all.Points, isFixed);
  }
}
}
