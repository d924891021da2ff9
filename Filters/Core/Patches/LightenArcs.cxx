// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/LightenArcs.h"

#include "Core/Base/Vectors.h"
#include "Core/Graph/EditGraph.h"
#include "Core/Graph/EmbedArcs.h"
#include "Core/Patches/BalancedCurve.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// The vertices of an arc between its nodes, and how far the contour bulges over the sides at its
/// ends.
struct ArcDrawing
{
  std::vector<Point3> Vertices;
  std::vector<Point3> Normals;
  std::vector<std::uint8_t> Corners;
  std::array<Point3, 2> Bulges{};
};

class ArcLightener
{
public:
  ArcLightener(const ArcGeometry& geometry, const SurfaceNormals& normals, double accuracy)
    : Geometry(geometry)
    , Normals(normals)
    , Accuracy(accuracy)
  {
  }

  ArcDrawing Keep(Index arc) const;
  ArcDrawing Draw(const Face& face, Index arc) const;
  double MoveAlong(Index node, const std::vector<ArcDrawing>& arcs) const;

private:
  double Tolerance(int axis) const
  {
    return this->Accuracy * MeanSpacingInSlices(this->Geometry.Grid, axis);
  }
  Point3 NormalAt(Index point) const
  {
    const float* n = this->Normals.Normals.data() + 3 * static_cast<std::size_t>(point);
    return { n[0], n[1], n[2] };
  }
  bool IsCorner(Index point) const
  {
    return !this->Normals.Corners.empty() && this->Normals.Corners[point] != 0;
  }
  void DrawPart(const Face& face, const std::vector<Index>& points, ArcDrawing& drawing) const;
  double RoomBeside(Index node, const GridEdge& edge) const;

  const ArcGeometry& Geometry;
  const SurfaceNormals& Normals;
  double Accuracy;
  GridEdgeCode Code{ this->Geometry.Grid };
};

ArcDrawing ArcLightener::Keep(Index arc) const
{
  ArcDrawing result;
  const Index first = this->Geometry.Graph.FirstPoint(arc);
  for (Index point = first; point < first + this->Geometry.Graph.PointCount(arc); ++point)
  {
    result.Vertices.push_back(this->Geometry.Graph.PointAt(point));
    result.Normals.push_back(this->NormalAt(point));
    result.Corners.push_back(this->IsCorner(point) ? 1 : 0);
  }
  return result;
}

/// Draws an arc part by part between its corners.
ArcDrawing ArcLightener::Draw(const Face& face, Index arc) const
{
  ArcDrawing result;
  std::vector<Index> part;
  this->Geometry.VisitPoints(arc,
    [&](Index point)
    {
      part.push_back(point);
      if (part.size() > 1 && point >= this->Geometry.Graph.Nodes && this->IsCorner(point))
      {
        this->DrawPart(face, part, result);
        result.Vertices.push_back(this->Geometry.Graph.PointAt(point));
        result.Normals.push_back(this->NormalAt(point));
        result.Corners.push_back(1);
        part.assign(1, point);
      }
    });
  this->DrawPart(face, part, result);
  return result;
}

/// Adds the vertices between the ends of a part of an arc, which is smooth.
void ArcLightener::DrawPart(
  const Face& face, const std::vector<Index>& points, ArcDrawing& drawing) const
{
  std::vector<Point2> curve;
  for (const Index point : points)
  {
    curve.push_back(this->Geometry.InPlane(face, point));
  }
  const BalancedCurve balanced = BalanceCurve(curve, this->Tolerance(face.Axis));
  const SpatialGrid& grid = this->Geometry.Grid;
  for (std::size_t i = 0; i < balanced.Vertices.size(); ++i)
  {
    const Point2& p = balanced.Vertices[i];
    const CurvePlace& place = balanced.Places[i];
    drawing.Vertices.push_back(
      this->Geometry.InSpace(face, { grid.Round(p[0]), grid.Round(p[1]) }));
    const Point3 from = this->NormalAt(points[place.Side]);
    const Point3 to = this->NormalAt(points[place.Side + 1]);
    drawing.Normals.push_back(Unit(Between(from, to, place.Share)));
    drawing.Corners.push_back(0);
  }
  const std::array<Index, 2> ends{ points.front(), points.back() };
  for (const int end : { 0, 1 })
  {
    if (ends[end] < this->Geometry.Graph.Nodes)
    {
      drawing.Bulges[end][FirstAxis(face.Axis)] = balanced.Bulges[end][0];
      drawing.Bulges[end][SecondAxis(face.Axis)] = balanced.Bulges[end][1];
    }
  }
}

