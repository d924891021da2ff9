// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/DescribePatches.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// What was done to the arcs around one cycle.
unsigned char FindRepairsAround(const CycleGeometry& geometry, Index cycle, double tolerance)
{
  const std::vector<std::uint8_t>& redrawn = geometry.Graph.Redrawn;
  unsigned char repairs = 0;
  for (Index a = geometry.Cycles.Offsets[cycle]; a < geometry.Cycles.Offsets[cycle + 1]; ++a)
  {
    const HalfArc& half = geometry.Cycles.Arcs[a];
    if (geometry.Graph.IsLoop(half.Arc))
    {
      continue;
    }
    const Index node = StartNode(geometry.Crossings, geometry.Nodes, half);
    repairs |= geometry.Nodes.Disagreement(node) > tolerance ? NodesDisagree : 0;
    repairs |= !redrawn.empty() && redrawn[half.Arc] != 0 ? ArcsChanged : 0;
  }
  return repairs;
}

bool AnyDisagrees(const CycleGeometry& geometry, double tolerance)
{
  for (Index node = 0; node < geometry.Graph.Nodes; ++node)
  {
    if (geometry.Nodes.Disagreement(node) > tolerance)
    {
      return true;
    }
  }
  return false;
}
}

std::vector<unsigned char> FindPatchRepairs(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes, double tolerance)
{
  const Index count = geometry.Cycles.Count();
  std::vector<unsigned char> repairs(count, 0);
  if (!geometry.Graph.Redrawn.empty() || AnyDisagrees(geometry, tolerance))
  {
    for (Index cycle = 0; cycle < count; ++cycle)
    {
      repairs[cycle] = FindRepairsAround(geometry, cycle, tolerance);
    }
  }
  for (const PatchMesh& mesh : meshes)
  {
    for (const Index cycle : mesh.Cycles)
    {
      repairs[mesh.Cycles.front()] |=
        repairs[cycle] | (mesh.IsSeparatedDisc() ? PatchSeparated : 0);
    }
  }
  return repairs;
}

std::vector<Index> CountNodePoints(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes)
{
  std::vector<Index> sizes(geometry.Cycles.Count());
  for (Index i = 0; i < geometry.Cycles.Count(); ++i)
  {
    sizes[i] = geometry.IsLoop(i) ? 0 : geometry.Cycles.Size(i);
  }
  for (const PatchMesh& mesh : meshes)
  {
    for (std::size_t i = 1; i < mesh.Cycles.size(); ++i)
    {
      sizes[mesh.Cycles.front()] += sizes[mesh.Cycles[i]];
    }
  }
  return sizes;
}

std::vector<float> ListSmoothNormals(const SurfaceNormals& normals, const Patches& patches,
  Index graphPoints, std::int64_t points, const Execution& execution)
{
  std::vector<float> all;
  if (normals.Normals.empty())
  {
    return all;
  }
  const InnerPatches& inner = patches.Inner;
  all.assign(3 * static_cast<std::size_t>(points), 0.0f);
  const auto copy = [&](const float* first, const float* last, std::int64_t id)
  { std::copy(first, last, all.begin() + 3 * id); };
  execution.For(normals.Normals.size() / 3,
    [&](std::size_t begin, std::size_t end)
    {
      const float* ofGraph = normals.Normals.data();
      copy(ofGraph + 3 * begin, ofGraph + 3 * end, static_cast<std::int64_t>(begin));
      for (std::size_t i = begin; i < std::min(end, normals.Corners.size()); ++i)
      {
        std::fill_n(all.begin() + 3 * i, normals.Corners[i] != 0 ? 3 : 0, 0.0f);
      }
    });
  execution.For(static_cast<std::size_t>(inner.Count()),
    [&](std::size_t begin, std::size_t end)
    {
      for (Index i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i)
      {
        const float* first = inner.Normals.data() + 3 * inner.PointOffsets[i];
        const float* last = inner.Normals.data() + 3 * inner.PointOffsets[i + 1];
        copy(first, first + 3, std::int64_t(graphPoints) + inner.Cycle[i]);
        copy(first + 3, last, patches.InnerPointId(i));
      }
    });
  return all;
}
}
