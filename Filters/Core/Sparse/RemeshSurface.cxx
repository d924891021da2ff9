// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/RemeshSurface.h"

#include "Core/Base/TriangleDistance.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
constexpr double Long = 4.0 / 3.0;
constexpr double Short = 4.0 / 5.0;
/// How far contours may move off their vertices, as a share of the edges that collapse.
constexpr double ContourShare = 0.1;

double EdgeLength(const SurfaceMesh& mesh, Index corner)
{
  return Length(mesh.Edge(mesh.Corners.StartOf(corner), mesh.Corners.EndOf(corner)));
}

/// Whether the edges at the start of an edge stay short where they lead to `target` instead.
bool StaysShort(const SurfaceMesh& mesh, Index corner, const Point3& target, double maximum)
{
  double before = 0.0;
  double after = 0.0;
  for (const Index end : { mesh.Corners.StartOf(corner), mesh.Corners.EndOf(corner) })
  {
    mesh.Corners.ForCornersAt(end,
      [&](Index at)
      {
        const Index neighbor = mesh.Corners.VertexOf(CornerTable::Next(at));
        before = std::max(before, Length(mesh.Edge(end, neighbor)));
        after = std::max(
          after, Length(mesh.Stretched(mesh.Points[neighbor] - target, mesh.Stretch[neighbor])));
      });
  }
  return after <= std::max(before, maximum);
}

/// Whether a contour stays within `tolerance` of the start of an edge if that is left out.
bool StaysOnContour(const SurfaceMesh& mesh, Index corner, double tolerance)
{
  const Index start = mesh.Corners.StartOf(corner);
  const Point3& target = mesh.Points[mesh.Corners.EndOf(corner)];
  bool stays = true;
  mesh.Corners.ForCornersAt(start,
    [&](Index at)
    {
      if (mesh.Corners.IsCurve(CornerTable::Previous(at)))
      {
        const Point3& before = mesh.Points[mesh.Corners.VertexOf(CornerTable::Next(at))];
        stays &= before == target ||
          SquaredDistanceToSegment(mesh.Points[start], before, target) <= tolerance * tolerance;
      }
    });
  return stays;
}

/// Moves the start of the corner's edge into its end, if that may be.
bool TryCollapse(Index corner, double shortest, double maximum, SurfaceMesh& mesh)
{
  // Contours keep their course; the classes of short edges add up to twice that.
  const double tolerance = ContourShare * shortest / mesh.Stretch[mesh.Corners.StartOf(corner)];
  const Index start = mesh.Corners.StartOf(corner);
  const Index end = mesh.Corners.EndOf(corner);
  const Point3 target =
    mesh.Fixed[end] ? mesh.Points[end] : Between(mesh.Points[start], mesh.Points[end], 0.5);
  if ((mesh.Fixed[start] && !mesh.Corners.IsCurve(corner)) || !mesh.Corners.CanCollapse(corner) ||
    (mesh.Fixed[start] && !StaysOnContour(mesh, corner, tolerance)) ||
    !StaysShort(mesh, corner, target, maximum))
  {
    return false;
  }
  mesh.Corners.Collapse(corner);
  mesh.Points[end] = target;
  return true;
}

/// Splits the edge of a corner in its middle.
void SplitEdge(Index corner, SurfaceMesh& mesh)
{
  const Index start = mesh.Corners.StartOf(corner);
  const Index end = mesh.Corners.EndOf(corner);
  const Index across = mesh.Corners.OppositeOf(corner);
  const bool isCurve = mesh.Corners.IsCurve(corner);
  mesh.Points.push_back(Between(mesh.Points[start], mesh.Points[end], 0.5));
  mesh.Stretch.push_back(0.5 * (mesh.Stretch[start] + mesh.Stretch[end]));
  mesh.Fixed.push_back(isCurve ? 1 : 0);
  mesh.Crease.push_back(mesh.Crease[start] && mesh.Crease[end] && isCurve ? 1 : 0);
  mesh.Cell.push_back(mesh.Cell[corner / 3]);
  mesh.Cell.push_back(mesh.Cell[across / 3]);
  mesh.Corners.Split(corner);
}

double Cotangent(const SurfaceMesh& mesh, Index apex, Index a, Index b)
{
  const Point3 u = mesh.Edge(apex, a);
  const Point3 v = mesh.Edge(apex, b);
  return Dot(u, v) / std::max(Length(Cross(u, v)), 1e-300);
}

bool IsDelaunay(const SurfaceMesh& mesh, Index corner)
{
  const CornerTable& corners = mesh.Corners;
  const Index a = corners.StartOf(corner);
  const Index b = corners.EndOf(corner);
  const Index c = corners.VertexOf(corner);
  const Index d = corners.VertexOf(corners.OppositeOf(corner));
  // A little more than nothing, so that four points on a circle do not flip for ever.
  constexpr double enough = -1e-9;
  return Cotangent(mesh, c, a, b) + Cotangent(mesh, d, a, b) >= enough;
}
}

void CollapseShortEdges(double length, SurfaceMesh& mesh)
{
  // The shortest first, in a few classes; a collapse makes room for others, so that each class has
  // a few passes.
  constexpr int classes = 5;
  constexpr int passes = 4;
  for (int i = classes - 1; i >= 0; --i)
  {
    const double shortest = Short * length * std::pow(0.5, i);
    bool changed = true;
    for (int pass = 0; pass < passes && changed; ++pass)
    {
      changed = false;
      for (Index corner = 0; corner < mesh.Corners.CornerCount(); ++corner)
      {
        if (mesh.Corners.IsAlive(corner) && EdgeLength(mesh, corner) < shortest)
        {
          changed |= TryCollapse(corner, shortest, Long * length, mesh);
        }
      }
    }
  }
}

void SplitLongEdges(double length, SurfaceMesh& mesh)
{
  // New edges come at the end and are looked at, too; but one part of an edge stays with its old
  // corners, which is still too long after two splits if the edge was very long.
  bool changed = true;
  while (changed)
  {
    changed = false;
    for (Index corner = 0; corner < mesh.Corners.CornerCount(); ++corner)
    {
      if (mesh.Corners.IsAlive(corner) && EdgeLength(mesh, corner) > Long * length)
      {
        SplitEdge(corner, mesh);
        changed = true;
      }
    }
  }
}

void RefineEdges(double length, SurfaceMesh& mesh)
{
  for (double scale = 8.0; scale >= 1.0; scale *= 0.5)
  {
    SplitLongEdges(scale * length, mesh);
    FlipEdges(mesh);
  }
}

void FlipEdges(SurfaceMesh& mesh)
{
  constexpr int passes = 10;
  bool changed = true;
  for (int pass = 0; pass < passes && changed; ++pass)
  {
    changed = false;
    for (Index corner = 0; corner < mesh.Corners.CornerCount(); ++corner)
    {
      if (mesh.Corners.IsAlive(corner) && corner < mesh.Corners.OppositeOf(corner) &&
        !IsDelaunay(mesh, corner) && mesh.Corners.CanFlip(corner))
      {
        mesh.Corners.Flip(corner);
        changed = true;
      }
    }
  }
}
}
