// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/NodeGraph.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/**
 * How far an end of an arc moves along its edge of M. Other points move along, by less towards the
 * ends of the edge, so that they do not leave the face of the arc.
 */
struct EndShift
{
  int Axis = 0;
  double From = 0.0, Amount = 0.0;
  double Low = -HUGE_VAL, High = HUGE_VAL; ///< ends of the edge

  double At(const double* point) const
  {
    const double x = point[this->Axis];
    const double end = x < this->From ? this->Low : this->High;
    if (end == this->From)
    {
      return 0.0;
    }
    return std::isfinite(end) ? this->Amount * ((end - x) / (end - this->From)) : this->Amount;
  }
};

/// An end of a part of an arc: where it was, and how it moves.
struct PartEnd
{
  Point3 Place;
  EndShift Shift;
};

class GraphBuilder
{
public:
  GraphBuilder(const ArcSource& source, double tolerance)
    : Set(source.Contours)
    , Grid(source.Grid)
    , Code(source.Grid)
    , Crossings(source.Crossings)
    , Nodes(source.Nodes)
    , Fixed(source.Fixed)
    , Tolerance(tolerance)
  {
  }

  NodeGraph Run(const Execution& execution);

private:
  /// Calls visit(contour, vertex) along the arc, without vertices at the place of its crossings.
  template <typename Visit>
  void VisitArc(Index arc, Visit&& visit) const;
  bool IsAtCrossing(Index contour, Index vertex, Index crossing) const;
  EndShift Displacement(Index crossing) const;
  Index CountPoints(Index arc) const;
  void WriteArc(Index arc, double* points) const;
  void Fade(Index arc, double* begin, double* end) const;
  void FadePart(std::array<PartEnd, 2> ends, const std::vector<double*>& points) const;

  const Contours& Set;
  const SpatialGrid& Grid;
  GridEdgeCode Code;
  const GridCrossings& Crossings;
  const NodePoints& Nodes;
  const std::set<Point3>* Fixed;
  double Tolerance;
};

bool GraphBuilder::IsAtCrossing(Index contour, Index vertex, Index crossing) const
{
  // On the crossed plane and at the crossing's position along the edge: the same point of the
  // slice.
  const GridEdge edge = this->Code.Decode(this->Crossings.Edge[crossing]);
  const int axis = this->Set.Axis[contour];
  const bool alongV = edge.Direction == SecondAxis(axis);
  const double across = alongV ? this->Set.U[vertex] : this->Set.V[vertex];
  const double along = alongV ? this->Set.V[vertex] : this->Set.U[vertex];
  const int crossed = alongV ? FirstAxis(axis) : SecondAxis(axis);
  const Index plane = alongV ? edge.Second : edge.First;
  return along == this->Crossings.Position[crossing] && across == this->Grid.Planes[crossed][plane];
}

