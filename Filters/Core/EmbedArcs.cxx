// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmbedArcs.h"

#include "Predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
/// Depth of the outermost shell as a part of the way from the border to the centre of the face.
constexpr double DeepestShell = 0.3;

struct ArcInFace
{
  std::uint64_t Face;
  Index Arc;
};

/// A face of M: the rectangle between its four grid lines.
struct Face
{
  int Axis;
  Index Plane;
  std::array<Index, 2> Slab; ///< along u and v
};

/// An end of an arc on the border of its face. Edges count counter-clockwise from the lower one.
struct BorderEnd
{
  int Edge;
  Index Node;
  Index Crossing;
  bool IsStart; ///< of its arc
};

/// Arcs that replace the geometry of others, in one list.
struct NewArcs
{
  std::vector<Index> Arc;
  std::vector<std::size_t> Offsets{ 0 };
  std::vector<Point3> Points;
};

class ArcEmbedder
{
public:
  ArcEmbedder(
    const SpatialGrid& grid, const NodePoints& nodes, Crossings& crossings, NodeGraph& graph)
    : Grid(grid)
    , Code(grid)
    , Nodes(nodes)
    , Lattice(crossings)
    , Graph(graph)
  {
  }

  std::vector<Repair> Run(const Execution& execution, const std::vector<Index>& forced);

private:
  using Group = std::pair<const ArcInFace*, const ArcInFace*>;

  Face FaceOf(Index arc) const;
  std::vector<ArcInFace> SortByFace() const;
  void MoveInside(const Face& face, Index arc);
  bool IsSimple(const Face& face, Group arcs) const;
  bool IsMonotone(const Face& face, Index arc) const;
  void AddSegments(const Face& face, Index arc, std::vector<PolylineSegment>& segments) const;
  Point2 InPlane(const Face& face, Index point) const;
  template <typename Visit>
  void VisitPoints(Index arc, Visit&& visit) const;

  bool Redraw(const Face& face, Group arcs, NewArcs& redrawn);
  std::vector<BorderEnd> SortEnds(Group arcs) const;
  Index ArcOf(const BorderEnd& end) const
  {
    return end.IsStart ? end.Crossing : this->Lattice.Previous[end.Crossing];
  }
  BorderEnd EndOnBorder(Index crossing, bool isStart) const;
  bool Interlock(const std::vector<BorderEnd>& ends) const;
  void Reconnect(const std::vector<BorderEnd>& ends);
  void DrawShells(const Face& face, const std::vector<BorderEnd>& ends, NewArcs& redrawn) const;
  Repair Describe(
    const Face& face, bool reconnected, const NewArcs& redrawn, std::size_t first) const;
  void Replace(const NewArcs& redrawn);

  const SpatialGrid& Grid;
  GridEdgeCode Code;
  const NodePoints& Nodes;
  Crossings& Lattice;
  NodeGraph& Graph;
};

Face ArcEmbedder::FaceOf(Index arc) const
{
  const GridEdge edge = this->Code.Decode(this->Lattice.Edge[arc]);
  const Index beyond = this->Lattice.Direction[arc] > 0 ? 1 : 0;
  return this->Lattice.Family[arc] == 0
    ? Face{ FirstAxis(edge.Direction), edge.First, { edge.Second + beyond, edge.Slab } }
    : Face{ SecondAxis(edge.Direction), edge.Second, { edge.Slab, edge.First + beyond } };
}

std::vector<ArcInFace> ArcEmbedder::SortByFace() const
{
  std::vector<ArcInFace> arcs;
  arcs.reserve(this->Lattice.Count());
  std::array<std::uint64_t, 3> base{ 0, 0, 0 };
  const auto slabs = [&](int axis)
  { return static_cast<std::uint64_t>(this->Grid.Count(axis) + 1); };
  for (int axis = 0; axis < 2; ++axis)
  {
    base[axis + 1] = base[axis] + slabs(axis) * slabs(FirstAxis(axis)) * slabs(SecondAxis(axis));
  }
  for (Index arc = 0; arc < this->Lattice.Count(); ++arc)
  {
    if (!this->Lattice.IsRemoved(arc))
    {
      const Face face = this->FaceOf(arc);
      const std::uint64_t code = base[face.Axis] +
        (face.Plane * slabs(FirstAxis(face.Axis)) + face.Slab[0]) * slabs(SecondAxis(face.Axis)) +
        face.Slab[1];
      arcs.push_back({ code, arc });
    }
  }
  std::sort(arcs.begin(), arcs.end(),
    [](const ArcInFace& a, const ArcInFace& b)
    { return a.Face != b.Face ? a.Face < b.Face : a.Arc < b.Arc; });
  return arcs;
}

