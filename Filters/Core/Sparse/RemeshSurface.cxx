// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/RemeshSurface.h"

#include "Core/Base/TriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
constexpr double Long = 4.0 / 3.0;
constexpr double Short = 4.0 / 5.0;
/// How far contours may move off their vertices, as a share of the edges that collapse.
constexpr double ContourShare = 0.1;
/// Classes of short edges, but for those that fine contours need.
constexpr int UsualClasses = 5;

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

/// Whether a contour stays within `tolerance` of the start of an edge if that is left out, and gets
/// no edge there that is longer than `longest`.
bool StaysOnContour(const SurfaceMesh& mesh, Index corner, double tolerance, double longest)
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
        const Point3& stretch = mesh.Stretch[start];
        stays &= before == target ||
          (SquaredDistanceToSegment(mesh.Points[start], before, target) <= tolerance * tolerance &&
            Length(mesh.Stretched(target - before, stretch)) <= longest);
      }
    });
  return stays;
}

/// Moves the start of the corner's edge into its end, if that may be.
bool TryCollapse(
  Index corner, double shortest, double longestOnContour, double maximum, SurfaceMesh& mesh)
{
  // Contours keep their course; the classes of short edges add up to twice that.
  const Point3& stretch = mesh.Stretch[mesh.Corners.StartOf(corner)];
  const double tolerance =
    ContourShare * shortest / std::max({ stretch[0], stretch[1], stretch[2] });
  const Index start = mesh.Corners.StartOf(corner);
  const Index end = mesh.Corners.EndOf(corner);
  const Point3 target =
    mesh.Fixed[end] ? mesh.Points[end] : Between(mesh.Points[start], mesh.Points[end], 0.5);
  if (mesh.Fixed[start] == SurfaceMesh::AtCorner ||
    (mesh.Fixed[start] && !mesh.Corners.IsCurve(corner)) || !mesh.Corners.CanCollapse(corner) ||
    (mesh.Fixed[start] && !StaysOnContour(mesh, corner, tolerance, longestOnContour)) ||
    !StaysShort(mesh, corner, target, maximum))
  {
    return false;
  }
  mesh.Corners.Collapse(corner);
  mesh.Points[end] = target;
  return true;
}

bool IsDelaunay(const SurfaceMesh& mesh, Index corner)
{
  // A little more than nothing, so that four points on a circle do not flip for ever.
  constexpr double enough = -1e-9;
  return mesh.Cotangent(corner) + mesh.Cotangent(mesh.Corners.OppositeOf(corner)) >= enough;
}

/// The shortest edges collapse first, in classes that are half as long as the next one, so that no
/// vertex gathers the triangles of many others: as many as the edges of contours need.
int CountClasses(double length, const std::vector<Index>& corners, const SurfaceMesh& mesh)
{
  constexpr int most = 16;
  double sum = 0.0; // of logarithms, which a few long edges do not rule
  double count = 0.0;
  for (const Index corner : corners)
  {
    if (mesh.Corners.IsCurve(corner))
    {
      sum += std::log2(std::max(EdgeLength(mesh, corner) / length, std::pow(0.5, most)));
      count += 1.0;
    }
  }
  return std::clamp(static_cast<int>(std::ceil(-sum / std::max(count, 1.0))), UsualClasses, most);
}
}

void CollapseShortEdges(double length, SurfaceMesh& mesh)
{
  // A collapse makes room for others, so that each class has a few passes.
  constexpr int passes = 4;
  std::vector<Index> corners(static_cast<std::size_t>(mesh.Corners.CornerCount()));
  std::iota(corners.begin(), corners.end(), 0);
  const auto leaveOutDead = [&]
  {
    corners.erase(std::remove_if(corners.begin(), corners.end(),
                    [&](Index corner) { return !mesh.Corners.IsAlive(corner); }),
      corners.end());
  };
  leaveOutDead();
  for (int i = CountClasses(length, corners, mesh) - 1; i >= 0; --i)
  {
    const double shortest = Short * length * std::pow(0.5, i);
    // Where contours are much finer than the mesh, one vertex must not run along all of them.
    const double longest = i < UsualClasses ? HUGE_VAL : Long / Short * shortest;
    bool changed = true;
    for (int pass = 0; pass < passes && changed; ++pass)
    {
      changed = false;
      for (const Index corner : corners)
      {
        if (mesh.Corners.IsAlive(corner) && EdgeLength(mesh, corner) < shortest)
        {
          changed |= TryCollapse(corner, shortest, longest, Long * length, mesh);
        }
      }
      leaveOutDead();
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
        SplitEdge(corner, 0.5, mesh);
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
