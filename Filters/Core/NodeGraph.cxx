// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NodeGraph.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// How far inside its face the vertex of an empty arc lies, as a part of the slab's width.
constexpr double PushFraction = 1e-3;

class GraphBuilder
{
public:
  GraphBuilder(const Contours& contours, const SpatialGrid& grid, const Crossings& crossings,
    const NodePoints& nodes)
    : Set(contours)
    , Grid(grid)
    , Code(grid)
    , Lattice(crossings)
    , Nodes(nodes)
  {
  }

  NodeGraph Run(const Execution& execution);

private:
  /// Calls visit(contour, vertex) along the arc, without vertices at the place of its crossings.
  template <typename Visit>
  void VisitArc(Index arc, Visit&& visit) const;
  bool IsAtCrossing(Index contour, Index vertex, Index crossing) const;
  bool NeedsPoint(Index arc) const;
  Point3 PushedPoint(Index arc) const;
  Index CountPoints(Index arc) const;
  void WriteArc(Index arc, double* points) const;
  void FindComponents(NodeGraph& graph) const;

  const Contours& Set;
  const SpatialGrid& Grid;
  GridEdgeCode Code;
  const Crossings& Lattice;
  const NodePoints& Nodes;
};

bool GraphBuilder::IsAtCrossing(Index contour, Index vertex, Index crossing) const
{
  // On the crossed plane and at the crossing's position along the edge: the same point of the
  // slice.
  const GridEdge edge = this->Code.Decode(this->Lattice.Edge[crossing]);
  const int axis = this->Set.Axis[contour];
  const bool alongV = edge.Direction == SecondAxis(axis);
  const double across = alongV ? this->Set.U[vertex] : this->Set.V[vertex];
  const double along = alongV ? this->Set.V[vertex] : this->Set.U[vertex];
  const int crossed = alongV ? FirstAxis(axis) : SecondAxis(axis);
  const Index plane = alongV ? edge.Second : edge.First;
  return along == this->Lattice.Position[crossing] && across == this->Grid.Planes[crossed][plane];
}

template <typename Visit>
void GraphBuilder::VisitArc(Index arc, Visit&& visit) const
{
  const Index endCrossing = this->Lattice.Next[arc];
  for (Index run = arc; run != Crossings::None; run = this->Lattice.RunNext[run])
  {
    const Index contour = this->Lattice.RunContour[run];
    const Index count = this->Lattice.RunCount[run];
    for (Index i = 0; i < count; ++i)
    {
      Index vertex = this->Lattice.RunFirst[run] + i;
      vertex -= vertex >= this->Set.Offsets[contour + 1] ? this->Set.Size(contour) : 0;
      const bool first = run == arc && i == 0;
      const bool last = i + 1 == count && this->Lattice.RunNext[run] == Crossings::None;
      if ((first && this->IsAtCrossing(contour, vertex, arc)) ||
        (last && this->IsAtCrossing(contour, vertex, endCrossing)))
      {
        continue;
      }
      visit(contour, vertex);
    }
  }
}

bool GraphBuilder::NeedsPoint(Index arc) const
{
  return this->Lattice.Edge[arc] == this->Lattice.Edge[this->Lattice.Next[arc]];
}

Index GraphBuilder::CountPoints(Index arc) const
{
  Index count = 0;
  this->VisitArc(arc, [&](Index, Index) { ++count; });
  return count > 0 || !this->NeedsPoint(arc) ? count : 1;
}

