// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/InsertVertices.h"

#include "Core/Base/Vectors.h"
#include "Core/Planar/UncrossCurves.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace orthoslices
{
namespace
{
/// A new vertex of a loop of G.
struct NewVertex
{
  Index After;
  double Share;
  std::size_t Group;
  Index Insertion; ///< of that group's overlay
};

class VertexInserter
{
public:
  VertexInserter(const CycleGeometry& geometry, int axis, const Execution& execution,
    std::vector<SlabGroup>& groups)
    : Geometry(geometry)
    , Axis(axis)
    , Execute(execution)
    , Groups(groups)
  {
  }

  StitchedLoops Run();

private:
  void Insert();
  bool LeaveOutSpoilt();
  bool LeaveOutCollapsed();
  bool KeepsEdges(std::size_t group) const;
  bool AreLoopsSimple(const std::vector<Index>& loops) const;
  void Append(Index loop, const std::vector<NewVertex>& vertices);

  const CycleGeometry& Geometry;
  int Axis;
  const Execution& Execute;
  std::vector<SlabGroup>& Groups;
  StitchedLoops Result;
};

/// A loop with its new vertices; notes where all of them are.
void VertexInserter::Append(Index loop, const std::vector<NewVertex>& vertices)
{
  const NodeGraph& graph = this->Geometry.Graph;
  const Index arc = graph.Arcs + loop;
  const Index count = graph.PointCount(arc);
  std::vector<Point3>& points = this->Result.Loops[loop].Points;
  std::vector<Index>& vertexAt = this->Result.VertexAt[loop];
  const auto add = [&](const Point3& point)
  {
    points.push_back(point);
    return static_cast<Index>(points.size()) - 1;
  };
  auto next = vertices.begin();
  for (Index i = 0; i < count; ++i)
  {
    const Point3 from = graph.PointAt(graph.FirstPoint(arc) + i);
    const Point3 to = graph.PointAt(graph.FirstPoint(arc) + (i + 1) % count);
    vertexAt.push_back(add(from));
    Point3 last = from;
    for (; next != vertices.end() && next->After == i; ++next)
    {
      Point3 point = from + next->Share * (to - from);
      for (double& x : point)
      {
        x = this->Geometry.Grid.Round(x);
      }
      point[this->Axis] = from[this->Axis];
      // Two slabs may ask for the same vertex, and rounding may move it to an old one.
      Index& place = this->Result.InsertionAt[next->Group][next->Insertion];
      place = point == last ? static_cast<Index>(points.size()) - 1
        : point == to       ? -1 - i
                            : add(point);
      if (place < 0)
      {
        continue;
      }
      last = point;
    }
  }
}

/// Gives up the overlays beside slices on which loops touch: a new vertex, once rounded, lies
/// beside its segment and may lie on another one. Returns whether there are any.
bool VertexInserter::LeaveOutSpoilt()
{
  const std::size_t planes = this->Geometry.Grid.Planes[this->Axis].size();
  std::vector<std::uint8_t> isNew(planes, 0), isSpoilt(planes, 0);
  for (const SlabGroup& group : this->Groups)
  {
    for (const SlabOverlay::Insertion& insertion : group.Overlay.Insertions)
    {
      isNew[this->Geometry.Graph.Loops[group.Loops[insertion.Loop]].Plane] |=
        group.Overlay.Valid ? 1 : 0;
    }
  }
  std::vector<std::vector<Index>> loopsOn(planes);
  for (Index loop = 0; loop < static_cast<Index>(this->Geometry.Graph.Loops.size()); ++loop)
  {
    loopsOn[this->Geometry.Graph.Loops[loop].Plane].push_back(loop);
  }
  this->Execute.For(planes,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t plane = begin; plane < end; ++plane)
      {
        isSpoilt[plane] = isNew[plane] != 0 && !this->AreLoopsSimple(loopsOn[plane]);
      }
    });
  for (SlabGroup& group : this->Groups)
  {
    const auto below = static_cast<std::size_t>(group.Slab);
    if ((below > 0 && isSpoilt[below - 1] != 0) || (below < planes && isSpoilt[below] != 0))
    {
      group.Overlay.Valid = false;
    }
  }
  return std::find(isSpoilt.begin(), isSpoilt.end(), 1) != isSpoilt.end();
}

/// Whether loops of one slice touch neither each other nor themselves.
bool VertexInserter::AreLoopsSimple(const std::vector<Index>& loops) const
{
  PlanarCurves curves;
  for (const Index loop : loops)
  {
    std::vector<Point2> outline;
    for (const Point3& p : this->Result.Loops[loop].Points)
    {
      outline.push_back({ p[FirstAxis(this->Axis)], p[SecondAxis(this->Axis)] });
    }
    AddClosedCurve(outline, curves);
  }
  return AreSimple(curves);
}

