// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellRegion.h"

#include "Core/Base/Box.h"

#include <algorithm>
#include <numeric>

namespace orthoslices
{
namespace
{
int EdgeOfCell(int direction, int upperFirst, int upperSecond)
{
  return 4 * direction + 2 * upperSecond + upperFirst;
}

/// The corner at the lower end of an edge of a cell.
int LowerCorner(int edge)
{
  const int t = edge / 4;
  return ((edge & 1) << FirstAxis(t)) | (((edge >> 1) & 1) << SecondAxis(t));
}
}

/// Place on the border of a face: a corner of the cell, or one of the region's nodes.
struct CellRegions::RingVertex
{
  bool IsCorner;
  Index Place; ///< of the node in the region; or the corner
};

std::vector<CellRegion> CellRegions::Find(const Index* first, const Index* last)
{
  std::vector<CellRegion> regions;
  for (const Index* cycle = first; cycle != last; ++cycle)
  {
    regions.push_back(this->Describe(*cycle));
    this->FindCorners(regions.back());
  }
  this->SetExtent(regions);
  for (CellRegion& region : regions)
  {
    const bool left = this->FindLeft(region);
    for (CellRegion::NodePlace& node : region.Nodes)
    {
      node.Left = left;
    }
    for (CellRegion::LoopPlace& loop : region.Loops)
    {
      loop.Left = left;
    }
  }
  return regions;
}

void CellRegions::AddNode(Index cycle, const HalfArc& half, CellRegion& region) const
{
  const auto& cell = this->Geometry.Cycles.Cell[cycle];
  const Index node = StartNode(this->Geometry.Crossings, this->Geometry.Nodes, half);
  const GridEdge at =
    this->Code.Decode(this->Geometry.Crossings.Edge[this->Geometry.Nodes.First[node]]);
  const int t = at.Direction;
  const int edge =
    EdgeOfCell(t, at.First == cell[FirstAxis(t)] ? 1 : 0, at.Second == cell[SecondAxis(t)] ? 1 : 0);
  const GridEdge start = this->Code.Decode(this->Geometry.Crossings.Edge[half.Arc]);
  const int axis = this->Geometry.Crossings.Family[half.Arc] == 0 ? FirstAxis(start.Direction)
                                                                  : SecondAxis(start.Direction);
  // The cell above a slice has it as its lower face.
  region.Nodes.push_back({ node, edge, 2 * axis + (half.Above ? 0 : 1), 0, 0, 0, true });
}

CellRegion CellRegions::Describe(Index cycle) const
{
  CellRegion region;
  std::vector<Index> places;
  this->Geometry.GetBoundary(cycle, region.Border, places);
  region.Cycles.push_back(cycle);
  region.BorderOffsets.push_back(static_cast<Index>(region.Border.size()));
  if (this->Geometry.IsLoop(cycle))
  {
    const Face& face = this->Geometry.Graph.Loops[this->Geometry.LoopOf(cycle)];
    region.Loops.push_back({ 2 * face.Axis + (this->Geometry.FirstArc(cycle).Above ? 0 : 1), 0,
      region.BorderOffsets.back(), true });
    return region;
  }
  const CellCycles& cycles = this->Geometry.Cycles;
  const Index count = cycles.Size(cycle);
  for (Index i = 0; i < count; ++i)
  {
    this->AddNode(cycle, cycles.Arcs[cycles.Offsets[cycle] + i], region);
    region.Nodes.back().Place = places[i];
    region.Nodes.back().Next = (i + 1) % count;
    region.Nodes.back().Previous = (i + count - 1) % count;
  }
  return region;
}

void CellRegions::SetExtent(const std::vector<CellRegion>& regions)
{
  Box3 box;
  for (const CellRegion& region : regions)
  {
    for (const Index point : region.Border)
    {
      box.Add(this->Geometry.Graph.PointAt(point));
    }
  }
  const auto& cell = this->Geometry.Cycles.Cell[regions.front().Cycles.front()];
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Geometry.Grid.GetExtent(
      axis, cell[axis], box.Low[axis], box.High[axis], this->Low[axis], this->High[axis]);
  }
}

void CellRegions::ClipToBounds()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Geometry.Grid.ClipToBounds(axis, this->Low[axis], this->High[axis]);
  }
}

