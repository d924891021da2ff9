// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/LightenStructures.h"

#include "Core/Base/Vectors.h"
#include "Core/Graph/EditGraph.h"
#include "Core/Graph/EmbedArcs.h"
#include "Core/Labels/CommonNodes.h"
#include "Core/Labels/PieceDrawing.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace orthoslices
{
namespace
{
class StructureLightener
{
public:
  StructureLightener(
    const std::vector<ArcSurface>& structures, double accuracy, const Execution& execution);
  std::vector<LightGraph> Run();

private:
  void FixPatches(std::size_t structure);
  void FixCycles(std::size_t structure, const Index* first, const Index* last);
  double Tolerance(int axis) const;
  void DrawPieces();
  void MoveInside(std::size_t structure);
  void FindMoves();
  LightGraph Assemble(std::size_t structure) const;
  std::vector<Point3> ListVertices(std::size_t structure, Index arc, SurfaceNormals& normals) const;
  bool FixCrossingFaces(const std::vector<LightGraph>& light);
  bool FixMeetings(const std::vector<LightGraph>& light);

  const std::vector<ArcSurface>& Structures;
  double Accuracy;
  const Execution& Execute;
  BorderPieces Borders;
  CommonNodes Nodes;
  std::vector<PieceDrawing> Drawings;     ///< of each piece
  std::vector<ArcsByFace> Faces;          ///< of each structure
  std::vector<std::vector<double>> Moves; ///< of the nodes of each structure
};

StructureLightener::StructureLightener(
  const std::vector<ArcSurface>& structures, double accuracy, const Execution& execution)
  : Structures(structures)
  , Accuracy(accuracy)
  , Execute(execution)
  , Borders(structures)
  , Nodes(structures, this->Borders)
{
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    this->FixPatches(i);
    const CycleGeometry& geometry = structures[i].Geometry;
    this->Faces.push_back(GroupArcsByFace(geometry.Grid, geometry.Crossings, execution));
  }
}

/// Patches of several cycles, and of cells with several patches, are known to be apart as they are.
void StructureLightener::FixPatches(std::size_t structure)
{
  const ArcSurface& surface = this->Structures[structure];
  for (const PatchMesh& mesh : surface.Meshes)
  {
    this->FixCycles(structure, mesh.Cycles.data(), mesh.Cycles.data() + mesh.Cycles.size());
  }
  for (const auto& [first, last] : surface.Cells.Several)
  {
    const Index* cycles = surface.Cells.Cycles.data();
    this->FixCycles(structure, cycles + first, cycles + last);
  }
}

void StructureLightener::FixCycles(std::size_t structure, const Index* first, const Index* last)
{
  const CellCycles& cycles = this->Structures[structure].Geometry.Cycles;
  for (const Index* cycle = first; cycle != last; ++cycle)
  {
    for (Index i = cycles.Offsets[*cycle]; i < cycles.Offsets[*cycle + 1]; ++i)
    {
      this->Borders.Fix(structure, cycles.Arcs[i].Arc);
    }
  }
}

/// The least of all structures, in world units.
double StructureLightener::Tolerance(int axis) const
{
  double least = HUGE_VAL;
  for (const ArcSurface& surface : this->Structures)
  {
    least = std::min(least, MeanSpacingInSlices(surface.Geometry.Grid, axis));
  }
  return this->Accuracy * least;
}

void StructureLightener::DrawPieces()
{
  const std::vector<BorderPiece>& pieces = this->Borders.Pieces;
  const SpatialGrid& grid = this->Structures.front().Geometry.Grid;
  this->Drawings.resize(pieces.size());
  this->Execute.For(pieces.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Drawings[i] = DrawPiece(grid, pieces[i], this->Tolerance(pieces[i].Axis));
      }
    });
  for (std::size_t i = 0; i < this->Structures.size(); ++i)
  {
    this->MoveInside(i);
  }
}