/// Midway between the two nodes of an empty arc and a little into its face.
Point3 GraphBuilder::PushedPoint(Index arc) const
{
  const Point3 a =
    NodePosition(this->Grid, this->Code, this->Lattice, this->Nodes, this->Nodes.NodeOf[arc]);
  const Point3 b = NodePosition(this->Grid, this->Code, this->Lattice, this->Nodes,
    this->Nodes.NodeOf[this->Lattice.Next[arc]]);
  const GridEdge edge = this->Code.Decode(this->Lattice.Edge[arc]);
  // The face lies on the side of the crossed plane to which the contour goes.
  const int crossed =
    this->Lattice.Family[arc] == 0 ? SecondAxis(edge.Direction) : FirstAxis(edge.Direction);
  const Index plane = this->Lattice.Family[arc] == 0 ? edge.Second : edge.First;
  const Index neighbour = plane + this->Lattice.Direction[arc];
  const auto& planes = this->Grid.Planes[crossed];
  const bool bounded = neighbour >= 0 && neighbour < this->Grid.Count(crossed);
  const double width =
    bounded ? std::abs(planes[neighbour] - planes[plane]) : this->Grid.MeanSpacing(crossed);
  Point3 point;
  for (int i = 0; i < 3; ++i)
  {
    point[i] = a[i] + 0.5 * (b[i] - a[i]);
  }
  point[crossed] += this->Lattice.Direction[arc] * PushFraction * width;
  return point;
}

void GraphBuilder::WriteArc(Index arc, double* points) const
{
  double* out = points;
  this->VisitArc(arc,
    [&](Index contour, Index vertex)
    {
      const Point3 point = this->Set.World(contour, vertex);
      out = std::copy(point.begin(), point.end(), out);
    });
  if (out == points && this->NeedsPoint(arc))
  {
    const Point3 point = this->PushedPoint(arc);
    std::copy(point.begin(), point.end(), points);
  }
}

Index FindRoot(std::vector<Index>& parent, Index i)
{
  while (parent[i] != i)
  {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

void GraphBuilder::FindComponents(NodeGraph& graph) const
{
  std::vector<Index> parent(graph.Nodes);
  std::iota(parent.begin(), parent.end(), 0);
  for (Index arc = 0; arc < this->Lattice.Count(); ++arc)
  {
    if (!this->Lattice.IsRemoved(arc))
    {
      const Index a = FindRoot(parent, this->Nodes.NodeOf[arc]);
      const Index b = FindRoot(parent, this->Nodes.NodeOf[this->Lattice.Next[arc]]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  graph.Component.resize(graph.Nodes);
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    const Index root = FindRoot(parent, node);
    graph.Component[node] = root == node ? graph.Components++ : graph.Component[root];
  }
}

NodeGraph GraphBuilder::Run(const Execution& execution)
{
  NodeGraph graph;
  const std::size_t arcs = this->Lattice.Count();
  graph.Nodes = this->Nodes.Count();
  graph.Offsets.assign(arcs + 1, 0);
  execution.For(arcs,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t arc = begin; arc < end; ++arc)
      {
        const Index a = static_cast<Index>(arc);
        graph.Offsets[arc + 1] = this->Lattice.IsRemoved(a) ? 0 : this->CountPoints(a);
      }
    });
  std::partial_sum(graph.Offsets.begin(), graph.Offsets.end(), graph.Offsets.begin());
  graph.Points.resize(3 * (static_cast<std::size_t>(graph.Nodes) + graph.Offsets.back()));
  execution.For(graph.Nodes,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t node = begin; node < end; ++node)
      {
        const Point3 point = NodePosition(
          this->Grid, this->Code, this->Lattice, this->Nodes, static_cast<Index>(node));
        std::copy(point.begin(), point.end(), graph.Points.begin() + 3 * node);
      }
    });
  execution.For(arcs,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t arc = begin; arc < end; ++arc)
      {
        if (!this->Lattice.IsRemoved(static_cast<Index>(arc)))
        {
          const std::size_t first = graph.FirstPoint(static_cast<Index>(arc));
          this->WriteArc(static_cast<Index>(arc), graph.Points.data() + 3 * first);
        }
      }
    });
  this->FindComponents(graph);
  return graph;
}
}

NodeGraph BuildNodeGraph(const Contours& contours, const SpatialGrid& grid,
  const Crossings& crossings, const NodePoints& nodes, const Execution& execution)
{
  return GraphBuilder(contours, grid, crossings, nodes).Run(execution);
}
}