/// A corner is in the region if a path along edges from corner 0 passes an odd number of nodes.
void CellRegions::FindCorners(CellRegion& region) const
{
  std::array<bool, 12> odd{};
  for (const CellRegion::NodePlace& node : region.Nodes)
  {
    odd[node.Edge] = !odd[node.Edge];
  }
  region.Corners[0] = false;
  for (int corner = 1; corner < 8; ++corner)
  {
    // From the neighbour that is lower along the last axis in which this corner is upper.
    const int t = corner >= 4 ? 2 : corner >= 2 ? 1 : 0;
    const int edge = EdgeOfCell(t, (corner >> FirstAxis(t)) & 1, (corner >> SecondAxis(t)) & 1);
    region.Corners[corner] = region.Corners[corner ^ (1 << t)] != odd[edge];
  }
}

/**
 * Whether the region of a single cycle lies on its left: whether one comes from the region to the
 * start of the first arc, counter-clockwise around its face. That of a loop is its inside.
 */
bool CellRegions::FindLeft(const CellRegion& region) const
{
  if (region.Nodes.empty())
  {
    std::vector<Point2> polygon;
    for (std::size_t i = 0; i < region.Border.size(); ++i)
    {
      polygon.push_back(this->OnFace(region, region.Loops.front().Face, static_cast<Index>(i)));
    }
    return SignedArea(polygon) > 0.0;
  }
  const std::vector<RingVertex> ring = this->RingOf(region, region.Nodes.front().Face);
  bool label = region.Corners[ring.front().Place];
  for (const RingVertex& vertex : ring)
  {
    if (!vertex.IsCorner)
    {
      if (vertex.Place == 0)
      {
        break;
      }
      label = !label;
    }
  }
  return label;
}

/// Corners of a face and nodes on its border, counter-clockwise seen from outside.
std::vector<CellRegions::RingVertex> CellRegions::RingOf(const CellRegion& region, int face) const
{
  const int u = 1 << AxesOfFace(face)[0];
  const int v = 1 << AxesOfFace(face)[1];
  const int base = face % 2 == 1 ? 1 << (face / 2) : 0;
  const int corners[4] = { base, base | u, base | u | v, base | v };
  std::vector<RingVertex> ring;
  for (int i = 0; i < 4; ++i)
  {
    const int from = corners[i];
    const int to = corners[(i + 1) % 4];
    const int bit = from ^ to;
    const int t = bit == 4 ? 2 : bit == 2 ? 1 : 0;
    const int edge = EdgeOfCell(t, (from >> FirstAxis(t)) & 1, (from >> SecondAxis(t)) & 1);
    std::vector<Index> places;
    for (std::size_t n = 0; n < region.Nodes.size(); ++n)
    {
      if (region.Nodes[n].Edge == edge)
      {
        places.push_back(static_cast<Index>(n));
      }
    }
    // Nodes are numbered upwards along an edge.
    const bool upwards = to > from;
    std::sort(places.begin(), places.end(),
      [&](Index a, Index b)
      { return (region.Nodes[a].Node < region.Nodes[b].Node) == upwards && a != b; });
    ring.push_back({ true, from });
    for (const Index place : places)
    {
      ring.push_back({ false, place });
    }
  }
  return ring;
}

/// Follows the border of each part of the region: along the face's border, across on arcs.
std::vector<std::vector<Index>> CellRegions::RingsOn(const CellRegion& region, int face) const
{
  const std::vector<RingVertex> ring = this->RingOf(region, face);
  const std::size_t count = ring.size();
  const Index size = static_cast<Index>(region.Border.size());
  std::vector<std::size_t> ringPlace(region.Nodes.size(), 0);
  std::vector<std::uint8_t> inside(count, 0); // the piece of the border after each ring vertex
  bool label = region.Corners[ring.front().Place];
  for (std::size_t r = 0; r < count; ++r)
  {
    label = ring[r].IsCorner ? label : !label;
    inside[r] = label;
    if (!ring[r].IsCorner)
    {
      ringPlace[ring[r].Place] = r;
    }
  }
  std::vector<std::vector<Index>> rings;
  for (std::size_t start = 0; start < count; ++start)
  {
    std::vector<Index> vertices;
    std::size_t r = start;
    while (inside[r] == 1)
    {
      inside[r] = 2;
      vertices.push_back(ring[r].IsCorner ? -1 - ring[r].Place : region.Nodes[ring[r].Place].Place);
      r = (r + 1) % count;
      if (ring[r].IsCorner)
      {
        continue;
      }
      // The arc on this face that starts or ends at the node.
      const CellRegion::NodePlace& node = region.Nodes[ring[r].Place];
      const Index other = node.Left ? node.Next : node.Previous;
      const Index last = region.Nodes[other].Place;
      const auto cycle =
        std::upper_bound(region.BorderOffsets.begin(), region.BorderOffsets.end(), node.Place);
      const Index end = cycle == region.BorderOffsets.end() ? size : *cycle;
      const Index begin = *(cycle - 1);
      for (Index p = node.Place; p != last;)
      {
        vertices.push_back(p);
        p = node.Left ? (p + 1 < end ? p + 1 : begin) : (p > begin ? p - 1 : end - 1);
      }
      r = ringPlace[other];
    }
    if (!vertices.empty())
    {
      rings.push_back(std::move(vertices));
    }
  }
  for (const CellRegion::LoopPlace& loop : region.Loops)
  {
    if (loop.Face == face)
    {
      rings.emplace_back(loop.Last - loop.First);
      std::iota(rings.back().begin(), rings.back().end(), loop.First);
      if (!loop.Left)
      {
        std::reverse(rings.back().begin(), rings.back().end());
      }
    }
  }
  return rings;
}