/// Pieces of which a vertex is not inside the face of one of their structures keep their vertices,
/// which are.
void StructureLightener::MoveInside(std::size_t structure)
{
  const SpatialGrid& grid = this->Structures[structure].Geometry.Grid;
  const ArcsByFace& faces = this->Faces[structure];
  for (Index i = 0; i < faces.Count(); ++i)
  {
    const FaceArcs face = faces[i];
    const auto isInside = [&](const Point3& vertex)
    {
      return grid.IsInside(
               FirstAxis(face.Face.Axis), face.Face.Slab[0], vertex[FirstAxis(face.Face.Axis)]) &&
        grid.IsInside(
          SecondAxis(face.Face.Axis), face.Face.Slab[1], vertex[SecondAxis(face.Face.Axis)]);
    };
    for (const Index arc : face)
    {
      for (const PieceInArc& piece : this->Borders.OfArc[structure][arc])
      {
        const std::vector<Point3>& vertices = this->Drawings[piece.Piece].Vertices;
        this->Borders.Pieces[piece.Piece].IsFixed |=
          !std::all_of(vertices.begin(), vertices.end(), isInside);
      }
    }
  }
}

/// Where nodes go of which no piece is fixed.
void StructureLightener::FindMoves()
{
  this->Moves.clear();
  for (const ArcSurface& surface : this->Structures)
  {
    this->Moves.emplace_back(surface.Geometry.Nodes.Count(), 0.0);
  }
  const auto bulges = [&](PieceEnd end) { return this->Drawings[end.Piece].Bulges[end.End]; };
  const auto tolerance = [&](int axis) { return this->Tolerance(axis); };
  for (const CommonNode& node : this->Nodes.Nodes)
  {
    const bool isFree = std::none_of(node.Ends.begin(), node.Ends.end(),
      [&](const PieceEnd& end) { return this->Borders.Pieces[end.Piece].IsFixed; });
    if (!node.MayMove || !isFree)
    {
      continue;
    }
    const double move = this->Nodes.MoveOf(node, bulges, tolerance);
    for (const auto& [structure, number] : node.Members)
    {
      this->Moves[structure][number] = move;
    }
  }
}

/// The vertices of an arc between its nodes; adds their normals and corners.
std::vector<Point3> StructureLightener::ListVertices(
  std::size_t structure, Index arc, SurfaceNormals& normals) const
{
  const ArcSurface& surface = this->Structures[structure];
  const SurfaceNormals& before = surface.Normals;
  const std::vector<Index> points = BorderPieces::PointsOf(surface.Geometry, arc);
  const auto normalAt = [&](Index point)
  {
    const float* n = before.Normals.data() + 3 * static_cast<std::size_t>(point);
    return Point3{ n[0], n[1], n[2] };
  };
  std::vector<Point3> vertices;
  const auto add = [&](const Point3& vertex, const Point3& normal, std::uint8_t isCorner)
  {
    vertices.push_back(vertex);
    normals.Normals.insert(normals.Normals.end(), normal.begin(), normal.end());
    if (!before.Corners.empty())
    {
      normals.Corners.push_back(isCorner);
    }
  };
  for (const PieceInArc& piece : this->Borders.OfArc[structure][arc])
  {
    const BorderPiece& whole = this->Borders.Pieces[piece.Piece];
    const PieceDrawing& drawing = this->Drawings[piece.Piece];
    const Index sides = static_cast<Index>(whole.Points.size()) - 1;
    if (piece.First > 0)
    {
      const Index cut = points[piece.First];
      add(surface.Geometry.Graph.PointAt(cut), normalAt(cut),
        before.Corners.empty() ? 0 : before.Corners[cut]);
    }
    for (std::size_t i = 0; i < drawing.Places.size(); ++i)
    {
      const std::size_t k = piece.IsReversed ? drawing.Places.size() - 1 - i : i;
      const CurvePlace& place = drawing.Places[k];
      const Index side = static_cast<Index>(place.Side);
      const Index from = piece.First + (piece.IsReversed ? sides - side : side);
      const Index to = from + (piece.IsReversed ? -1 : 1);
      add(drawing.Vertices[k],
        Unit(Between(normalAt(points[from]), normalAt(points[to]), place.Share)), 0);
    }
  }
  return vertices;
}

