// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SurfaceMesh.h"

#include "Core/Graph/CycleGeometry.h"
#include "Core/Slices/EndSlices.h"
#include "Core/Sparse/RaiseEnds.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Where points of a cell may go: as far as guides show, or half a spacing beyond the contours.
Box3 BoundCell(const SpatialGrid& grid, const Box3& contours, const Box3& guides,
  const std::array<Index, 3>& cell)
{
  Box3 box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double beyond = 0.5 * grid.MeanSpacing(axis);
    const Index slab = cell[axis];
    const double margin = grid.Margin(axis, slab);
    box.Low[axis] = slab > 0 ? grid.Planes[axis][slab - 1] + margin
                             : std::min(contours.Low[axis] - beyond, guides.Low[axis]);
    box.High[axis] = slab < grid.Count(axis)
      ? grid.Planes[axis][slab] - margin
      : std::max(contours.High[axis] + beyond, guides.High[axis]);
  }
  return box;
}

/// Along the missing one of several axes, points stay within half the greater spacing of where
/// their patch was. No planes bound the cell there, and a patch that hangs on little could become a
/// bar.
void BoundAlongMissingAxis(const SpatialGrid& grid, const Box3& patch, Box3& cell)
{
  double spacing = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    spacing = grid.Count(axis) > 1 ? std::max(spacing, grid.MeanSpacing(axis)) : spacing;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (grid.Count(axis) == 0 && spacing > 0.0 && patch.Low[axis] <= patch.High[axis])
    {
      cell.Low[axis] = std::max(cell.Low[axis], patch.Low[axis] - 0.5 * spacing);
      cell.High[axis] = std::min(cell.High[axis], patch.High[axis] + 0.5 * spacing);
    }
  }
}

struct LoopSize
{
  double Area, Length;
  /// The radius of a circle, the thickness of a long strip.
  double Thickness() const { return 2.0 * this->Area / this->Length; }
};

LoopSize MeasureLoop(const NodeGraph& graph, const AxisFrame& metric, Index loop)
{
  const int axis = graph.Loops[loop].Axis;
  const Index arc = graph.Arcs + loop;
  const Index count = graph.PointCount(arc);
  double area = 0.0;
  double length = 0.0;
  const auto inWorld = [&](const Point3& p) { return metric.IsWorld() ? p : metric.ToWorld(p); };
  // From a point of its own: small loops may lie far from the origin.
  const Point3 first = inWorld(graph.PointAt(graph.FirstPoint(arc)));
  for (Index i = 0; i < count; ++i)
  {
    const Point3 p = inWorld(graph.PointAt(graph.FirstPoint(arc) + i));
    const Point3 q = inWorld(graph.PointAt(graph.FirstPoint(arc) + (i + 1) % count));
    area += 0.5 * Dot(Cross(p - first, q - first), metric.Normal(axis));
    length += Length(q - p);
  }
  return { std::abs(area), length };
}

/// The radius of a tube that slices one spacing apart show well: least bending then narrows it by
/// half a percent in the middle between two slices.
constexpr double SpacingsOfRadius = 0.85;
/// The same where the surface has an edge around a flat end, and bends there as it likes: like a
/// soap film it would narrow a tube between two such ends by one part in 2 (2 radii / spacings) ^
/// 2.
constexpr double SpacingsOfRadiusAtEdge = 3.0;
/// Thinner things are not worth the triangles. Of two families, both show what is thin.
constexpr double MaxStretch = 16.0;
constexpr double MaxStretchOfTwo = 2.0;
/// Nor are contours that are thin and long: stretched, they are at most so long. Round ones never
/// are, with an edge or without.
constexpr double MaxSpacingsOfLength = 20.0;

/// Points of contours without node points.
void StretchLoop(
  const CycleGeometry& geometry, const StackEnds& ends, Index loop, SurfaceMesh& mesh)
{
  const NodeGraph& graph = geometry.Graph;
  const Index first = graph.FirstPoint(graph.Arcs + loop);
  const int axis = graph.Loops[loop].Axis;
  const bool isOnly = mesh.StretchAxis >= 0;
  const bool isAtEdge = isOnly && (mesh.Crease[first] != 0 || ends.HasRim[loop] != 0);
  const double spacings = isAtEdge ? SpacingsOfRadiusAtEdge : SpacingsOfRadius;
  const double spacing = geometry.Grid.MeanSpacing(axis);
  const LoopSize size = MeasureLoop(graph, mesh.Metric, loop);
  const double wanted =
    std::min(spacings / size.Thickness(), MaxSpacingsOfLength / size.Length) * spacing;
  const double stretch = std::clamp(wanted, 1.0, isOnly ? MaxStretch : MaxStretchOfTwo);
  Point3 within{ stretch, stretch, stretch };
  within[axis] = 1.0;
  std::fill_n(mesh.Stretch.begin() + first, graph.PointCount(graph.Arcs + loop), within);
}