Point2 ArcEmbedder::InPlane(const Face& face, Index point) const
{
  const double* p = this->Graph.Points.data() + 3 * static_cast<std::size_t>(point);
  return { p[FirstAxis(face.Axis)], p[SecondAxis(face.Axis)] };
}

/// Calls visit(point of G) from the first to the last point of an arc, nodes included.
template <typename Visit>
void ArcEmbedder::VisitPoints(Index arc, Visit&& visit) const
{
  visit(this->Nodes.NodeOf[arc]);
  for (Index i = 0; i < this->Graph.PointCount(arc); ++i)
  {
    visit(this->Graph.FirstPoint(arc) + i);
  }
  visit(this->Nodes.NodeOf[this->Lattice.Next[arc]]);
}

void ArcEmbedder::MoveInside(const Face& face, Index arc)
{
  for (Index i = 0; i < this->Graph.PointCount(arc); ++i)
  {
    double* point =
      this->Graph.Points.data() + 3 * static_cast<std::size_t>(this->Graph.FirstPoint(arc) + i);
    for (int side = 0; side < 2; ++side)
    {
      const int axis = (face.Axis + 1 + side) % 3;
      if (!this->Grid.IsInside(axis, face.Slab[side], point[axis]))
      {
        point[axis] = this->Grid.MoveInside(axis, face.Slab[side], point[axis]);
      }
    }
  }
}

/// Every segment goes forward in the direction from end to end: such an arc cannot touch itself.
bool ArcEmbedder::IsMonotone(const Face& face, Index arc) const
{
  const Point2 start = this->InPlane(face, this->Nodes.NodeOf[arc]);
  const Point2 end = this->InPlane(face, this->Nodes.NodeOf[this->Lattice.Next[arc]]);
  const Point2 chord{ end[0] - start[0], end[1] - start[1] };
  bool monotone = true;
  bool first = true;
  Point2 previous = start;
  this->VisitPoints(arc,
    [&](Index point)
    {
      const Point2 p = this->InPlane(face, point);
      const double step = (p[0] - previous[0]) * chord[0] + (p[1] - previous[1]) * chord[1];
      monotone &= first || step > 0.0;
      first = false;
      previous = p;
    });
  return monotone;
}

void ArcEmbedder::AddSegments(
  const Face& face, Index arc, std::vector<PolylineSegment>& segments) const
{
  Index place = -1;
  Point2 previous{ 0.0, 0.0 };
  this->VisitPoints(arc,
    [&](Index point)
    {
      const Point2 p = this->InPlane(face, point);
      if (place >= 0)
      {
        segments.push_back({ previous, p, arc, place });
      }
      ++place;
      previous = p;
    });
}

bool ArcEmbedder::IsSimple(const Face& face, Group arcs) const
{
  for (const ArcInFace* a = arcs.first; a != arcs.second; ++a)
  {
    const bool onEdge =
      this->Lattice.Edge[a->Arc] == this->Lattice.Edge[this->Lattice.Next[a->Arc]];
    if (onEdge && this->Graph.PointCount(a->Arc) == 0)
    {
      return false;
    }
  }
  if (arcs.second - arcs.first == 1 && this->IsMonotone(face, arcs.first->Arc))
  {
    return true;
  }
  std::vector<PolylineSegment> segments;
  for (const ArcInFace* a = arcs.first; a != arcs.second; ++a)
  {
    this->AddSegments(face, a->Arc, segments);
  }
  return AreSimple(segments);
}

BorderEnd ArcEmbedder::EndOnBorder(Index crossing, bool isStart) const
{
  // An arc that starts upwards starts at the lower border; one that ends upwards ends at the
  // upper one.
  const bool lower = (this->Lattice.Direction[crossing] > 0) == isStart;
  const bool acrossU = this->Lattice.Family[crossing] == 0;
  const int edge = acrossU ? (lower ? 3 : 1) : (lower ? 0 : 2);
  return { edge, this->Nodes.NodeOf[crossing], crossing, isStart };
}

/// Counter-clockwise around the face. Nodes on one grid edge are numbered upwards.
std::vector<BorderEnd> ArcEmbedder::SortEnds(Group arcs) const
{
  std::vector<BorderEnd> ends;
  for (const ArcInFace* a = arcs.first; a != arcs.second; ++a)
  {
    ends.push_back(this->EndOnBorder(a->Arc, true));
    ends.push_back(this->EndOnBorder(this->Lattice.Next[a->Arc], false));
  }
  std::sort(ends.begin(), ends.end(),
    [](const BorderEnd& a, const BorderEnd& b) {
      return a.Edge != b.Edge ? a.Edge < b.Edge : a.Edge < 2 ? a.Node < b.Node : a.Node > b.Node;
    });
  return ends;
}