/// G of a structure as drawn: its points and their normals.
LightGraph StructureLightener::Assemble(std::size_t structure) const
{
  const ArcSurface& surface = this->Structures[structure];
  const CycleGeometry& geometry = surface.Geometry;
  const std::size_t ofNodes = geometry.Graph.Nodes;
  const std::size_t ofArcs = ofNodes + geometry.Graph.Offsets[geometry.Graph.Arcs];
  const SurfaceNormals& before = surface.Normals;
  LightGraph light;
  light.Graph = geometry.Graph;
  NodePoints nodes = geometry.Nodes;
  MoveNodes(this->Moves[structure], geometry.Grid, geometry.Crossings, nodes, light.Graph);
  light.Positions.swap(nodes.Position);
  SurfaceNormals& after = light.Normals;
  const auto copy = [&](std::size_t first, std::size_t last)
  {
    after.Normals.insert(
      after.Normals.end(), before.Normals.begin() + 3 * first, before.Normals.begin() + 3 * last);
    if (!before.Corners.empty())
    {
      after.Corners.insert(
        after.Corners.end(), before.Corners.begin() + first, before.Corners.begin() + last);
    }
  };
  copy(0, ofNodes);
  std::vector<std::vector<Point3>> vertices(geometry.Graph.Arcs);
  for (Index arc = 0; arc < geometry.Graph.Arcs; ++arc)
  {
    vertices[arc] = this->ListVertices(structure, arc, after);
  }
  DrawArcs(vertices, light.Graph);
  copy(ofArcs, geometry.Graph.Count());
  return light;
}

/// Fixes the pieces of faces that a structure's arcs cross in. Whether there are any.
bool StructureLightener::FixCrossingFaces(const std::vector<LightGraph>& light)
{
  bool any = false;
  for (std::size_t i = 0; i < light.size(); ++i)
  {
    const CycleGeometry& geometry = this->Structures[i].Geometry;
    const ArcsByFace& faces = this->Faces[i];
    for (const Index face :
      FindCrossingFaces({ geometry.Grid, geometry.Nodes, geometry.Crossings, light[i].Graph },
        faces, this->Execute))
    {
      for (const Index arc : faces[face])
      {
        for (const PieceInArc& piece : this->Borders.OfArc[i][arc])
        {
          any |= !this->Borders.Pieces[piece.Piece].IsFixed;
        }
        this->Borders.Fix(i, arc);
      }
    }
  }
  return any;
}

/// Fixes pieces that meet, of whatever structures, unless they did before. Whether there are any.
bool StructureLightener::FixMeetings(const std::vector<LightGraph>& light)
{
  std::map<Point3, Point3> moved; // where nodes were and are
  for (std::size_t i = 0; i < light.size(); ++i)
  {
    for (Index node = 0; node < light[i].Graph.Nodes; ++node)
    {
      if (this->Moves[i][node] != 0.0)
      {
        moved[this->Structures[i].Geometry.Graph.PointAt(node)] = light[i].Graph.PointAt(node);
      }
    }
  }
  std::vector<PieceSide> sides;
  for (std::size_t i = 0; i < this->Drawings.size(); ++i)
  {
    AddSides(this->Borders.Pieces[i], this->Drawings[i], moved, static_cast<Index>(i), sides);
  }
  bool any = false;
  for (const auto& [first, second] : FindMeetings(sides))
  {
    for (const Index piece : { first, second })
    {
      any |= !this->Borders.Pieces[piece].IsFixed;
      this->Borders.Pieces[piece].IsFixed = true;
    }
  }
  return any;
}

std::vector<LightGraph> StructureLightener::Run()
{
  this->DrawPieces();
  std::vector<LightGraph> light;
  bool again = true;
  while (again)
  {
    for (std::size_t i = 0; i < this->Drawings.size(); ++i)
    {
      if (this->Borders.Pieces[i].IsFixed)
      {
        this->Drawings[i] = KeepPiece(this->Borders.Pieces[i]);
      }
    }
    this->FindMoves();
    light.clear();
    for (std::size_t i = 0; i < this->Structures.size(); ++i)
    {
      light.push_back(this->Assemble(i));
    }
    const bool inFaces = this->FixCrossingFaces(light);
    again = this->FixMeetings(light) || inFaces;
  }
  return light;
}
}

std::vector<LightGraph> LightenStructures(
  const std::vector<ArcSurface>& structures, double accuracy, const Execution& execution)
{
  return StructureLightener(structures, accuracy, execution).Run();
}
}
