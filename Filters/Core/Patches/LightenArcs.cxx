// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/LightenArcs.h"

#include "Core/Base/Vectors.h"
#include "Core/Graph/EditGraph.h"
#include "Core/Graph/EmbedArcs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// The height over a side from which on the curve is no smooth piece, whose sides would be balanced
/// by moving their ends, as a share of the side's length: a third of a circle has 0.29.
constexpr double MaxHeight = 0.25;

/// The share of the room beside it that a node point may take on its edge when it moves.
constexpr double ShareOfRoom = 0.25;

/// Added to squared cosines of angles between the surface's normal and an edge of M, so that nodes
/// on edges that run along the surface do not move far.
constexpr double LeastSquaredCosine = 0.05;

/// How far the end of two sides is to move to the right, so that both leave as much on one side as
/// on the other; not where one of them replaces a corner.
double BalanceOf(const CurveDeviation& before, double lengthBefore, const CurveDeviation& after,
  double lengthAfter)
{
  const bool isSmooth = std::abs(before.Height) <= MaxHeight * lengthBefore &&
    std::abs(after.Height) <= MaxHeight * lengthAfter;
  return isSmooth ? 0.5 * (before.Height + after.Height) : 0.0;
}

/// The direction to the right of a path at the middle one of three points.
Point2 RightAt(const Point2& before, const Point2& here, const Point2& after)
{
  const Point2 a = here - before, b = after - here;
  const double first = std::max(Length(a), 1e-300), second = std::max(Length(b), 1e-300);
  const Point2 along = (1.0 / first) * a + (1.0 / second) * b;
  const double length = Length(along);
  return length > 0.0 ? Point2{ along[1] / length, -along[0] / length } : Point2{ 0.0, 0.0 };
}

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
  const LightCurve light = LightenCurve(curve, this->Tolerance(face.Axis));
  const std::vector<CurvePlace>& places = light.Places;
  const std::size_t sides = light.Sides.size();
  const auto balance = [&](std::size_t before, std::size_t after)
  {
    return BalanceOf(light.Sides[before],
      QuickDistance(places[before].Place, places[before + 1].Place), light.Sides[after],
      QuickDistance(places[after].Place, places[after + 1].Place));
  };
  const SpatialGrid& grid = this->Geometry.Grid;
  for (std::size_t i = 1; i < sides; ++i)
  {
    const Point2 p = places[i].Place +
      balance(i - 1, i) * RightAt(places[i - 1].Place, places[i].Place, places[i + 1].Place);
    drawing.Vertices.push_back(
      this->Geometry.InSpace(face, { grid.Round(p[0]), grid.Round(p[1]) }));
    const Point3 from = this->NormalAt(points[places[i].Side]);
    const Point3 to = this->NormalAt(points[places[i].Side + 1]);
    drawing.Normals.push_back(Unit(Between(from, to, places[i].Share)));
    drawing.Corners.push_back(0);
  }
  const auto bulge = [&](std::size_t side)
  {
    const Point2 right = RightAt(places[side].Place, places[side].Place, places[side + 1].Place);
    Point3 result{ 0.0, 0.0, 0.0 };
    result[FirstAxis(face.Axis)] = balance(side, side) * right[0];
    result[SecondAxis(face.Axis)] = balance(side, side) * right[1];
    return result;
  };
  if (points.front() < this->Geometry.Graph.Nodes)
  {
    drawing.Bulges[0] = bulge(0);
  }
  if (points.back() < this->Geometry.Graph.Nodes)
  {
    drawing.Bulges[1] = bulge(sides - 1);
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
  return ShareOfRoom * std::max(0.0, std::min(here - low, high - here));
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
  const double cosine = normal[edge.Direction];
  const double move = 0.25 * sum * cosine / (cosine * cosine + LeastSquaredCosine);
  const double most = std::min({ this->RoomBeside(node, edge),
    this->Tolerance(FirstAxis(edge.Direction)), this->Tolerance(SecondAxis(edge.Direction)) });
  return std::max(-most, std::min(most, move));
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