bool ArcEmbedder::Interlock(const std::vector<BorderEnd>& ends) const
{
  std::vector<Index> open;
  for (const BorderEnd& end : ends)
  {
    const Index arc = this->ArcOf(end);
    if (!open.empty() && open.back() == arc)
    {
      open.pop_back();
    }
    else
    {
      open.push_back(arc);
    }
  }
  return !open.empty();
}

/// Joins every start to the nearest free end around the border; starts and ends alternate there.
void ArcEmbedder::Reconnect(const std::vector<BorderEnd>& ends)
{
  std::vector<BorderEnd> open;
  for (const BorderEnd& end : ends)
  {
    if (open.empty() || open.back().IsStart == end.IsStart)
    {
      open.push_back(end);
      continue;
    }
    const Index start = end.IsStart ? end.Crossing : open.back().Crossing;
    const Index stop = end.IsStart ? open.back().Crossing : end.Crossing;
    this->Lattice.Next[start] = stop;
    this->Lattice.Previous[stop] = start;
    open.pop_back();
  }
}

void ArcEmbedder::DrawShells(
  const Face& face, const std::vector<BorderEnd>& ends, NewArcs& redrawn) const
{
  double low[2], high[2], middle[2];
  for (int side = 0; side < 2; ++side)
  {
    const int axis = (face.Axis + 1 + side) % 3;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const BorderEnd& end : ends)
    {
      const double x = this->InPlane(face, end.Node)[side];
      least = std::min(least, x);
      most = std::max(most, x);
    }
    this->Grid.GetExtent(axis, face.Slab[side], least, most, low[side], high[side]);
    middle[side] = low[side] + 0.5 * (high[side] - low[side]);
  }
  const auto inward = [&](const Point2& p, double depth) -> Point3
  {
    Point3 point;
    point[face.Axis] = this->Grid.Planes[face.Axis][face.Plane];
    for (int side = 0; side < 2; ++side)
    {
      point[(face.Axis + 1 + side) % 3] =
        this->Grid.Round(p[side] + depth * (middle[side] - p[side]));
    }
    return point;
  };
  // Corner e lies at the end of edge e.
  const Point2 corners[4] = { { high[0], low[1] }, { high[0], high[1] }, { low[0], high[1] },
    { low[0], low[1] } };
  struct Open
  {
    std::size_t End;
    int Height; ///< greatest number of arcs nested beneath, so far
  };
  const double step = DeepestShell / (0.5 * ends.size());
  std::vector<Open> open;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const Index arc = ends[i].IsStart ? ends[i].Crossing : this->Lattice.Previous[ends[i].Crossing];
    const auto arcOf = [&](const BorderEnd& end)
    { return end.IsStart ? end.Crossing : this->Lattice.Previous[end.Crossing]; };
    if (open.empty() || arcOf(ends[open.back().End]) != arc)
    {
      open.push_back({ i, 0 });
      continue;
    }
    const BorderEnd& first = ends[open.back().End];
    const int height = open.back().Height + 1;
    open.pop_back();
    if (!open.empty())
    {
      open.back().Height = std::max(open.back().Height, height);
    }
    const double depth = step * height;
    const std::size_t begin = redrawn.Points.size();
    redrawn.Points.push_back(inward(this->InPlane(face, first.Node), depth));
    for (int edge = first.Edge; edge < ends[i].Edge; ++edge)
    {
      redrawn.Points.push_back(inward(corners[edge], depth));
    }
    redrawn.Points.push_back(inward(this->InPlane(face, ends[i].Node), depth));
    if (ends[i].IsStart)
    {
      std::reverse(redrawn.Points.begin() + begin, redrawn.Points.end());
    }
    redrawn.Arc.push_back(arc);
    redrawn.Offsets.push_back(redrawn.Points.size());
  }
}

bool ArcEmbedder::Redraw(const Face& face, Group arcs, NewArcs& redrawn)
{
  const std::vector<BorderEnd> ends = this->SortEnds(arcs);
  const bool reconnect = this->Interlock(ends);
  if (reconnect)
  {
    this->Reconnect(ends);
  }
  this->DrawShells(face, ends, redrawn);
  return reconnect;
}