/// The part of an edge beside a node point, on its nearer side, that it may move in.
double ArcLightener::RoomBeside(Index node, const GridEdge& edge) const
{
  const NodePoints& nodes = this->Geometry.Nodes;
  const std::vector<std::uint64_t>& edges = this->Geometry.Crossings.Edge;
  const SpatialGrid& grid = this->Geometry.Grid;
  const int axis = edge.Direction;
  const double here = nodes.Position[node];
  const auto isOnEdge = [&](Index other)
  {
    return other >= 0 && other < nodes.Count() &&
      edges[nodes.First[other]] == edges[nodes.First[node]];
  };
  const double low = isOnEdge(node - 1) ? nodes.Position[node - 1]
    : edge.Slab > 0                     ? grid.Planes[axis][edge.Slab - 1]
                                        : grid.Lowest[axis];
  const double high = isOnEdge(node + 1) ? nodes.Position[node + 1]
    : edge.Slab < grid.Count(axis)       ? grid.Planes[axis][edge.Slab]
                                         : grid.Highest[axis];
  return std::max(0.0, std::min(here - low, high - here));
}

/// How far a node point is to move along its edge, so that the surface around it lies as much
/// outside of the sides of its arcs as inside.
double ArcLightener::MoveAlong(Index node, const std::vector<ArcDrawing>& arcs) const
{
  if (this->IsCorner(node))
  {
    return 0.0;
  }
  const GridCrossings& crossings = this->Geometry.Crossings;
  const NodePoints& nodes = this->Geometry.Nodes;
  const Point3 normal = this->NormalAt(node);
  double sum = 0.0;
  for (const Index crossing : { nodes.First[node], nodes.Second[node] })
  {
    sum += Dot(normal, arcs[crossing].Bulges[0]);
    sum += Dot(normal, arcs[crossings.Previous[crossing]].Bulges[1]);
  }
  const GridEdge edge = this->Code.Decode(crossings.Edge[nodes.First[node]]);
  return NodeMove{ sum, normal[edge.Direction], this->RoomBeside(node, edge),
    std::min(
      this->Tolerance(FirstAxis(edge.Direction)), this->Tolerance(SecondAxis(edge.Direction))) }
    .Find();
}

/// Arcs that have to stay as they are, and their node points.
struct FixedArcs
{
  std::vector<std::uint8_t> Arcs, Nodes;

  FixedArcs(const ArcSurface& surface)
    : Arcs(surface.Geometry.Graph.Arcs, 0)
    , Nodes(surface.Geometry.Graph.Nodes, 0)
  {
    for (const PatchMesh& mesh : surface.Meshes)
    {
      this->Add(surface.Geometry, mesh.Cycles.data(), mesh.Cycles.data() + mesh.Cycles.size());
    }
    for (const auto& [first, last] : surface.Cells.Several)
    {
      const Index* cycles = surface.Cells.Cycles.data();
      this->Add(surface.Geometry, cycles + first, cycles + last);
    }
  }
  void Add(const CycleGeometry& geometry, const Index* first, const Index* last)
  {
    for (const Index* cycle = first; cycle != last; ++cycle)
    {
      const CellCycles& cycles = geometry.Cycles;
      for (Index i = cycles.Offsets[*cycle]; i < cycles.Offsets[*cycle + 1]; ++i)
      {
        if (!geometry.Graph.IsLoop(cycles.Arcs[i].Arc))
        {
          this->Add(geometry, cycles.Arcs[i].Arc);
        }
      }
    }
  }
  void Add(const CycleGeometry& geometry, Index arc)
  {
    this->Arcs[arc] = 1;
    this->Nodes[geometry.Nodes.NodeOf[arc]] = 1;
    this->Nodes[geometry.Nodes.NodeOf[geometry.Crossings.Next[arc]]] = 1;
  }
};

