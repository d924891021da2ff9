// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/EmbedArcs.h"

#include "Core/Graph/ArcShells.h"
#include "Core/Graph/EditGraph.h"
#include "Core/Graph/FaceArcs.h"
#include "Core/Planar/UncrossCurves.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// The arcs of a face as curves; arc i had the vertices First[i] to First[i + 1] - 1.
struct FaceCurves
{
  PlanarCurves Curves;
  std::vector<Index> First;
};

class ArcEmbedder
{
public:
  ArcEmbedder(const ArcGeometry& geometry, const Execution& execution)
    : Geometry(geometry)
    , Execute(execution)
  {
  }

  std::vector<FaceDrawing> Run(const ArcsByFace& faces, const std::vector<Index>& forced) const;
  std::vector<Index> FindChanged(const ArcsByFace& faces) const;

private:
  enum class Task : std::uint8_t
  {
    Keep,
    Uncross,
    DrawAnew
  };

  std::vector<Task> Classify(const ArcsByFace& faces, const std::vector<Index>& forced) const;
  bool IsSimple(const FaceArcs& face) const;
  bool IsMonotone(const Face& face, Index arc) const;
  bool AreOnOneEdge(Index a, Index b) const;

  FaceDrawing Draw(const FaceArcs& face, bool forced) const;
  bool Uncross(const FaceArcs& face, FaceDrawing& drawing) const;
  FaceCurves GetCurves(const FaceArcs& face) const;
  Index StopOf(const FaceArcs& face, const FaceCurves& curves, Index curve) const;
  Index AddBumps(const FaceArcs& face, double steepness, FaceCurves& curves) const;
  Point2 Bump(const Face& face, double steepness, Index start, Index stop) const;
  void Redraw(const FaceArcs& face, const FaceCurves& curves, const Uncrossing& outcome,
    FaceDrawing& drawing) const;
  Repair DescribeBumps(const Face& face, const FaceDrawing& drawing) const;

  const ArcGeometry& Geometry;
  const Execution& Execute;
};

/// Every segment goes forward in the direction from end to end: such an arc cannot touch itself.
bool ArcEmbedder::IsMonotone(const Face& face, Index arc) const
{
  const Point2 start = this->Geometry.InPlane(face, this->Geometry.StartNode(arc));
  const Point2 end = this->Geometry.InPlane(face, this->Geometry.EndNode(arc));
  const Point2 chord{ end[0] - start[0], end[1] - start[1] };
  bool monotone = true;
  bool first = true;
  Point2 previous = start;
  this->Geometry.VisitPoints(arc,
    [&](Index point)
    {
      const Point2 p = this->Geometry.InPlane(face, point);
      const double step = (p[0] - previous[0]) * chord[0] + (p[1] - previous[1]) * chord[1];
      monotone &= first || step > 0.0;
      first = false;
      previous = p;
    });
  return monotone;
}

bool ArcEmbedder::AreOnOneEdge(Index a, Index b) const
{
  return this->Geometry.Crossings.Edge[a] == this->Geometry.Crossings.Edge[b];
}

bool ArcEmbedder::IsSimple(const FaceArcs& face) const
{
  for (const Index arc : face)
  {
    if (this->Geometry.Graph.PointCount(arc) == 0 &&
      this->AreOnOneEdge(arc, this->Geometry.Crossings.Next[arc]))
    {
      return false;
    }
  }
  if (face.Count() == 1 && this->IsMonotone(face.Face, *face.First))
  {
    return true;
  }
  FaceCurves curves = this->GetCurves(face);
  return AreSimple(curves.Curves);
}

/// A vertex a little inside the face, beside the middle between two ends on one edge of M: as deep
/// as a part of their distance, `steepness`.
Point2 ArcEmbedder::Bump(const Face& face, double steepness, Index start, Index stop) const
{
  const SpatialGrid& grid = this->Geometry.Grid;
  const Point2 from = this->Geometry.InPlane(face, this->Geometry.Nodes.NodeOf[start]);
  const Point2 to = this->Geometry.InPlane(face, this->Geometry.Nodes.NodeOf[stop]);
  const int edge = BorderEdge(this->Geometry.Crossings, start, true);
  const int across = edge % 2 == 1 ? 0 : 1;
  const int along = 1 - across;
  const int axis = (face.Axis + 1 + across) % 3;
  double low, high;
  grid.GetExtent(axis, face.Slab[across], from[across], from[across], low, high);
  grid.ClipToBounds(axis, low, high);
  const double depth =
    std::min(steepness * std::abs(to[along] - from[along]), 0.125 * (high - low));
  const bool lower = edge == 0 || edge == 3;
  Point2 bump;
  bump[along] = grid.Round(from[along] + 0.5 * (to[along] - from[along]));
  bump[across] = grid.MoveInside(axis, face.Slab[across], from[across] + (lower ? depth : -depth));
  return bump;
}

