// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/RemeshSurface.h"

#include "Core/Base/TriangleDistance.h"

#include <algorithm>
#include <array>
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

bool IsDelaunay(const SurfaceMesh& mesh, Index corner)
{
  // A little more than nothing, so that four points on a circle do not flip for ever.
  constexpr double enough = -1e-9;
  return mesh.Cotangent(corner) + mesh.Cotangent(mesh.Corners.OppositeOf(corner)) >= enough;
}

/// How short edges are that collapse, and how long those along a contour may get by it.
struct ShortEdges
{
  double Shortest, LongestOnContour;
};

/// Collapses edges, and knows which ones it need not look at again.
class EdgeCollapser
{
public:
  /// No edge becomes longer than `maximum`, and than those that were there.
  EdgeCollapser(double maximum, SurfaceMesh& mesh);

  /// Moves the start of the corner's edge into its end, if it is short and that may be.
  bool Try(Index corner, const ShortEdges& edges);

private:
  bool MayCollapse(Index corner, const Point3& target);
  bool StaysShort(Index corner, const Point3& target) const;
  void Update(Index moved);

  double Maximum;
  SurfaceMesh& Mesh;
  std::vector<double> Lengths; ///< of the edges of corners
  Index Collapses = 0;
  std::vector<Index> ChangedAt; ///< of each point: the collapse that changed its triangles last
  std::vector<Index> RefusedAt; ///< of each corner: the collapses that there were then; -1 if not
};

EdgeCollapser::EdgeCollapser(double maximum, SurfaceMesh& mesh)
  : Maximum(maximum)
  , Mesh(mesh)
  , Lengths(static_cast<std::size_t>(mesh.Corners.CornerCount()), 0.0)
  , ChangedAt(mesh.Points.size(), 0)
  , RefusedAt(static_cast<std::size_t>(mesh.Corners.CornerCount()), -1)
{
  for (Index corner = 0; corner < mesh.Corners.CornerCount(); ++corner)
  {
    if (mesh.Corners.IsAlive(corner))
    {
      this->Lengths[corner] = EdgeLength(mesh, corner);
    }
  }
}

/// Whether the edges at both ends of an edge stay short where they lead to `target` instead.
bool EdgeCollapser::StaysShort(Index corner, const Point3& target) const
{
  const CornerTable& corners = this->Mesh.Corners;
  const std::array<Index, 2> ends{ corners.StartOf(corner), corners.EndOf(corner) };
  double longest = this->Maximum;
  for (const Index end : ends)
  {
    corners.ForCornersAt(end,
      [&](Index at) { longest = std::max(longest, this->Lengths[CornerTable::Previous(at)]); });
  }
  bool isShort = true;
  for (const Index end : ends)
  {
    corners.ForCornersAt(end,
      [&](Index at)
      {
        const Index neighbor = corners.VertexOf(CornerTable::Next(at));
        const Point3 edge =
          this->Mesh.Stretched(this->Mesh.Points[neighbor] - target, this->Mesh.Stretch[neighbor]);
        isShort = isShort && Length(edge) <= longest;
      });
  }
  return isShort;
}

/// What does not depend on the class of short edges. Refused once, it need not be tried again until
/// a triangle at one of the ends changes.
bool EdgeCollapser::MayCollapse(Index corner, const Point3& target)
{
  const CornerTable& corners = this->Mesh.Corners;
  const Index changed =
    std::max(this->ChangedAt[corners.StartOf(corner)], this->ChangedAt[corners.EndOf(corner)]);
  if (this->RefusedAt[corner] >= changed)
  {
    return false;
  }
  const bool may = this->StaysShort(corner, target) && corners.CanCollapse(corner);
  this->RefusedAt[corner] = may ? -1 : this->Collapses;
  return may;
}

/// After a point has moved, and its triangles have changed.
void EdgeCollapser::Update(Index moved)
{
  ++this->Collapses;
  this->ChangedAt[moved] = this->Collapses;
  this->Mesh.Corners.ForCornersAt(moved,
    [&](Index at)
    {
      const Index neighbor = this->Mesh.Corners.VertexOf(CornerTable::Next(at));
      this->ChangedAt[neighbor] = this->Collapses;
      for (const Index corner : { CornerTable::Next(at), CornerTable::Previous(at) })
      {
        this->Lengths[corner] = EdgeLength(this->Mesh, corner);
      }
    });
}

bool EdgeCollapser::Try(Index corner, const ShortEdges& edges)
{
  SurfaceMesh& mesh = this->Mesh;
  if (this->Lengths[corner] >= edges.Shortest)
  {
    return false;
  }
  const Index start = mesh.Corners.StartOf(corner);
  const Index end = mesh.Corners.EndOf(corner);
  const bool isFixed = mesh.Fixed[start] != 0;
  if (mesh.Fixed[start] == SurfaceMesh::AtCorner || (isFixed && !mesh.Corners.IsCurve(corner)))
  {
    return false;
  }
  const Point3 target =
    mesh.Fixed[end] ? mesh.Points[end] : Between(mesh.Points[start], mesh.Points[end], 0.5);
  // Contours keep their course; the classes of short edges add up to twice that.
  const Point3& stretch = mesh.Stretch[start];
  const double tolerance =
    ContourShare * edges.Shortest / std::max({ stretch[0], stretch[1], stretch[2] });
  if (!this->MayCollapse(corner, target) ||
    (isFixed && !StaysOnContour(mesh, corner, tolerance, edges.LongestOnContour)))
  {
    return false;
  }
  mesh.Corners.Collapse(corner);
  mesh.Points[end] = target;
  this->Update(end);
  return true;
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
  EdgeCollapser collapser(Long * length, mesh);
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
        changed |= mesh.Corners.IsAlive(corner) && collapser.Try(corner, { shortest, longest });
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
  // Edges need not be looked at again if neither of their triangles has changed since the last pass
  // came by. Those that may not flip count as changed: they may later.
  std::vector<int> changedIn(static_cast<std::size_t>(mesh.Corners.CornerCount() / 3), 0);
  bool changed = true;
  for (int pass = 0; pass < passes && changed; ++pass)
  {
    changed = false;
    for (Index corner = 0; corner < mesh.Corners.CornerCount(); ++corner)
    {
      const Index across = mesh.Corners.IsAlive(corner) ? mesh.Corners.OppositeOf(corner) : -1;
      if (corner >= across || std::max(changedIn[corner / 3], changedIn[across / 3]) < pass - 1 ||
        IsDelaunay(mesh, corner))
      {
        continue;
      }
      changedIn[corner / 3] = changedIn[across / 3] = pass;
      if (mesh.Corners.CanFlip(corner))
      {
        mesh.Corners.Flip(corner);
        changed = true;
      }
    }
  }
}
}
