// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/EditGraph.h"

#include "Core/Graph/FaceArcs.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Points of G and the offsets of its arcs, written anew from the first arc on.
class PointWriter
{
public:
  explicit PointWriter(const NodeGraph& graph)
    : Graph(graph)
  {
  }

  void AddNode(Index node) { this->Copy(node, 1); }
  /// After the last node.
  void BeginArcs() { this->Nodes = static_cast<Index>(this->Points.size() / 3); }
  /// The vertices that an arc has had so far.
  void AddOldVertices(Index arc)
  {
    this->Copy(this->Graph.FirstPoint(arc), this->Graph.PointCount(arc));
  }
  void AddVertex(const Point3& point)
  {
    this->Points.insert(this->Points.end(), point.begin(), point.end());
  }
  void EndArc()
  {
    this->Offsets.push_back(static_cast<Index>(this->Points.size() / 3) - this->Nodes);
  }
  void Reserve(std::size_t points) { this->Points.reserve(3 * points); }

  void MoveTo(NodeGraph& graph)
  {
    graph.Points.swap(this->Points);
    graph.Offsets.swap(this->Offsets);
    graph.Nodes = this->Nodes;
  }

private:
  void Copy(Index first, Index count)
  {
    const auto begin = this->Graph.Points.begin() + 3 * static_cast<std::ptrdiff_t>(first);
    this->Points.insert(this->Points.end(), begin, begin + 3 * static_cast<std::ptrdiff_t>(count));
  }

  const NodeGraph& Graph;
  Index Nodes = 0;
  std::vector<double> Points;
  std::vector<Index> Offsets{ 0 };
};

void DropLoops(NodeGraph& graph)
{
  graph.Loops.clear();
  graph.Offsets.resize(static_cast<std::size_t>(graph.Arcs) + 1);
  graph.Points.resize(3 * static_cast<std::size_t>(graph.Count()));
}

void MoveInside(const SpatialGrid& grid, const Face& face, Index arc, NodeGraph& graph)
{
  double* point = graph.Points.data() + 3 * static_cast<std::size_t>(graph.FirstPoint(arc));
  double* const end = point + 3 * static_cast<std::size_t>(graph.PointCount(arc));
  for (; point != end; point += 3)
  {
    for (int side = 0; side < 2; ++side)
    {
      const int axis = (face.Axis + 1 + side) % 3;
      if (!grid.IsInside(axis, face.Slab[side], point[axis]))
      {
        point[axis] = grid.MoveInside(axis, face.Slab[side], point[axis]);
      }
    }
  }
}
}

void MoveInsideFaces(
  const SpatialGrid& grid, const ArcsByFace& faces, const Execution& execution, NodeGraph& graph)
{
  execution.For(faces.Count(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const FaceArcs face = faces[static_cast<Index>(i)];
        for (const Index arc : face)
        {
          MoveInside(grid, face.Face, arc, graph);
        }
      }
    });
}

void ReplaceArcs(
  const std::vector<FaceDrawing>& drawings, GridCrossings& crossings, NodeGraph& graph)
{
  if (drawings.empty())
  {
    return;
  }
  DropLoops(graph);
  using Place = std::pair<const FaceDrawing*, std::size_t>;
  std::vector<Place> places(graph.Arcs, Place(nullptr, 0));
  std::size_t more = 0;
  for (const FaceDrawing& drawing : drawings)
  {
    for (const ArcJoin& join : drawing.Joins)
    {
      crossings.Next[join.Arc] = join.Stop;
      crossings.Previous[join.Stop] = join.Arc;
    }
    for (std::size_t i = 0; i < drawing.Arcs.size(); ++i)
    {
      places[drawing.Arcs[i]] = { &drawing, i };
    }
    more += drawing.Points.size();
  }
  PointWriter writer(graph);
  writer.Reserve(graph.Points.size() / 3 + more);
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    writer.AddNode(node);
  }
  writer.BeginArcs();
  graph.Redrawn.resize(graph.Arcs, 0);
  for (Index arc = 0; arc < graph.Arcs; ++arc)
  {
    if (!places[arc].first)
    {
      writer.AddOldVertices(arc);
    }
    else
    {
      const FaceDrawing& drawing = *places[arc].first;
      const std::size_t i = places[arc].second;
      graph.Redrawn[arc] = 1;
      for (std::size_t k = drawing.Offsets[i]; k < drawing.Offsets[i + 1]; ++k)
      {
        writer.AddVertex(drawing.Points[k]);
      }
    }
    writer.EndArc();
  }
  writer.MoveTo(graph);
}

