// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/RemoveComponents.h"

#include "Core/Base/Box.h"
#include "Core/Graph/EditGraph.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// The bounding boxes of the components of G.
std::vector<Box3> BoxesOf(const NodePoints& nodes, const NodeGraph& graph)
{
  std::vector<Box3> boxes(graph.Components);
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    boxes[graph.Component[node]].Add(graph.PointAt(node));
  }
  const Index arcs = graph.Arcs + static_cast<Index>(graph.Loops.size());
  for (Index arc = 0; arc < arcs; ++arc)
  {
    if (graph.PointCount(arc) == 0)
    {
      continue;
    }
    const Index part = graph.IsLoop(arc) ? graph.Nodes + (arc - graph.Arcs) : nodes.NodeOf[arc];
    for (Index i = 0; i < graph.PointCount(arc); ++i)
    {
      boxes[graph.Component[part]].Add(graph.PointAt(graph.FirstPoint(arc) + i));
    }
  }
  return boxes;
}
}

std::vector<std::uint8_t> FindSmallComponents(
  double size, const NodePoints& nodes, const NodeGraph& graph)
{
  std::vector<std::uint8_t> isSmall;
  for (const Box3& box : BoxesOf(nodes, graph))
  {
    isSmall.push_back(box.Diagonal() < size ? 1 : 0);
  }
  return isSmall;
}

std::vector<std::uint8_t> FindVirtualComponents(const SpatialGrid& grid,
  const GridCrossings& crossings, const NodePoints& nodes, const NodeGraph& graph)
{
  std::vector<std::uint8_t> isVirtual(graph.Components, 1);
  const GridEdgeCode code(grid);
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    const GridEdge edge = code.Decode(crossings.Edge[nodes.First[node]]);
    for (const int family : { 0, 1 })
    {
      isVirtual[graph.Component[node]] &= IsVirtualSlice(grid, edge, family) ? 1 : 0;
    }
  }
  for (std::size_t loop = 0; loop < graph.Loops.size(); ++loop)
  {
    const Face& face = graph.Loops[loop];
    isVirtual[graph.Component[graph.Nodes + loop]] &= grid.IsVirtual(face.Axis, face.Plane) ? 1 : 0;
  }
  return isVirtual;
}

Index RemoveComponents(const std::vector<std::uint8_t>& marked, const ComponentTables& tables)
{
  const NodeGraph& graph = tables.Graph;
  const Index count = static_cast<Index>(std::count(marked.begin(), marked.end(), 1));
  if (count == 0)
  {
    return 0;
  }
  for (Index contour = 0; contour < tables.Isolated.Count(); ++contour)
  {
    const Index loop = tables.Isolated.Loop[contour];
    if (loop != IsolatedContours::None)
    {
      tables.Isolated.LeftOut[contour] |= marked[graph.Component[graph.Nodes + loop]];
    }
  }
  std::vector<std::uint8_t> isRemoved(graph.Nodes);
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    isRemoved[node] = marked[graph.Component[node]];
  }
  RemoveNodes(isRemoved, tables.Crossings, tables.Nodes, tables.NodeNormals, tables.Graph);
  return count;
}
}
