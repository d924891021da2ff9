// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/RemoveSmallComponents.h"

#include "Core/Base/Box.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
class ComponentRemover
{
public:
  ComponentRemover(GridCrossings& crossings, NodePoints& nodes, std::vector<double>& nodeNormals,
    IsolatedContours& isolated, NodeGraph& graph)
    : Crossings(crossings)
    , Nodes(nodes)
    , NodeNormals(nodeNormals)
    , Isolated(isolated)
    , Graph(graph)
  {
  }

  Index Run(double size);

private:
  Index FindSmall(double size);
  bool IsSmall(Index part) const { return this->Small[this->Graph.Component[part]] != 0; }
  void RemoveNodes();
  void RemovePoints();

  GridCrossings& Crossings;
  NodePoints& Nodes;
  std::vector<double>& NodeNormals;
  IsolatedContours& Isolated;
  NodeGraph& Graph;
  std::vector<std::uint8_t> Small; ///< components
};

Index ComponentRemover::FindSmall(double size)
{
  std::vector<Box3> boxes(this->Graph.Components);
  const auto enlarge = [&](Index component, Index point)
  { boxes[component].Add(this->Graph.PointAt(point)); };
  for (Index node = 0; node < this->Graph.Nodes; ++node)
  {
    enlarge(this->Graph.Component[node], node);
  }
  const Index arcs = this->Graph.Arcs + static_cast<Index>(this->Graph.Loops.size());
  for (Index arc = 0; arc < arcs; ++arc)
  {
    if (this->Graph.PointCount(arc) > 0)
    {
      const Index part = this->Graph.IsLoop(arc) ? this->Graph.Nodes + (arc - this->Graph.Arcs)
                                                 : this->Nodes.NodeOf[arc];
      for (Index i = 0; i < this->Graph.PointCount(arc); ++i)
      {
        enlarge(this->Graph.Component[part], this->Graph.FirstPoint(arc) + i);
      }
    }
  }
  Index count = 0;
  for (Index component = 0; component < this->Graph.Components; ++component)
  {
    this->Small.push_back(boxes[component].Diagonal() < size ? 1 : 0);
    count += this->Small.back();
  }
  return count;
}

/// The points of G that stay, with new offsets.
void ComponentRemover::RemovePoints()
{
  std::vector<double> points;
  std::vector<Index> offsets(1, 0);
  std::vector<Face> loops;
  const auto copy = [&](Index first, Index count)
  {
    const auto begin = this->Graph.Points.begin() + 3 * static_cast<std::ptrdiff_t>(first);
    points.insert(points.end(), begin, begin + 3 * static_cast<std::ptrdiff_t>(count));
  };
  Index nodes = 0;
  for (Index node = 0; node < this->Graph.Nodes; ++node)
  {
    if (!this->IsSmall(node))
    {
      copy(node, 1);
      ++nodes;
    }
  }
  for (Index arc = 0; arc < this->Graph.Arcs; ++arc)
  {
    if (!this->Crossings.IsRemoved(arc) && !this->IsSmall(this->Nodes.NodeOf[arc]))
    {
      copy(this->Graph.FirstPoint(arc), this->Graph.PointCount(arc));
    }
    offsets.push_back(static_cast<Index>(points.size() / 3) - nodes);
  }
  std::vector<Index> newLoop;
  for (Index loop = 0; loop < static_cast<Index>(this->Graph.Loops.size()); ++loop)
  {
    const bool small = this->IsSmall(this->Graph.Nodes + loop);
    newLoop.push_back(small ? IsolatedContours::None : static_cast<Index>(loops.size()));
    if (!small)
    {
      const Index arc = this->Graph.Arcs + loop;
      copy(this->Graph.FirstPoint(arc), this->Graph.PointCount(arc));
      offsets.push_back(static_cast<Index>(points.size() / 3) - nodes);
      loops.push_back(this->Graph.Loops[loop]);
    }
  }
  for (Index contour = 0; contour < this->Isolated.Count(); ++contour)
  {
    Index& loop = this->Isolated.Loop[contour];
    if (loop != IsolatedContours::None)
    {
      loop = newLoop[loop];
      this->Isolated.LeftOut[contour] |= loop == IsolatedContours::None;
    }
  }
  this->Graph.Points.swap(points);
  this->Graph.Offsets.swap(offsets);
  this->Graph.Loops.swap(loops);
}

void ComponentRemover::RemoveNodes()
{
  NodePoints& nodes = this->Nodes;
  Index kept = 0;
  for (Index node = 0; node < this->Graph.Nodes; ++node)
  {
    const bool small = this->IsSmall(node);
    for (const Index crossing : { nodes.First[node], nodes.Second[node] })
    {
      nodes.NodeOf[crossing] = small ? GridCrossings::None : kept;
      this->Crossings.Next[crossing] =
        small ? GridCrossings::Removed : this->Crossings.Next[crossing];
    }
    if (!small)
    {
      nodes.First[kept] = nodes.First[node];
      nodes.Second[kept] = nodes.Second[node];
      nodes.Position[kept] = nodes.Position[node];
      nodes.Difference[kept] = nodes.Difference[node];
      std::copy_n(this->NodeNormals.begin() + 3 * static_cast<std::ptrdiff_t>(node), 3,
        this->NodeNormals.begin() + 3 * static_cast<std::ptrdiff_t>(kept));
      ++kept;
    }
  }
  nodes.First.resize(kept);
  nodes.Second.resize(kept);
  nodes.Position.resize(kept);
  nodes.Difference.resize(kept);
  this->NodeNormals.resize(3 * static_cast<std::size_t>(kept));
  this->Graph.Nodes = kept;
}

Index ComponentRemover::Run(double size)
{
  const Index count = this->FindSmall(size);
  if (count > 0)
  {
    this->RemovePoints();
    this->RemoveNodes();
    this->Graph.Component.clear();
  }
  return count;
}
}

Index RemoveSmallComponents(double size, GridCrossings& crossings, NodePoints& nodes,
  std::vector<double>& nodeNormals, IsolatedContours& isolated, NodeGraph& graph)
{
  return ComponentRemover(crossings, nodes, nodeNormals, isolated, graph).Run(size);
}
}
