// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangles.h"

#include "Quadrilaterals.h"

#include <algorithm>
#include <numeric>

namespace orthoslices
{
void LayOutTriangles(const NodeGraph& graph, const Cycles& cycles, Patches& patches)
{
  patches.Offsets.assign(static_cast<std::size_t>(cycles.Count()) + 1, 0);
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    std::int64_t border = 0;
    for (Index i = cycles.Offsets[cycle]; i < cycles.Offsets[cycle + 1]; ++i)
    {
      border += 1 + graph.PointCount(cycles.Arcs[i].Arc);
    }
    patches.Offsets[cycle + 1] = border;
  }
  Index nextPoint = graph.Count() + cycles.Count();
  for (const ShellPatch& shell : patches.Shells)
  {
    patches.Offsets[shell.Cycle + 1] = static_cast<std::int64_t>(shell.Triangles.size());
    patches.ShellOffsets.push_back(nextPoint);
    nextPoint += static_cast<Index>(shell.Points.size()) - 1;
    std::copy(shell.Points.front().begin(), shell.Points.front().end(),
      patches.CentralPoints.begin() + 3 * static_cast<std::size_t>(shell.Cycle));
  }
  std::partial_sum(patches.Offsets.begin(), patches.Offsets.end(), patches.Offsets.begin());
}

namespace
{
/// The fans of the quadrilaterals of one polygon.
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

template <typename Id>
void WriteShell(
  const ShellPatch& shell, const std::vector<Index>& border, Id firstPoint, Id otherPoints, Id* out)
{
  for (const auto& triangle : shell.Triangles)
  {
    for (const Index corner : triangle)
    {
      const Id own = corner == -1 ? firstPoint : otherPoints + static_cast<Id>(-2 - corner);
      *out++ = corner >= 0 ? static_cast<Id>(border[corner]) : own;
    }
  }
}
}

template <typename Id>
void WriteTriangles(const Patches& patches, const NodeGraph& graph, const Crossings& crossings,
  const NodePoints& nodes, const Cycles& cycles, const Execution& execution, Id* connectivity)
{
  execution.For(cycles.Count(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Index> border, nodePlaces;
      std::vector<Quadrilateral> quadrilaterals;
      auto shell = std::lower_bound(patches.Shells.begin(), patches.Shells.end(), begin,
        [](const ShellPatch& s, std::size_t cycle)
        { return static_cast<std::size_t>(s.Cycle) < cycle; });
      for (std::size_t cycle = begin; cycle < end; ++cycle)
      {
        GetBoundary(graph, crossings, nodes, cycles, static_cast<Index>(cycle), border, nodePlaces);
        const Id center = static_cast<Id>(graph.Count()) + static_cast<Id>(cycle);
        Id* out = connectivity + 3 * patches.Offsets[cycle];
        if (shell != patches.Shells.end() && static_cast<std::size_t>(shell->Cycle) == cycle)
        {
          const Index others = patches.ShellOffsets[shell - patches.Shells.begin()];
          WriteShell(*shell, border, center, static_cast<Id>(others), out);
          ++shell;
          continue;
        }
        SplitIntoQuadrilaterals(static_cast<Index>(border.size()), nodePlaces, quadrilaterals);
        WriteFans(border, quadrilaterals, center, out);
      }
    });
}

template void WriteTriangles(const Patches&, const NodeGraph&, const Crossings&, const NodePoints&,
  const Cycles&, const Execution&, std::int32_t*);
template void WriteTriangles(const Patches&, const NodeGraph&, const Crossings&, const NodePoints&,
  const Cycles&, const Execution&, long long*);
}