void LeaveOutVertices(const std::vector<std::uint8_t>& isKept, NodeGraph& graph)
{
  std::size_t to = 3 * static_cast<std::size_t>(graph.Nodes);
  Index point = 0, left = 0;
  for (std::size_t arc = 0; arc + 1 < graph.Offsets.size(); ++arc)
  {
    for (; point < graph.Offsets[arc + 1]; ++point)
    {
      if (isKept[point] != 0)
      {
        const Point3 place = graph.PointAt(graph.Nodes + point);
        std::copy(place.begin(), place.end(), graph.Points.begin() + to);
        to += 3;
        ++left;
      }
    }
    graph.Offsets[arc + 1] = left;
  }
  graph.Points.resize(to);
}

void DrawArcs(const std::vector<std::vector<Point3>>& vertices, NodeGraph& graph)
{
  PointWriter writer(graph);
  writer.Reserve(graph.Points.size() / 3);
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    writer.AddNode(node);
  }
  writer.BeginArcs();
  const Index arcs = graph.Arcs + static_cast<Index>(graph.Loops.size());
  for (Index arc = 0; arc < arcs; ++arc)
  {
    if (graph.IsLoop(arc))
    {
      writer.AddOldVertices(arc);
    }
    else
    {
      std::for_each(vertices[arc].begin(), vertices[arc].end(),
        [&](const Point3& vertex) { writer.AddVertex(vertex); });
    }
    writer.EndArc();
  }
  writer.MoveTo(graph);
}

void MoveNodes(const std::vector<double>& moves, const SpatialGrid& grid,
  const GridCrossings& crossings, NodePoints& nodes, NodeGraph& graph)
{
  const GridEdgeCode code(grid);
  for (Index node = 0; node < nodes.Count(); ++node)
  {
    nodes.Position[node] = grid.Round(nodes.Position[node] + moves[node]);
    const Point3 place = NodePosition(grid, code, crossings, nodes, node);
    std::copy(
      place.begin(), place.end(), graph.Points.begin() + 3 * static_cast<std::ptrdiff_t>(node));
  }
}

void SetLoops(const std::vector<GraphLoop>& loops, NodeGraph& graph)
{
  DropLoops(graph);
  for (const GraphLoop& loop : loops)
  {
    graph.Loops.push_back(loop.Face);
    for (const Point3& point : loop.Points)
    {
      graph.Points.insert(graph.Points.end(), point.begin(), point.end());
    }
    graph.Offsets.push_back(static_cast<Index>(graph.Points.size() / 3) - graph.Nodes);
  }
}

namespace
{
/// The crossings of the nodes that go, and the nodes that stay with new numbers.
void RenumberNodes(const std::vector<std::uint8_t>& isRemoved, GridCrossings& crossings,
  NodePoints& nodes, std::vector<double>& nodeNormals)
{
  Index kept = 0;
  for (Index node = 0; node < static_cast<Index>(isRemoved.size()); ++node)
  {
    const bool gone = isRemoved[node] != 0;
    for (const Index crossing : { nodes.First[node], nodes.Second[node] })
    {
      nodes.NodeOf[crossing] = gone ? GridCrossings::None : kept;
      crossings.Next[crossing] = gone ? GridCrossings::Removed : crossings.Next[crossing];
    }
    if (!gone)
    {
      nodes.First[kept] = nodes.First[node];
      nodes.Second[kept] = nodes.Second[node];
      nodes.Position[kept] = nodes.Position[node];
      nodes.Difference[kept] = nodes.Difference[node];
      std::copy_n(nodeNormals.begin() + 3 * static_cast<std::ptrdiff_t>(node), 3,
        nodeNormals.begin() + 3 * static_cast<std::ptrdiff_t>(kept));
      ++kept;
    }
  }
  nodes.First.resize(kept);
  nodes.Second.resize(kept);
  nodes.Position.resize(kept);
  nodes.Difference.resize(kept);
  nodeNormals.resize(3 * static_cast<std::size_t>(kept));
}
}

void RemoveNodes(const std::vector<std::uint8_t>& isRemoved, GridCrossings& crossings,
  NodePoints& nodes, std::vector<double>& nodeNormals, NodeGraph& graph)
{
  DropLoops(graph);
  PointWriter writer(graph);
  for (Index node = 0; node < graph.Nodes; ++node)
  {
    if (isRemoved[node] == 0)
    {
      writer.AddNode(node);
    }
  }
  writer.BeginArcs();
  for (Index arc = 0; arc < graph.Arcs; ++arc)
  {
    if (!crossings.IsRemoved(arc) && isRemoved[nodes.NodeOf[arc]] == 0)
    {
      writer.AddOldVertices(arc);
    }
    writer.EndArc();
  }
  writer.MoveTo(graph);
  RenumberNodes(isRemoved, crossings, nodes, nodeNormals);
  graph.Component.clear();
}
}