/**
 * Where a cycle begins: how often one passes from the region to the rest on the way there, from the
 * corner at the lower end of the node's edge, or on the face of the loop.
 */
bool CellRegions::Contains(const CellRegion& outer, const CellRegion& cycle) const
{
  if (cycle.Nodes.empty())
  {
    const int face = cycle.Loops.front().Face;
    const Point2 point = this->OnFace(cycle, face, 0);
    bool within = false;
    for (const std::vector<Index>& ring : this->RingsOn(outer, face))
    {
      std::vector<Point2> polygon;
      for (const Index vertex : ring)
      {
        polygon.push_back(this->OnFace(outer, face, vertex));
      }
      within ^= IsInside(polygon, point);
    }
    return within;
  }
  const CellRegion::NodePlace& start = cycle.Nodes.front();
  bool within = outer.Corners[LowerCorner(start.Edge)];
  for (const CellRegion::NodePlace& node : outer.Nodes)
  {
    within ^= node.Edge == start.Edge && node.Node < start.Node;
  }
  return within;
}

/// A vertex of RingsOn in the axes of a face.
Point2 CellRegions::OnFace(const CellRegion& region, int face, Index vertex) const
{
  const Point3 p =
    vertex >= 0 ? this->Geometry.Graph.PointAt(region.Border[vertex]) : this->Corner(-1 - vertex);
  const std::array<int, 2> axes = AxesOfFace(face);
  return { p[axes[0]], p[axes[1]] };
}

Point3 CellRegions::Corner(int corner) const
{
  Point3 point;
  for (int axis = 0; axis < 3; ++axis)
  {
    point[axis] = (corner >> axis) & 1 ? this->High[axis] : this->Low[axis];
  }
  return point;
}

void CellRegions::Flip(CellRegion& region)
{
  for (CellRegion::NodePlace& node : region.Nodes)
  {
    node.Left = !node.Left;
  }
  for (CellRegion::LoopPlace& loop : region.Loops)
  {
    loop.Left = !loop.Left;
  }
  for (bool& corner : region.Corners)
  {
    corner = !corner;
  }
}

CellRegion CellRegions::Subtract(
  const std::vector<const CellRegion*>& regions, std::size_t outermost)
{
  CellRegion result;
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    const CellRegion& region = *regions[i];
    const Index firstPlace = static_cast<Index>(result.Border.size());
    const Index firstNode = static_cast<Index>(result.Nodes.size());
    result.Cycles.insert(result.Cycles.end(), region.Cycles.begin(), region.Cycles.end());
    result.Border.insert(result.Border.end(), region.Border.begin(), region.Border.end());
    result.BorderOffsets.push_back(static_cast<Index>(result.Border.size()));
    for (CellRegion::NodePlace node : region.Nodes)
    {
      node.Place += firstPlace;
      node.Next += firstNode;
      node.Previous += firstNode;
      node.Left ^= i != outermost;
      result.Nodes.push_back(node);
    }
    for (CellRegion::LoopPlace loop : region.Loops)
    {
      loop.First += firstPlace;
      loop.Last += firstPlace;
      loop.Left ^= i != outermost;
      result.Loops.push_back(loop);
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      result.Corners[corner] = result.Corners[corner] != region.Corners[corner];
    }
  }
  return result;
}
}
