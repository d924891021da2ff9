// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/LayOutTriangles.h"

#include "Core/Patches/Quadrilaterals.h"

#include <algorithm>
#include <numeric>

namespace orthoslices
{
void LayOutTriangles(
  const NodeGraph& graph, const CellCycles& cycles, Patches& patches, const Portion* part)
{
  patches.Improved = {};
  patches.Offsets.assign(static_cast<std::size_t>(cycles.Count()) + 1, 0);
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    std::int64_t border = 0;
    for (Index i = cycles.Offsets[cycle]; i < cycles.Offsets[cycle + 1]; ++i)
    {
      const Index arc = cycles.Arcs[i].Arc;
      border += (graph.IsLoop(arc) ? 0 : 1) + graph.PointCount(arc);
    }
    patches.Offsets[cycle + 1] = border;
  }
  std::int64_t nextPoint = std::int64_t(graph.Count()) + cycles.Count();
  patches.MeshOffsets.clear();
  for (const PatchMesh& mesh : patches.Meshes)
  {
    for (std::size_t k = 0; k < mesh.Cycles.size(); ++k)
    {
      patches.Offsets[mesh.Cycles[k] + 1] = 0;
      std::copy(mesh.Points[k].begin(), mesh.Points[k].end(),
        patches.CentralPoints.begin() + 3 * static_cast<std::size_t>(mesh.Cycles[k]));
    }
    patches.Offsets[mesh.Cycles.front() + 1] = static_cast<std::int64_t>(mesh.Triangles.size());
    patches.MeshOffsets.push_back(nextPoint);
    nextPoint += static_cast<std::int64_t>(mesh.Points.size() - mesh.Cycles.size());
  }
  patches.MeshOffsets.push_back(nextPoint);
  const InnerPatches& inner = patches.Inner;
  for (Index i = 0; i < inner.Count(); ++i)
  {
    patches.Offsets[inner.Cycle[i] + 1] = inner.TriangleOffsets[i + 1] - inner.TriangleOffsets[i];
    const Point3 first = inner.PointAt(inner.PointOffsets[i]);
    std::copy(first.begin(), first.end(),
      patches.CentralPoints.begin() + 3 * static_cast<std::size_t>(inner.Cycle[i]));
  }
  for (std::size_t cycle = 0; part != nullptr && cycle + 1 < patches.Offsets.size(); ++cycle)
  {
    patches.Offsets[cycle + 1] = part->Has(cycle) ? patches.Offsets[cycle + 1] : 0;
  }
  std::partial_sum(patches.Offsets.begin(), patches.Offsets.end(), patches.Offsets.begin());
}

std::vector<double> ListOtherPoints(const Patches& patches)
{
  std::vector<double> points;
  for (const PatchMesh& mesh : patches.Meshes)
  {
    for (std::size_t i = mesh.Cycles.size(); i < mesh.Points.size(); ++i)
    {
      points.insert(points.end(), mesh.Points[i].begin(), mesh.Points[i].end());
    }
  }
  const InnerPatches& inner = patches.Inner;
  points.reserve(points.size() + inner.Points.size());
  for (Index i = 0; i < inner.Count(); ++i)
  {
    points.insert(points.end(), inner.Points.begin() + 3 * (inner.PointOffsets[i] + 1),
      inner.Points.begin() + 3 * inner.PointOffsets[i + 1]);
  }
  return points;
}

namespace
{
/// Writes the fans of the quadrilaterals of one polygon around its central point.
template <typename Id>
void WriteFans(const std::vector<Index>& border, const std::vector<Quadrilateral>& quadrilaterals,
  Id center, Id* out)
{
  const Index size = static_cast<Index>(border.size());
  for (const Quadrilateral& quadrilateral : quadrilaterals)
  {
    for (Index i = quadrilateral.First; i < quadrilateral.Last; ++i)
    {
      *out++ = center;
      *out++ = static_cast<Id>(border[(i + size) % size]);
      *out++ = static_cast<Id>(border[(i + 1 + size) % size]);
    }
  }
}

/// Writes the triangles of a mesh. `borders` are those of its cycles, one after another.
template <typename Id>
void WriteMesh(
  const PatchMesh& mesh, const std::vector<Index>& borders, Id centers, Id otherPoints, Id* out)
{
  const Index members = static_cast<Index>(mesh.Cycles.size());
  for (const auto& triangle : mesh.Triangles)
  {
    for (const Index corner : triangle)
    {
      const Index own = -1 - corner;
      *out++ = corner >= 0 ? static_cast<Id>(borders[corner])
        : own < members    ? centers + static_cast<Id>(mesh.Cycles[own])
                           : otherPoints + static_cast<Id>(own - members);
    }
  }
}

/// Writes the triangles of a patch with points inside, the first of which is `center`.
template <typename Id>
void WriteInner(
  const Patches& patches, Index patch, const std::vector<Index>& border, Id center, Id* out)
{
  const InnerPatches& inner = patches.Inner;
  const Id others = static_cast<Id>(patches.InnerPointId(patch));
  const std::int64_t last = 3 * inner.TriangleOffsets[patch + 1];
  for (std::int64_t i = 3 * inner.TriangleOffsets[patch]; i < last; ++i)
  {
    const Index corner = inner.Corners[i];
    *out++ = corner >= 0 ? static_cast<Id>(border[corner])
      : corner == -1     ? center
                         : static_cast<Id>(others - 2 - corner);
  }
}
}