void FindStretch(const CycleGeometry& geometry, const StackEnds& ends, SurfaceMesh& mesh)
{
  for (Index loop = 0; loop < static_cast<Index>(geometry.Graph.Loops.size()); ++loop)
  {
    StretchLoop(geometry, ends, loop, mesh);
  }
  for (Index point = geometry.Graph.Count(); point < mesh.Corners.PointCount(); ++point)
  {
    Point3 greatest = SurfaceMesh::Unstretched;
    if (mesh.Corners.IsUsed(point))
    {
      mesh.Corners.ForCornersAt(point,
        [&](Index at)
        {
          const Point3& beside = mesh.Stretch[mesh.Corners.VertexOf(CornerTable::Next(at))];
          for (int axis = 0; axis < 3; ++axis)
          {
            greatest[axis] = std::max(greatest[axis], beside[axis]);
          }
        });
    }
    mesh.Stretch[point] = greatest;
  }
}

/// The points of a patch, some of them more than once.
std::vector<Index> ListPointsOf(Index patch, const Patches& patches, const SurfaceMesh& mesh)
{
  std::vector<Index> points;
  for (std::int64_t corner = 3 * patches.Offsets[patch]; corner < 3 * patches.Offsets[patch + 1];
       ++corner)
  {
    points.push_back(mesh.Corners.VertexOf(static_cast<Index>(corner)));
  }
  return points;
}

/// Whether the object ends flat with a patch of an only family, as the patch has it.
bool IsFlat(const std::vector<Index>& points, double spacing, const SurfaceMesh& mesh)
{
  Box3 box;
  for (const Index point : points)
  {
    box.Add(mesh.Points[point]);
  }
  const int axis = mesh.StretchAxis;
  return box.High[axis] - box.Low[axis] < FlatShare * spacing;
}

/// Where the object ends with a flat patch, in a slice or within a rim, the surface has an edge
/// around it, and where walls go on from the last slice to its copy.
void MarkFlatPatches(
  const CycleGeometry& geometry, const Patches& patches, const StackEnds& ends, SurfaceMesh& mesh)
{
  const double spacing = geometry.Grid.MeanSpacing(mesh.StretchAxis);
  const bool hasSpacing = geometry.Grid.Count(mesh.StretchAxis) > 1;
  for (Index patch = 0; patch < geometry.Cycles.Count() && hasSpacing; ++patch)
  {
    const std::vector<Index> points = ListPointsOf(patch, patches, mesh);
    const EndKind kind = ends.OfPatch[patch];
    const Index slab = geometry.Cycles.Cell[patch][mesh.StretchAxis];
    const bool isWall = IsBesideEndSlice(geometry.Grid, mesh.StretchAxis, slab);
    if (isWall ||
      (kind == EndKind::Unknown ? IsFlat(points, spacing, mesh) : kind != EndKind::Dome))
    {
      for (const Index point : points)
      {
        mesh.Crease[point] |= mesh.Fixed[point] ? 1 : 0;
      }
    }
  }
}

/// Where walls go straight on from a slice, the surface has an edge, too.
void MarkWalls(const NodeGraph& graph, const StackEnds& ends, SurfaceMesh& mesh)
{
  for (std::size_t loop = 0; loop < ends.HasWall.size(); ++loop)
  {
    if (ends.HasWall[loop] != 0)
    {
      const Index arc = graph.Arcs + static_cast<Index>(loop);
      std::fill_n(
        mesh.Crease.begin() + graph.FirstPoint(arc), graph.PointCount(arc), std::uint8_t(1));
    }
  }
}

Box3 BoxOfPatch(const DraftMesh& draft, const Patches& patches, Index patch)
{
  Box3 box;
  for (std::int64_t t = patches.Offsets[patch]; t < patches.Offsets[patch + 1]; ++t)
  {
    for (const Index point : draft.Triangles[static_cast<std::size_t>(t)])
    {
      box.Add(draft.Points[point]);
    }
  }
  return box;
}

