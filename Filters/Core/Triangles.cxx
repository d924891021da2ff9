// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangles.h"

#include "Quadrilaterals.h"

namespace orthoslices
{
TriangleLayout LayOutTriangles(const NodeGraph& graph, const Cycles& cycles)
{
  TriangleLayout layout;
  layout.Offsets.resize(static_cast<std::size_t>(cycles.Count()) + 1, 0);
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    std::int64_t border = 0;
    for (Index i = cycles.Offsets[cycle]; i < cycles.Offsets[cycle + 1]; ++i)
    {
      border += 1 + graph.PointCount(cycles.Arcs[i].Arc);
    }
    layout.Offsets[cycle + 1] = layout.Offsets[cycle] + border;
  }
  return layout;
}

template <typename Id>
void WriteTriangles(const TriangleLayout& layout, const NodeGraph& graph,
  const Crossings& crossings, const NodePoints& nodes, const Cycles& cycles,
  const Execution& execution, Id* connectivity)
{
  execution.For(cycles.Count(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Index> border, nodePlaces;
      std::vector<Quadrilateral> quadrilaterals;
      for (std::size_t cycle = begin; cycle < end; ++cycle)
      {
        GetBoundary(graph, crossings, nodes, cycles, static_cast<Index>(cycle), border, nodePlaces);
        const Index size = static_cast<Index>(border.size());
        SplitIntoQuadrilaterals(size, nodePlaces, quadrilaterals);
        const Id center = static_cast<Id>(graph.Count()) + static_cast<Id>(cycle);
        Id* out = connectivity + 3 * layout.Offsets[cycle];
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
    });
}

template void WriteTriangles(const TriangleLayout&, const NodeGraph&, const Crossings&,
  const NodePoints&, const Cycles&, const Execution&, std::int32_t*);
template void WriteTriangles(const TriangleLayout&, const NodeGraph&, const Crossings&,
  const NodePoints&, const Cycles&, const Execution&, long long*);
}