/// Whether no two sides of triangles of an overlay have become one, as where a new vertex lies on
/// an old one, once rounded, and both have an edge to the same third one.
bool VertexInserter::KeepsEdges(std::size_t group) const
{
  const SlabGroup& members = this->Groups[group];
  std::vector<Index> first, corners; // of each loop; of each corner, a number for its place
  Index count = 0;
  for (const Index loop : members.Loops)
  {
    first.push_back(count);
    for (const Index place : this->Result.VertexAt[loop])
    {
      corners.push_back(count + place);
    }
    count += this->Result.Count(loop);
  }
  const std::vector<SlabOverlay::Insertion>& insertions = members.Overlay.Insertions;
  for (std::size_t i = 0; i < insertions.size(); ++i)
  {
    corners.push_back(first[insertions[i].Loop] + this->Result.InsertionAt[group][i]);
  }
  std::vector<Index> places = corners;
  std::sort(places.begin(), places.end());
  if (std::adjacent_find(places.begin(), places.end()) == places.end())
  {
    return true;
  }
  const Index contours = static_cast<Index>(corners.size());
  const auto numberOf = [&](Index corner)
  { return corner < contours ? corners[corner] : count + corner - contours; };
  std::vector<std::pair<Index, Index>> sides;
  for (const auto& triangle : members.Overlay.Triangles)
  {
    const Index a = numberOf(triangle[0]), b = numberOf(triangle[1]), c = numberOf(triangle[2]);
    if (a != b && b != c && c != a)
    {
      sides.insert(sides.end(), { { a, b }, { b, c }, { c, a } });
    }
  }
  std::sort(sides.begin(), sides.end());
  return std::adjacent_find(sides.begin(), sides.end()) == sides.end();
}

/// Gives up the overlays whose triangles would meet in edges that they do not share. Returns
/// whether there are any.
bool VertexInserter::LeaveOutCollapsed()
{
  std::vector<std::uint8_t> isCollapsed(this->Groups.size(), 0);
  this->Execute.For(isCollapsed.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t group = begin; group < end; ++group)
      {
        isCollapsed[group] = this->Groups[group].Overlay.Valid && !this->KeepsEdges(group) ? 1 : 0;
      }
    });
  for (std::size_t group = 0; group < isCollapsed.size(); ++group)
  {
    this->Groups[group].Overlay.Valid &= isCollapsed[group] == 0;
  }
  return std::find(isCollapsed.begin(), isCollapsed.end(), 1) != isCollapsed.end();
}

/// Inserts the vertices of all overlays that are valid.
void VertexInserter::Insert()
{
  const NodeGraph& graph = this->Geometry.Graph;
  const std::size_t loops = graph.Loops.size();
  this->Result = StitchedLoops();
  this->Result.VertexAt.resize(loops);
  std::vector<std::vector<NewVertex>> ofLoop(loops);
  for (std::size_t g = 0; g < this->Groups.size(); ++g)
  {
    const SlabGroup& group = this->Groups[g];
    std::vector<Index> insertionAt(group.Overlay.Valid ? group.Overlay.Insertions.size() : 0, 0);
    for (std::size_t i = 0; i < insertionAt.size(); ++i)
    {
      const SlabOverlay::Insertion& insertion = group.Overlay.Insertions[i];
      ofLoop[group.Loops[insertion.Loop]].push_back(
        { insertion.After, insertion.Share, g, static_cast<Index>(i) });
    }
    this->Result.InsertionAt.push_back(std::move(insertionAt));
  }
  for (std::size_t loop = 0; loop < loops; ++loop)
  {
    std::stable_sort(ofLoop[loop].begin(), ofLoop[loop].end(),
      [](const NewVertex& a, const NewVertex& b)
      { return std::tie(a.After, a.Share) < std::tie(b.After, b.Share); });
    this->Result.Loops.push_back({ graph.Loops[loop], {} });
    this->Append(static_cast<Index>(loop), ofLoop[loop]);
    for (const NewVertex& vertex : ofLoop[loop])
    {
      // At the end of its segment: the vertex after.
      Index& place = this->Result.InsertionAt[vertex.Group][vertex.Insertion];
      const std::vector<Index>& old = this->Result.VertexAt[loop];
      place = place < 0 ? old[(-place) % old.size()] : place;
    }
  }
}

StitchedLoops VertexInserter::Run()
{
  do
  {
    this->Insert();
  } while (this->LeaveOutSpoilt() || this->LeaveOutCollapsed());
  return std::move(this->Result);
}
}

StitchedLoops InsertVertices(const CycleGeometry& geometry, int axis, const Execution& execution,
  std::vector<SlabGroup>& groups)
{
  return VertexInserter(geometry, axis, execution, groups).Run();
}
}