FaceCurves ArcEmbedder::GetCurves(const FaceArcs& face) const
{
  FaceCurves curves;
  for (const Index arc : face)
  {
    const Index first = static_cast<Index>(curves.Curves.Vertices.size());
    this->Geometry.VisitPoints(arc,
      [&](Index point)
      { curves.Curves.Vertices.push_back(this->Geometry.InPlane(face.Face, point)); });
    curves.First.push_back(first);
    curves.Curves.Curves.emplace_back(curves.Curves.Vertices.size() - first);
    std::iota(curves.Curves.Curves.back().begin(), curves.Curves.Curves.back().end(), first);
  }
  curves.First.push_back(static_cast<Index>(curves.Curves.Vertices.size()));
  return curves;
}

/// The crossing at which a curve ends.
Index ArcEmbedder::StopOf(const FaceArcs& face, const FaceCurves& curves, Index curve) const
{
  const Index end = curves.Curves.Curves[curve].back();
  const auto next = std::upper_bound(curves.First.begin(), curves.First.end(), end);
  return this->Geometry.Crossings.Next[face.First[next - curves.First.begin() - 1]];
}

/// Draws curves that lie on an edge of M into the face. Returns how many there were. Bumps of one
/// steepness, of a quarter or less, do not touch each other if one is within the other.
Index ArcEmbedder::AddBumps(const FaceArcs& face, double steepness, FaceCurves& curves) const
{
  Index count = 0;
  for (Index i = 0; i < face.Count(); ++i)
  {
    std::vector<Index>& curve = curves.Curves.Curves[i];
    const Index start = face.First[i];
    const Index stop = this->StopOf(face, curves, i);
    if (curve.size() == 2 && this->AreOnOneEdge(start, stop))
    {
      curve.insert(curve.begin() + 1, static_cast<Index>(curves.Curves.Vertices.size()));
      curves.Curves.Vertices.push_back(this->Bump(face.Face, steepness, start, stop));
      ++count;
    }
  }
  return count;
}

/// Passes the vertices of the arcs in another order. False if that does not help.
bool ArcEmbedder::Uncross(const FaceArcs& face, FaceDrawing& drawing) const
{
  // An arc that runs beside the edge of M may take the top of a bump over. On a virtual slice the
  // next bump has to fit between the two, so that it is flatter. On a real one bumps stay as they
  // are: of things thinner than the slices are apart they are most of the volume.
  constexpr int maxRounds = 4;
  const bool isVirtual = this->Geometry.Grid.IsVirtual(face.Face.Axis, face.Face.Plane);
  const double flatter = isVirtual ? 0.25 : 1.0;
  double steepness = 0.25;
  FaceCurves curves = this->GetCurves(face);
  this->AddBumps(face, steepness, curves);
  Uncrossing outcome = UncrossCurves(curves.Curves);
  for (int round = 1; outcome.Simple && this->AddBumps(face, steepness *= flatter, curves) > 0;
       ++round)
  {
    if (round == maxRounds)
    {
      return false;
    }
    outcome.Simple = UncrossCurves(curves.Curves).Simple;
  }
  if (outcome.Simple)
  {
    this->Redraw(face, curves, outcome, drawing);
  }
  return outcome.Simple;
}

/// The arcs that are not as they were.
void ArcEmbedder::Redraw(const FaceArcs& face, const FaceCurves& curves, const Uncrossing& outcome,
  FaceDrawing& drawing) const
{
  std::vector<Index> stops;
  for (Index i = 0; i < face.Count(); ++i)
  {
    stops.push_back(this->StopOf(face, curves, i));
  }
  for (Index i = 0; i < face.Count(); ++i)
  {
    const std::vector<Index>& curve = curves.Curves.Curves[i];
    const Index size = curves.First[i + 1] - curves.First[i];
    if (this->Geometry.Crossings.Next[face.First[i]] != stops[i])
    {
      drawing.Joins.push_back({ face.First[i], stops[i] });
    }
    if (static_cast<Index>(curve.size()) == size && curve.back() == curves.First[i + 1] - 1 &&
      std::is_sorted(curve.begin(), curve.end()))
    {
      continue;
    }
    drawing.Arcs.push_back(face.First[i]);
    for (std::size_t k = 1; k + 1 < curve.size(); ++k)
    {
      drawing.Points.push_back(this->Geometry.InSpace(face.Face, curves.Curves.Vertices[curve[k]]));
    }
    drawing.Offsets.push_back(drawing.Points.size());
  }
  drawing.What = outcome.Changes > 0 ? Repair{ RepairKind::ArcsUncrossed, face.Face.Axis,
    face.Face.Plane, this->Geometry.InSpace(face.Face, outcome.Where), outcome.Shortening }
                                     : this->DescribeBumps(face.Face, drawing);
}