template <typename Visit>
void GraphBuilder::VisitArc(Index arc, Visit&& visit) const
{
  const Index endCrossing = this->Crossings.Next[arc];
  for (Index run = arc; run != GridCrossings::None; run = this->Crossings.RunNext[run])
  {
    const Index contour = this->Crossings.RunContour[run];
    const Index count = this->Crossings.RunCount[run];
    for (Index i = 0; i < count; ++i)
    {
      Index vertex = this->Crossings.RunFirst[run] + i;
      vertex -= vertex >= this->Set.Offsets[contour + 1] ? this->Set.Size(contour) : 0;
      const bool first = run == arc && i == 0;
      const bool last = i + 1 == count && this->Crossings.RunNext[run] == GridCrossings::None;
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

/// How far the node lies from the crossing of this contour; zero within the tolerance, and where a
/// real slice meets a virtual one.
EndShift GraphBuilder::Displacement(Index crossing) const
{
  const Index node = this->Nodes.NodeOf[crossing];
  EndShift shift;
  if (!this->Grid.HasVirtual() && this->Nodes.Disagreement(node) <= this->Tolerance)
  {
    return shift;
  }
  const GridEdge edge = this->Code.Decode(this->Crossings.Edge[crossing]);
  const double disagreement = IsVirtualSlice(this->Grid, edge, this->Crossings.Family[crossing])
    ? std::abs(this->Nodes.Position[node] - this->Crossings.Position[crossing])
    : this->Nodes.Disagreement(node);
  if (disagreement <= this->Tolerance)
  {
    return shift;
  }
  shift.Axis = edge.Direction;
  shift.From = this->Crossings.Position[crossing];
  shift.Amount = this->Nodes.Position[node] - shift.From;
  const auto& planes = this->Grid.Planes[shift.Axis];
  shift.Low = edge.Slab > 0 ? planes[edge.Slab - 1] : shift.Low;
  shift.High = edge.Slab < this->Grid.Count(shift.Axis) ? planes[edge.Slab] : shift.High;
  return shift;
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

/// Moves the vertices of an arc with its ends, part by part between those that are fixed.
void GraphBuilder::Fade(Index arc, double* begin, double* end) const
{
  const Index last = this->Crossings.Next[arc];
  const EndShift atStart = this->Displacement(arc);
  const EndShift atEnd = this->Displacement(last);
  if (begin == end || (atStart.Amount == 0.0 && atEnd.Amount == 0.0))
  {
    return;
  }
  const auto place = [&](Index crossing)
  {
    return CrossingPoint(
      this->Grid, this->Code, this->Crossings.Edge[crossing], this->Crossings.Position[crossing]);
  };
  PartEnd from{ place(arc), atStart };
  std::vector<double*> part;
  for (double* p = begin; p != end; p += 3)
  {
    const Point3 here{ p[0], p[1], p[2] };
    if (this->Fixed != nullptr && this->Fixed->count(here) > 0)
    {
      this->FadePart({ from, { here, {} } }, part);
      from = { here, {} };
      part.clear();
    }
    else
    {
      part.push_back(p);
    }
  }
  this->FadePart({ from, { place(last), atEnd } }, part);
}

/// Moves points between two ends by shares that are linear along the length.
void GraphBuilder::FadePart(std::array<PartEnd, 2> ends, const std::vector<double*>& between) const
{
  std::vector<double*> points = between;
  if (this->Grid.BothWays && ends[1].Place < ends[0].Place)
  {
    std::swap(ends[0], ends[1]);
    std::reverse(points.begin(), points.end());
  }
  const EndShift &atStart = ends[0].Shift, &atEnd = ends[1].Shift;
  std::vector<double> lengths;
  double length = 0.0;
  const double* previous = ends[0].Place.data();
  for (const double* p : points)
  {
    length += Distance(previous, p);
    lengths.push_back(length);
    previous = p;
  }
  length += Distance(previous, ends[1].Place.data());
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    const double share = length > 0.0 ? lengths[i] / length : 0.5;
    double* point = points[i];
    const double first = (1.0 - share) * atStart.At(point);
    const double second = share * atEnd.At(point);
    point[atStart.Axis] += first;
    point[atEnd.Axis] += second;
    for (const int axis : { atStart.Axis, atEnd.Axis })
    {
      // An outermost edge has no end at which points would stay.
      point[axis] = this->Grid.MoveIntoBounds(axis, point[axis]);
    }
  }
}

NodeGraph GraphBuilder::Run(const Execution& execution)
{
  NodeGraph graph;
  const std::size_t arcs = this->Crossings.Count();
  graph.Nodes = this->Nodes.Count();
  graph.Arcs = this->Crossings.Count();
  graph.Offsets.assign(arcs + 1, 0);
  execution.For(arcs,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t arc = begin; arc < end; ++arc)
      {
        const Index a = static_cast<Index>(arc);
        graph.Offsets[arc + 1] = this->Crossings.IsRemoved(a) ? 0 : this->CountPoints(a);
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
          this->Grid, this->Code, this->Crossings, this->Nodes, static_cast<Index>(node));
        std::copy(point.begin(), point.end(), graph.Points.begin() + 3 * node);
      }
    });
  execution.For(arcs,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t arc = begin; arc < end; ++arc)
      {
        if (!this->Crossings.IsRemoved(static_cast<Index>(arc)))
        {
          const std::size_t first = graph.FirstPoint(static_cast<Index>(arc));
          this->WriteArc(static_cast<Index>(arc), graph.Points.data() + 3 * first);
        }
      }
    });
  return graph;
}
}

NodeGraph BuildNodeGraph(const ArcSource& source, double tolerance, const Execution& execution)
{
  return GraphBuilder(source, tolerance).Run(execution);
}

DisjointSets ConnectArcs(
  const GridCrossings& crossings, const NodePoints& nodes, const NodeGraph& graph)
{
  DisjointSets parts(graph.Nodes + static_cast<Index>(graph.Loops.size()));
  for (Index arc = 0; arc < crossings.Count(); ++arc)
  {
    if (!crossings.IsRemoved(arc))
    {
      parts.Unite(nodes.NodeOf[arc], nodes.NodeOf[crossings.Next[arc]]);
    }
  }
  return parts;
}
}