/// The repair that gave the new arcs from number `first` on.
Repair ArcEmbedder::Describe(
  const Face& face, bool reconnected, const NewArcs& redrawn, std::size_t first) const
{
  Point3 sum{ 0.0, 0.0, 0.0 };
  double length = 0.0;
  for (std::size_t arc = first; arc < redrawn.Arc.size(); ++arc)
  {
    for (std::size_t i = redrawn.Offsets[arc]; i < redrawn.Offsets[arc + 1]; ++i)
    {
      const Point3& p = redrawn.Points[i];
      const Point3& q = redrawn.Points[i > redrawn.Offsets[arc] ? i - 1 : i];
      length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += p[axis];
      }
    }
  }
  const double count = static_cast<double>(redrawn.Offsets.back() - redrawn.Offsets[first]);
  return { reconnected ? RepairKind::ArcsReconnected : RepairKind::ArcsRedrawn, face.Axis,
    face.Plane, { sum[0] / count, sum[1] / count, sum[2] / count }, length };
}

/// Writes the points of G anew with the new arcs in the places of the old ones.
void ArcEmbedder::Replace(const NewArcs& redrawn)
{
  const std::size_t none = redrawn.Arc.size();
  std::vector<std::size_t> newArc(this->Lattice.Count(), none);
  for (std::size_t i = 0; i < none; ++i)
  {
    newArc[redrawn.Arc[i]] = i;
  }
  const auto nodesEnd =
    this->Graph.Points.begin() + 3 * static_cast<std::size_t>(this->Graph.Nodes);
  std::vector<double> points(this->Graph.Points.begin(), nodesEnd);
  points.reserve(this->Graph.Points.size() + 3 * redrawn.Points.size());
  std::vector<Index> offsets(1, 0);
  this->Graph.Redrawn.resize(this->Lattice.Count(), 0);
  for (Index arc = 0; arc < this->Lattice.Count(); ++arc)
  {
    if (newArc[arc] == none)
    {
      const auto first =
        this->Graph.Points.begin() + 3 * static_cast<std::size_t>(this->Graph.FirstPoint(arc));
      points.insert(points.end(), first, first + 3 * this->Graph.PointCount(arc));
    }
    else
    {
      this->Graph.Redrawn[arc] = 1;
      for (std::size_t i = redrawn.Offsets[newArc[arc]]; i < redrawn.Offsets[newArc[arc] + 1]; ++i)
      {
        points.insert(points.end(), redrawn.Points[i].begin(), redrawn.Points[i].end());
      }
    }
    offsets.push_back(static_cast<Index>(points.size() / 3) - this->Graph.Nodes);
  }
  this->Graph.Points.swap(points);
  this->Graph.Offsets.swap(offsets);
}

std::vector<Repair> ArcEmbedder::Run(const Execution& execution, const std::vector<Index>& forced)
{
  std::vector<std::uint8_t> isForced(forced.empty() ? 0 : this->Lattice.Count(), 0);
  for (const Index arc : forced)
  {
    isForced[arc] = 1;
  }
  const auto anyForced = [&](Group arcs)
  {
    return !isForced.empty() &&
      std::any_of(
        arcs.first, arcs.second, [&](const ArcInFace& arc) { return isForced[arc.Arc] != 0; });
  };
  const std::vector<ArcInFace> arcs = this->SortByFace();
  std::vector<std::size_t> groups;
  for (std::size_t i = 0; i < arcs.size(); ++i)
  {
    if (i == 0 || arcs[i].Face != arcs[i - 1].Face)
    {
      groups.push_back(i);
    }
  }
  groups.push_back(arcs.size());
  const auto group = [&](std::size_t g)
  { return Group(arcs.data() + groups[g], arcs.data() + groups[g + 1]); };
  std::vector<std::uint8_t> simple(groups.size() - 1, 0);
  execution.For(simple.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t g = begin; g < end; ++g)
      {
        const Face face = this->FaceOf(arcs[groups[g]].Arc);
        for (const ArcInFace* arc = group(g).first; arc != group(g).second; ++arc)
        {
          this->MoveInside(face, arc->Arc);
        }
        simple[g] = !anyForced(group(g)) && this->IsSimple(face, group(g));
      }
    });
  std::vector<Repair> repairs;
  NewArcs redrawn;
  for (std::size_t g = 0; g < simple.size(); ++g)
  {
    if (!simple[g])
    {
      const std::size_t first = redrawn.Arc.size();
      const Face face = this->FaceOf(arcs[groups[g]].Arc);
      const bool reconnected = this->Redraw(face, group(g), redrawn);
      repairs.push_back(this->Describe(face, reconnected, redrawn, first));
    }
  }
  if (!repairs.empty())
  {
    this->Replace(redrawn);
  }
  return repairs;
}
}

std::vector<Repair> EmbedArcs(const SpatialGrid& grid, const NodePoints& nodes,
  const Execution& execution, Crossings& crossings, NodeGraph& graph,
  const std::vector<Index>& forced)
{
  return ArcEmbedder(grid, nodes, crossings, graph).Run(execution, forced);
}
}
