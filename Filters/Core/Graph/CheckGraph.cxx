// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/CheckGraph.h"

#include "Core/Base/Execution.h"
#include "Core/Graph/FaceArcs.h"
#include "Core/Planar/UncrossCurves.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace orthoslices
{
std::string CheckFourArcs(
  const GridCrossings& crossings, const NodePoints& nodes, const NodeGraph& graph)
{
  const std::size_t ends = static_cast<std::size_t>(graph.Arcs) + graph.Loops.size() + 1;
  if (graph.Nodes != nodes.Count() || graph.Arcs != crossings.Count() ||
    graph.Offsets.size() != ends ||
    graph.Points.size() != 3 * static_cast<std::size_t>(graph.Count()))
  {
    return "the tables of G do not fit each other";
  }
  std::vector<int> begin(graph.Nodes, 0), end(graph.Nodes, 0);
  for (Index arc = 0; arc < crossings.Count(); ++arc)
  {
    if (crossings.IsRemoved(arc))
    {
      if (graph.PointCount(arc) != 0)
      {
        return "removed arc " + std::to_string(arc) + " has vertices";
      }
      continue;
    }
    // One bit for each family, so that a sum of 3 means one of each.
    begin[nodes.NodeOf[arc]] += 1 + crossings.Family[arc];
    end[nodes.NodeOf[crossings.Next[arc]]] += 1 + crossings.Family[crossings.Next[arc]];
  }
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    if (begin[node] != 3 || end[node] != 3)
    {
      return "node point " + std::to_string(node) + " does not have four arcs";
    }
  }
  return {};
}

namespace
{
using FaceKey = std::tuple<int, Index, Index, Index>;

FaceKey KeyOf(const Face& face) { return { face.Axis, face.Plane, face.Slab[0], face.Slab[1] }; }

std::string NameOf(const Face& face)
{
  return std::string("slice ") + "xyz"[face.Axis] + " number " + std::to_string(face.Plane);
}

/// Whether vertices of G are on the plane of their face and strictly between its borders.
bool AreInside(
  const SpatialGrid& grid, const NodeGraph& graph, const Face& face, Index first, Index count)
{
  for (Index i = 0; i < count; ++i)
  {
    const Point3 p = graph.PointAt(first + i);
    if (p[face.Axis] != grid.Planes[face.Axis][face.Plane])
    {
      return false;
    }
    for (int side = 0; side < 2; ++side)
    {
      const int axis = (face.Axis + 1 + side) % 3;
      const auto& planes = grid.Planes[axis];
      const Index slab = face.Slab[side];
      if ((slab > 0 && p[axis] <= planes[slab - 1]) ||
        (slab < grid.Count(axis) && p[axis] >= planes[slab]))
      {
        return false;
      }
    }
  }
  return true;
}
}

std::string CheckEmbedding(const SpatialGrid& grid, const GridCrossings& crossings,
  const NodePoints& nodes, const NodeGraph& graph)
{
  const ArcGeometry geometry{ grid, nodes, crossings, graph };
  const ArcsByFace faces = GroupArcsByFace(grid, crossings, Execution());
  std::map<FaceKey, std::pair<Face, PlanarCurves>> curves;
  for (Index i = 0; i < faces.Count(); ++i)
  {
    const FaceArcs face = faces[i];
    auto& at = curves[KeyOf(face.Face)];
    at.first = face.Face;
    for (const Index arc : face)
    {
      if (!AreInside(grid, graph, face.Face, graph.FirstPoint(arc), graph.PointCount(arc)))
      {
        return "an arc leaves its face on " + NameOf(face.Face);
      }
      std::vector<Point2> points;
      geometry.VisitPoints(
        arc, [&](Index point) { points.push_back(geometry.InPlane(face.Face, point)); });
      AddCurve(points, at.second);
    }
  }
  for (std::size_t loop = 0; loop < graph.Loops.size(); ++loop)
  {
    const Face& face = graph.Loops[loop];
    const Index arc = graph.Arcs + static_cast<Index>(loop);
    if (!AreInside(grid, graph, face, graph.FirstPoint(arc), graph.PointCount(arc)))
    {
      return "a loop leaves its face on " + NameOf(face);
    }
    std::vector<Point2> points;
    for (Index i = 0; i < graph.PointCount(arc); ++i)
    {
      points.push_back(geometry.InPlane(face, graph.FirstPoint(arc) + i));
    }
    auto& at = curves[KeyOf(face)];
    at.first = face;
    AddClosedCurve(points, at.second);
  }
  for (auto& face : curves)
  {
    if (!AreSimple(face.second.second))
    {
      return "arcs or loops touch on " + NameOf(face.second.first);
    }
  }
  return {};
}

std::string CheckCycles(const CycleGeometry& geometry)
{
  const CellCycles& cycles = geometry.Cycles;
  const Index arcs = geometry.Graph.Arcs + static_cast<Index>(geometry.Graph.Loops.size());
  std::vector<std::uint8_t> sides(arcs, 0);
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    for (Index i = cycles.Offsets[cycle]; i < cycles.Offsets[cycle + 1]; ++i)
    {
      const HalfArc& half = cycles.Arcs[i];
      const std::uint8_t side = half.Above ? 2 : 1;
      if ((sides[half.Arc] & side) != 0)
      {
        return "arc " + std::to_string(half.Arc) + " is twice on one side of its slice";
      }
      sides[half.Arc] |= side;
      if (geometry.Graph.IsLoop(half.Arc))
      {
        continue;
      }
      const bool last = i + 1 == cycles.Offsets[cycle + 1];
      const HalfArc& next = cycles.Arcs[last ? cycles.Offsets[cycle] : i + 1];
      const Index stop = half.Above ? geometry.Crossings.Next[half.Arc] : half.Arc;
      if (geometry.Nodes.NodeOf[stop] != StartNode(geometry.Crossings, geometry.Nodes, next))
      {
        return "cycle " + std::to_string(cycle) + " is torn";
      }
    }
  }
  for (Index arc = 0; arc < arcs; ++arc)
  {
    const bool removed = !geometry.Graph.IsLoop(arc) && geometry.Crossings.IsRemoved(arc);
    if (sides[arc] != (removed ? 0 : 3))
    {
      return "arc " + std::to_string(arc) + " does not bound two cells";
    }
  }
  return {};
}
}
