// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/RemoveSmallComponents.h"

#include "Core/Base/Box.h"
#include "Core/Graph/EditGraph.h"

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

Index RemoveSmallComponents(double size, const ComponentTables& tables)
{
  const NodeGraph& graph = tables.Graph;
  std::vector<std::uint8_t> isSmall; // components
  Index count = 0;
  for (const Box3& box : BoxesOf(tables.Nodes, graph))
  {
    isSmall.push_back(box.Diagonal() < size ? 1 : 0);
    count += isSmall.back();
  }
  if (count == 0)
  {
    return 0;
  }
  for (Index contour = 0; contour < tables.Isolated.Count(); ++contour)
  {
    const Index loop = tables.Isolated.Loop[contour];
    if (loop != IsolatedContours::None)
    {
      tables.Isolated.LeftOut[contour] |= isSmall[graph.Component[graph.Nodes + loop]];
    }
  }
  std::vector<std::uint8_t> isRemoved(graph.Nodes);
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    isRemoved[node] = isSmall[graph.Component[node]];
  }
  RemoveNodes(isRemoved, tables.Crossings, tables.Nodes, tables.NodeNormals, tables.Graph);
  return count;
}
}
