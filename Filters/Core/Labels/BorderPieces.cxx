// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/BorderPieces.h"

#include "Core/Base/Vectors.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// A side of an arc as seen from one of its ends, on the slices across an axis.
struct SideAt
{
  int Axis;
  Point3 From, To;

  bool operator<(const SideAt& other) const
  {
    return this->Axis != other.Axis ? this->Axis < other.Axis
      : this->From != other.From    ? this->From < other.From
                                    : this->To < other.To;
  }
  bool operator==(const SideAt& other) const
  {
    return this->Axis == other.Axis && this->From == other.From && this->To == other.To;
  }
};

template <typename Value>
void SortUnique(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

bool Has(const std::vector<Point3>& places, const Point3& place)
{
  return std::binary_search(places.begin(), places.end(), place);
}

/// The axis of the slice of an arc or a loop.
int AxisOf(const CycleGeometry& geometry, const GridEdgeCode& code, Index arc)
{
  if (geometry.Graph.IsLoop(arc))
  {
    return geometry.Graph.Loops[arc - geometry.Graph.Arcs].Axis;
  }
  const GridEdge edge = code.Decode(geometry.Crossings.Edge[arc]);
  return geometry.Crossings.Family[arc] == 0 ? FirstAxis(edge.Direction)
                                             : SecondAxis(edge.Direction);
}

Index CountArcs(const NodeGraph& graph)
{
  return graph.Arcs + static_cast<Index>(graph.Loops.size());
}

bool IsThere(const CycleGeometry& geometry, Index arc)
{
  return geometry.Graph.IsLoop(arc) || !geometry.Crossings.IsRemoved(arc);
}

/// The sides of all arcs and loops of a structure, from both of their ends.
void AddSides(const CycleGeometry& geometry, std::vector<SideAt>& sides)
{
  const GridEdgeCode code(geometry.Grid);
  for (Index arc = 0; arc < CountArcs(geometry.Graph); ++arc)
  {
    if (!IsThere(geometry, arc))
    {
      continue;
    }
    const int axis = AxisOf(geometry, code, arc);
    const std::vector<Index> points = BorderPieces::PointsOf(geometry, arc);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      const Point3 p = geometry.Graph.PointAt(points[i]);
      const Point3 q = geometry.Graph.PointAt(points[i + 1]);
      sides.push_back({ axis, p, q });
      sides.push_back({ axis, q, p });
    }
  }
}

/// Where other than two sides of one slice end.
void AddPartings(std::vector<SideAt>& sides, std::vector<Point3>& places)
{
  SortUnique(sides);
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last)
  {
    for (; last < sides.size() && sides[last].Axis == sides[first].Axis &&
         sides[last].From == sides[first].From;
         ++last)
    {
    }
    if (last - first != 2)
    {
      places.push_back(sides[first].From);
    }
  }
}
}

std::vector<Index> BorderPieces::PointsOf(const CycleGeometry& geometry, Index arc)
{
  const NodeGraph& graph = geometry.Graph;
  std::vector<Index> points;
  const bool isLoop = graph.IsLoop(arc);
  if (!isLoop)
  {
    points.push_back(geometry.Nodes.NodeOf[arc]);
  }
  for (Index i = 0; i < graph.PointCount(arc); ++i)
  {
    points.push_back(graph.FirstPoint(arc) + i);
  }
  points.push_back(isLoop ? points.front() : geometry.Nodes.NodeOf[geometry.Crossings.Next[arc]]);
  return points;
}