/// G as drawn: its points and their normals.
void Assemble(const std::vector<ArcDrawing>& arcs, const std::vector<double>& moves,
  const ArcSurface& surface, LightGraph& light)
{
  const CycleGeometry& geometry = surface.Geometry;
  light.Graph = geometry.Graph;
  NodePoints nodes = geometry.Nodes;
  MoveNodes(moves, geometry.Grid, geometry.Crossings, nodes, light.Graph);
  light.Positions.swap(nodes.Position);
  std::vector<std::vector<Point3>> vertices;
  for (const ArcDrawing& arc : arcs)
  {
    vertices.push_back(arc.Vertices);
  }
  DrawArcs(vertices, light.Graph);
  const SurfaceNormals& before = surface.Normals;
  SurfaceNormals& after = light.Normals;
  const std::size_t ofNodes = geometry.Graph.Nodes;
  const std::size_t ofArcs = ofNodes + geometry.Graph.Offsets[geometry.Graph.Arcs];
  after.Normals.assign(before.Normals.begin(), before.Normals.begin() + 3 * ofNodes);
  for (const ArcDrawing& arc : arcs)
  {
    for (const Point3& normal : arc.Normals)
    {
      after.Normals.insert(after.Normals.end(), normal.begin(), normal.end());
    }
  }
  after.Normals.insert(
    after.Normals.end(), before.Normals.begin() + 3 * ofArcs, before.Normals.end());
  after.Corners.clear();
  if (!before.Corners.empty())
  {
    after.Corners.assign(before.Corners.begin(), before.Corners.begin() + ofNodes);
    for (const ArcDrawing& arc : arcs)
    {
      after.Corners.insert(after.Corners.end(), arc.Corners.begin(), arc.Corners.end());
    }
    after.Corners.insert(
      after.Corners.end(), before.Corners.begin() + ofArcs, before.Corners.end());
  }
}

/// Draws the arcs that are not fixed, and moves their node points.
void DrawLight(const ArcSurface& surface, const ArcLightener& lightener, const ArcsByFace& faces,
  const FixedArcs& fixed, const Execution& execution, LightGraph& light)
{
  std::vector<ArcDrawing> arcs(surface.Geometry.Graph.Arcs);
  std::vector<double> moves(surface.Geometry.Nodes.Count(), 0.0);
  execution.For(faces.Count(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const FaceArcs face = faces[static_cast<Index>(i)];
        for (const Index arc : face)
        {
          arcs[arc] = fixed.Arcs[arc] != 0 ? lightener.Keep(arc) : lightener.Draw(face.Face, arc);
        }
      }
    });
  execution.For(moves.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        moves[i] = fixed.Nodes[i] != 0 ? 0.0 : lightener.MoveAlong(static_cast<Index>(i), arcs);
      }
    });
  Assemble(arcs, moves, surface, light);
  MoveInsideFaces(surface.Geometry.Grid, faces, execution, light.Graph);
}
}

LightGraph LightenArcs(const ArcSurface& surface, double accuracy, const Execution& execution)
{
  const CycleGeometry& geometry = surface.Geometry;
  const ArcsByFace faces = GroupArcsByFace(geometry.Grid, geometry.Crossings, execution);
  const ArcGeometry before{ geometry.Grid, geometry.Nodes, geometry.Crossings, geometry.Graph };
  const ArcLightener lightener(before, surface.Normals, accuracy);
  FixedArcs fixed(surface);
  LightGraph light;
  bool again = geometry.Nodes.Count() > 0;
  while (again)
  {
    DrawLight(surface, lightener, faces, fixed, execution, light);
    again = false;
    // Those with crossings are drawn as they were, which have none.
    for (const Index face : FindCrossingFaces(
           { geometry.Grid, geometry.Nodes, geometry.Crossings, light.Graph }, faces, execution))
    {
      for (const Index arc : faces[face])
      {
        again |= fixed.Arcs[arc] == 0;
        fixed.Add(geometry, arc);
      }
    }
  }
  return light;
}
}