/// The repair that is nothing but bumps.
Repair ArcEmbedder::DescribeBumps(const Face& face, const FaceDrawing& drawing) const
{
  double length = 0.0;
  for (std::size_t i = 0; i < drawing.Arcs.size(); ++i)
  {
    const Point2 start = this->Geometry.InPlane(face, this->Geometry.StartNode(drawing.Arcs[i]));
    const Point3 bump = drawing.Points[i];
    length += 2.0 *
      std::hypot(bump[FirstAxis(face.Axis)] - start[0], bump[SecondAxis(face.Axis)] - start[1]);
  }
  return { RepairKind::ArcsRedrawn, face.Axis, face.Plane, drawing.Points.front(), length };
}

FaceDrawing ArcEmbedder::Draw(const FaceArcs& face, bool forced) const
{
  FaceDrawing drawing;
  return !forced && this->Uncross(face, drawing) ? drawing : DrawArcShells(this->Geometry, face);
}

/// What to do with each face: keep it, take its arcs apart, or draw them anew.
std::vector<ArcEmbedder::Task> ArcEmbedder::Classify(
  const ArcsByFace& faces, const std::vector<Index>& forced) const
{
  std::vector<std::uint8_t> isForced(forced.empty() ? 0 : this->Geometry.Crossings.Count(), 0);
  for (const Index arc : forced)
  {
    isForced[arc] = 1;
  }
  std::vector<Task> tasks(faces.Count(), Task::Keep);
  this->Execute.For(tasks.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const FaceArcs face = faces[static_cast<Index>(i)];
        bool anew = false;
        for (const Index arc : face)
        {
          anew |= !isForced.empty() && isForced[arc] != 0;
        }
        tasks[i] = anew ? Task::DrawAnew : this->IsSimple(face) ? Task::Keep : Task::Uncross;
      }
    });
  return tasks;
}

std::vector<Index> ArcEmbedder::FindChanged(const ArcsByFace& faces) const
{
  const std::vector<Task> tasks = this->Classify(faces, {});
  std::vector<Index> changed;
  for (Index face = 0; face < faces.Count(); ++face)
  {
    if (tasks[face] != Task::Keep)
    {
      changed.push_back(face);
    }
  }
  return changed;
}

std::vector<FaceDrawing> ArcEmbedder::Run(
  const ArcsByFace& faces, const std::vector<Index>& forced) const
{
  const std::vector<Task> tasks = this->Classify(faces, forced);
  std::vector<Index> changed;
  for (Index face = 0; face < faces.Count(); ++face)
  {
    if (tasks[face] != Task::Keep)
    {
      changed.push_back(face);
    }
  }
  std::vector<FaceDrawing> drawings(changed.size());
  this->Execute.For(changed.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        drawings[i] = this->Draw(faces[changed[i]], tasks[changed[i]] == Task::DrawAnew);
      }
    });
  return drawings;
}
}

std::vector<Repair> EmbedArcs(
  const GraphTables& tables, const Execution& execution, const std::vector<Index>& forced)
{
  const ArcsByFace faces = GroupArcsByFace(tables.Grid, tables.Crossings, execution);
  MoveInsideFaces(tables.Grid, faces, execution, tables.Graph);
  const ArcGeometry geometry{ tables.Grid, tables.Nodes, tables.Crossings, tables.Graph };
  const std::vector<FaceDrawing> drawings = ArcEmbedder(geometry, execution).Run(faces, forced);
  std::vector<Repair> repairs;
  for (const FaceDrawing& drawing : drawings)
  {
    repairs.push_back(drawing.What);
  }
  ReplaceArcs(drawings, tables.Crossings, tables.Graph);
  return repairs;
}

std::vector<Index> FindCrossingFaces(
  const ArcGeometry& geometry, const ArcsByFace& faces, const Execution& execution)
{
  return ArcEmbedder(geometry, execution).FindChanged(faces);
}
}