void BorderPieces::FindCuts(const std::vector<ArcSurface>& structures)
{
  std::vector<SideAt> sides;
  for (const ArcSurface& surface : structures)
  {
    const NodeGraph& graph = surface.Geometry.Graph;
    AddSides(surface.Geometry, sides);
    for (Index point = 0; point < graph.Count(); ++point)
    {
      const std::vector<std::uint8_t>& corners = surface.Normals.Corners;
      if (point < graph.Nodes || (!corners.empty() && corners[point] != 0))
      {
        this->Cuts.push_back(graph.PointAt(point));
      }
    }
  }
  AddPartings(sides, this->Cuts);
  SortUnique(this->Cuts);
  for (const ArcSurface& surface : structures)
  {
    const NodeGraph& graph = surface.Geometry.Graph;
    for (Index point = graph.Nodes; point < graph.Count(); ++point)
    {
      const Point3 place = graph.PointAt(point);
      if (Has(this->Cuts, place))
      {
        this->Inner.push_back(place);
      }
    }
  }
  SortUnique(this->Inner);
}

bool BorderPieces::IsInsideArc(const Point3& place) const { return Has(this->Inner, place); }

PieceInArc BorderPieces::AddPiece(int axis, std::vector<Point3>&& points)
{
  const bool isReversed = points.front() != points.back() ? points.back() < points.front()
                                                          : points[points.size() - 2] < points[1];
  if (isReversed)
  {
    std::reverse(points.begin(), points.end());
  }
  const Index number = static_cast<Index>(this->Pieces.size());
  const auto [found, isNew] = this->Numbers.insert({ { axis, points[0], points[1] }, number });
  if (isNew)
  {
    this->Pieces.push_back({ axis, std::move(points), false });
  }
  else if (this->Pieces[found->second].Points != points)
  {
    // It has a number of its own.
    this->Pieces[found->second].IsFixed = true;
    this->Pieces.push_back({ axis, std::move(points), true });
    return { number, 0, isReversed };
  }
  return { found->second, 0, isReversed };
}

void BorderPieces::AddArc(const ArcSurface& surface, std::size_t structure, Index arc)
{
  const NodeGraph& graph = surface.Geometry.Graph;
  const int axis = AxisOf(surface.Geometry, GridEdgeCode(surface.Geometry.Grid), arc);
  const std::vector<Index> points = PointsOf(surface.Geometry, arc);
  std::vector<Point3> part{ graph.PointAt(points.front()) };
  std::size_t first = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    part.push_back(graph.PointAt(points[i]));
    if (i + 1 == points.size() || Has(this->Cuts, part.back()))
    {
      const Point3 last = part.back();
      PieceInArc piece = this->AddPiece(axis, std::move(part));
      piece.First = static_cast<Index>(first);
      this->OfArc[structure][arc].push_back(piece);
      part = { last };
      first = i;
    }
  }
}

void BorderPieces::Fix(std::size_t structure, Index arc)
{
  for (const PieceInArc& piece : this->OfArc[structure][arc])
  {
    this->Pieces[piece.Piece].IsFixed = true;
  }
}

std::array<PieceEnd, 4> BorderPieces::EndsAt(
  const CycleGeometry& geometry, std::size_t structure, Index node) const
{
  std::array<PieceEnd, 4> ends;
  std::size_t next = 0;
  for (const Index crossing : { geometry.Nodes.First[node], geometry.Nodes.Second[node] })
  {
    const PieceInArc& after = this->OfArc[structure][crossing].front();
    const PieceInArc& before = this->OfArc[structure][geometry.Crossings.Previous[crossing]].back();
    ends[next++] = { after.Piece, after.IsReversed ? 1 : 0 };
    ends[next++] = { before.Piece, before.IsReversed ? 0 : 1 };
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

BorderPieces::BorderPieces(const std::vector<ArcSurface>& structures)
{
  this->FindCuts(structures);
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    const CycleGeometry& geometry = structures[i].Geometry;
    const Index arcs = CountArcs(geometry.Graph);
    this->OfArc.emplace_back(arcs);
    for (Index arc = 0; arc < arcs; ++arc)
    {
      if (IsThere(geometry, arc))
      {
        this->AddArc(structures[i], i, arc);
      }
      if (geometry.Graph.IsLoop(arc))
      {
        this->Fix(i, arc);
      }
    }
  }
}
}