template <typename Id>
void WriteTriangles(const Patches& patches, const CycleGeometry& geometry,
  const Execution& execution, Id* connectivity)
{
  if (patches.Improved.Any())
  {
    std::copy(patches.Improved.Corners.begin(), patches.Improved.Corners.end(), connectivity);
    return;
  }
  execution.For(geometry.Cycles.Count(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Index> border, nodePlaces;
      std::vector<Quadrilateral> quadrilaterals;
      const Id centers = static_cast<Id>(geometry.Graph.Count());
      auto mesh = std::lower_bound(patches.Meshes.begin(), patches.Meshes.end(), begin,
        [](const PatchMesh& m, std::size_t cycle)
        { return static_cast<std::size_t>(m.Cycles.front()) < cycle; });
      const std::vector<Index>& inner = patches.Inner.Cycle;
      auto nextInner = std::lower_bound(inner.begin(), inner.end(), static_cast<Index>(begin));
      for (std::size_t cycle = begin; cycle < end; ++cycle)
      {
        if (patches.Offsets[cycle] == patches.Offsets[cycle + 1])
        {
          continue; // part of another cycle's patch, or of another process's part
        }
        while (
          mesh != patches.Meshes.end() && static_cast<std::size_t>(mesh->Cycles.front()) < cycle)
        {
          ++mesh;
        }
        Id* out = connectivity + 3 * patches.Offsets[cycle];
        if (mesh != patches.Meshes.end() && static_cast<std::size_t>(mesh->Cycles.front()) == cycle)
        {
          const std::int64_t others = patches.MeshOffsets[mesh - patches.Meshes.begin()];
          WriteMesh(
            *mesh, geometry.GetBorders(mesh->Cycles), centers, static_cast<Id>(others), out);
          continue;
        }
        geometry.GetBoundary(static_cast<Index>(cycle), border, nodePlaces);
        const Id center = centers + static_cast<Id>(cycle);
        if (nextInner != inner.end() && *nextInner == static_cast<Index>(cycle))
        {
          WriteInner(patches, static_cast<Index>(nextInner - inner.begin()), border, center, out);
          ++nextInner;
          continue;
        }
        SplitIntoQuadrilaterals(static_cast<Index>(border.size()), nodePlaces, quadrilaterals);
        WriteFans(border, quadrilaterals, center, out);
      }
    });
}

template void WriteTriangles(const Patches&, const CycleGeometry&, const Execution&, std::int32_t*);
template void WriteTriangles(const Patches&, const CycleGeometry&, const Execution&, long long*);

SurfaceTriangles ListTriangles(
  const CycleGeometry& geometry, const Patches& patches, const Execution& execution)
{
  SurfaceTriangles result;
  const auto append = [&](const std::vector<double>& values)
  {
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
    {
      result.Points.push_back({ values[i], values[i + 1], values[i + 2] });
    }
  };
  if (patches.Improved.Any())
  {
    append(patches.Improved.Points);
  }
  else
  {
    append(geometry.Graph.Points);
    append(patches.CentralPoints);
    append(ListOtherPoints(patches));
  }
  std::vector<std::int32_t> ids(3 * static_cast<std::size_t>(patches.TriangleCount()));
  WriteTriangles(patches, geometry, execution, ids.data());
  for (std::size_t t = 0; t < ids.size(); t += 3)
  {
    result.Triangles.push_back({ ids[t], ids[t + 1], ids[t + 2] });
  }
  return result;
}
}
