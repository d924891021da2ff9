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
class GraphBuilder
{
public:
  GraphBuilder(const Contours& contours, const SpatialGrid& grid, const Crossings& crossings,
    const NodePoints& nodes, double tolerance)
    : Set(contours)
    , Grid(grid)
    , Code(grid)
    , Lattice(crossings)
    , Nodes(nodes)
    , Tolerance(tolerance)
  {
  }

  NodeGraph Run(const Execution& execution);

private:
  /// Calls visit(contour, vertex) along the arc, without vertices at the place of its crossings.
  template <typename Visit>
  void VisitArc(Index arc, Visit&& visit) const;
  bool IsAtCrossing(Index contour, Index vertex, Index crossing) const;
  Point3 Displacement(Index crossing) const;
  Index CountPoints(Index arc) const;
  void WriteArc(Index arc, double* points) const;
  void Fade(Index arc, double* begin, double* end) const;

  const Contours& Set;
  const SpatialGrid& Grid;
  GridEdgeCode Code;
  const Crossings& Lattice;
  const NodePoints& Nodes;
  double Tolerance;
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

Index GraphBuilder::CountPoints(Index arc) const
{
  Index count = 0;
  this->VisitArc(arc, [&](Index, Index) { ++count; });
  return count;
}

/// How far the node lies from the crossing of this contour; zero within the tolerance.
Point3 GraphBuilder::Displacement(Index crossing) const
{
  Point3 displacement{ 0.0, 0.0, 0.0 };
  const Index node = this->Nodes.NodeOf[crossing];
  if (NodeDisagreement(this->Lattice, this->Nodes, node) > this->Tolerance)
  {
    const int t = this->Code.Decode(this->Lattice.Edge[crossing]).Direction;
    displacement[t] = this->Nodes.Position[node] - this->Lattice.Position[crossing];
  }
  return displacement;
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
  this->Fade(arc, points, out);
}

double Distance(const double* a, const double* b)
{
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

/// Moves the vertices of an arc by the displacements of its ends, linearly along its length.
void GraphBuilder::Fade(Index arc, double* begin, double* end) const
{
  const Index last = this->Lattice.Next[arc];
  const Point3 atStart = this->Displacement(arc);
  const Point3 atEnd = this->Displacement(last);
  const Point3 none{ 0.0, 0.0, 0.0 };
  if (begin == end || (atStart == none && atEnd == none))
  {
    return;
  }
  const auto place = [&](Index crossing)
  {
    return CrossingPoint(
      this->Grid, this->Code, this->Lattice.Edge[crossing], this->Lattice.Position[crossing]);
  };
  const Point3 start = place(arc);
  const Point3 stop = place(last);
  std::vector<double> lengths;
  double length = 0.0;
  const double* previous = start.data();
  for (const double* p = begin; p != end; p += 3)
  {
    length += Distance(previous, p);
    lengths.push_back(length);
    previous = p;
  }
  length += Distance(previous, stop.data());
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    const double share = length > 0.0 ? lengths[i] / length : 0.5;
    for (int axis = 0; axis < 3; ++axis)
    {
      double& x = begin[3 * i + axis];
      x = this->Grid.Round(x + (1.0 - share) * atStart[axis] + share * atEnd[axis]);
    }
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
  return graph;
}
}

NodeGraph BuildNodeGraph(const Contours& contours, const SpatialGrid& grid,
  const Crossings& crossings, const NodePoints& nodes, double tolerance, const Execution& execution)
{
  return GraphBuilder(contours, grid, crossings, nodes, tolerance).Run(execution);
}

void FindComponents(const Crossings& crossings, const NodePoints& nodes, NodeGraph& graph)
{
  std::vector<Index> parent(graph.Nodes);
  std::iota(parent.begin(), parent.end(), 0);
  for (Index arc = 0; arc < crossings.Count(); ++arc)
  {
    if (!crossings.IsRemoved(arc))
    {
      const Index a = FindRoot(parent, nodes.NodeOf[arc]);
      const Index b = FindRoot(parent, nodes.NodeOf[crossings.Next[arc]]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  graph.Component.resize(graph.Nodes);
  graph.Components = 0;
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    const Index root = FindRoot(parent, node);
    graph.Component[node] = root == node ? graph.Components++ : graph.Component[root];
  }
}
}