/// Contours run between patches of different cells.
void MarkContours(SurfaceMesh& mesh)
{
  for (Index corner = 0; corner < mesh.Corners.CornerCount(); ++corner)
  {
    if (mesh.Cell[corner / 3] != mesh.Cell[mesh.Corners.OppositeOf(corner) / 3])
    {
      mesh.Corners.MarkCurve(corner);
    }
  }
}
}

void SplitEdge(Index corner, double share, SurfaceMesh& mesh)
{
  // A thickness changes evenly from one to the other, so that beside thin things little is
  // stretched; the stretch itself is the reciprocal of it.
  const auto between = [share](double start, double end)
  { return 1.0 / ((1.0 - share) / start + share / end); };
  const Index start = mesh.Corners.StartOf(corner);
  const Index end = mesh.Corners.EndOf(corner);
  const Index across = mesh.Corners.OppositeOf(corner);
  const bool isCurve = mesh.Corners.IsCurve(corner);
  mesh.Points.push_back(Between(mesh.Points[start], mesh.Points[end], share));
  const Point3& from = mesh.Stretch[start];
  const Point3& to = mesh.Stretch[end];
  mesh.Stretch.push_back(
    { between(from[0], to[0]), between(from[1], to[1]), between(from[2], to[2]) });
  mesh.Fixed.push_back(isCurve ? 1 : 0);
  mesh.Crease.push_back(mesh.Crease[start] && mesh.Crease[end] && isCurve ? 1 : 0);
  mesh.Cell.push_back(mesh.Cell[corner / 3]);
  mesh.Cell.push_back(mesh.Cell[across / 3]);
  mesh.Corners.Split(corner);
}

SurfaceMesh MakeSurfaceMesh(const CycleGeometry& geometry, const Patches& patches,
  GuideCurves& guides, const Execution& execution)
{
  SurfaceTriangles all = ListTriangles(geometry, patches, execution);
  DraftMesh draft{ std::move(all.Points), std::move(all.Triangles), {} };
  const std::size_t given = draft.Points.size();
  const Index cycles = geometry.Cycles.Count();
  draft.Patch.resize(draft.Triangles.size());
  Box3 contours;
  for (Index point = 0; point < geometry.Graph.Count(); ++point)
  {
    contours.Add(draft.Points[point]);
  }
  const Box3 guided = BoxOf(guides);
  std::vector<Box3> cells;
  for (Index cycle = 0; cycle < cycles; ++cycle)
  {
    cells.push_back(BoundCell(geometry.Grid, contours, guided, geometry.Cycles.Cell[cycle]));
    if (CountFamilies(geometry.Grid) == 2)
    {
      BoundAlongMissingAxis(geometry.Grid, BoxOfPatch(draft, patches, cycle), cells.back());
    }
    std::fill(draft.Patch.begin() + patches.Offsets[cycle],
      draft.Patch.begin() + patches.Offsets[cycle + 1], cycle);
  }
  for (Index cycle = 0; cycle < cycles; ++cycle)
  {
    cells.push_back(cells[cycle]); // of the wall of its rim
  }
  const int axis = FindOnlyFamily(geometry.Grid);
  const StackEnds ends = axis >= 0 ? RaiseEnds(geometry, patches, guides, draft) : StackEnds();
  const std::size_t count = draft.Points.size();
  SurfaceMesh mesh{ CornerTable(static_cast<Index>(count), draft.Triangles),
    std::move(draft.Points), {}, std::vector<std::uint8_t>(count, 0), std::move(draft.Patch),
    std::move(cells), geometry.Grid.Metric, axis,
    std::vector<Point3>(count, SurfaceMesh::Unstretched) };
  mesh.Fixed.assign(count, 0);
  std::fill_n(mesh.Fixed.begin(), geometry.Graph.Count(), std::uint8_t(1));
  std::fill(
    mesh.Fixed.begin() + static_cast<std::ptrdiff_t>(given), mesh.Fixed.end(), std::uint8_t(1));
  MarkContours(mesh);
  mesh.Levels = ends.Levels;
  if (axis >= 0)
  {
    MarkWalls(geometry.Graph, ends, mesh);
    MarkFlatPatches(geometry, patches, ends, mesh);
  }
  if (axis >= 0 || (mesh.Metric.IsWorld() && CountFamilies(geometry.Grid) == 2))
  {
    FindStretch(geometry, ends, mesh);
  }
  return mesh;
}
}
