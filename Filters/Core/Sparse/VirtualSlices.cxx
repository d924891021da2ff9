// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/VirtualSlices.h"

#include "Core/Slicing/SliceSurface.h"
#include "Core/Sparse/CreaseCurves.h"
#include "Core/Sparse/FairSurface.h"
#include "Core/Sparse/GuideSurface.h"
#include "Core/Sparse/RemeshSurface.h"
#include "Core/Sparse/SubdivideSurface.h"
#include "Core/Sparse/ThinContours.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace orthoslices
{
namespace
{
/// A piece of a guide is taken for a part of the surface if its ends are within that, in edges, of
/// those of the part: slices that contradict each other by more say nothing.
constexpr double ReachOfGuides = 3.0;

using Steps = std::vector<std::function<void()>>;

/// Runs one step after another. False if stopped.
bool RunSteps(const Steps& steps, const Execution& execution)
{
  double done = 0.0;
  for (const auto& step : steps)
  {
    if (!execution.Continue(done / static_cast<double>(steps.size())))
    {
      return false;
    }
    step();
    done += 1.0;
  }
  return execution.Continue(1.0);
}

/// Makes the surface a mesh of equal triangles, bent as little as possible. False if stopped.
bool MakeFair(
  GuideCurves& guides, const SliceDensity& density, const Execution& execution, SurfaceMesh& mesh)
{
  const double edgeLength = density.EdgeLength();
  const auto collapse = [&] { CollapseShortEdges(edgeLength, mesh); };
  const auto flip = [&] { FlipEdges(mesh); };
  const auto split = [&] { SplitLongEdges(edgeLength, mesh); };
  const auto bend = [&] { FairSurface(EdgeWeights::Uniform, mesh); };
  // The contours of one family do not show what is round, and its mesh is stretched where it is
  // thin.
  const EdgeWeights shown =
    mesh.StretchAxis < 0 ? EdgeWeights::RoundCotangents : EdgeWeights::Cotangents;
  const auto bendAgain = [&] { FairSurface(shown, mesh); };
  const auto crease = [&] { DrawCreases(mesh); };
  Steps steps{ collapse, flip, [&] { RefineEdges(edgeLength, mesh); }, collapse, crease, bend };
  if (!guides.Slices.empty())
  {
    const auto guide = [&]
    { GuideSurface(guides, ReachOfGuides * edgeLength, 0.5 * edgeLength, mesh); };
    steps.insert(steps.end(), { guide, bend, split, collapse, flip, bend });
  }
  // What was bent without knowing its shape has to be meshed anew, and so has what guides have
  // moved.
  const int rounds = guides.Slices.empty() ? density.Rounds() : 2;
  for (int round = 0; round < rounds; ++round)
  {
    steps.insert(steps.end(), { split, collapse, flip, bendAgain });
  }
  return RunSteps(steps, execution);
}

/// Vertices closer than that to the line through the others show no shape, as a share of the least
/// distance of planes: the surface itself is not known to more than ten times that.
constexpr double ThinTolerance = 0.003;

/// The planes of an axis, ascending: those of the grid and the virtual ones.
std::vector<double> MergePlanes(const std::vector<double>& some, const std::vector<double>& others)
{
  std::vector<double> planes(some.size() + others.size());
  std::merge(some.begin(), some.end(), others.begin(), others.end(), planes.begin());
  return planes;
}

/// Where points may lie along an axis: patches need room beyond the contours, but must not leave
/// the bounds of the real ones. Beyond slices that were added at the ends, half of the room there
/// is.
std::array<double, 2> RangeWithin(const SpatialGrid& grid, int axis)
{
  const double room = 0.02 * grid.SpacingAtEnds[axis];
  std::array<double, 2> rooms{ room, room };
  if (grid.HasVirtual() && grid.Count(axis) > 0)
  {
    rooms[0] = std::min(room, 0.5 * (grid.Planes[axis].front() - grid.Lowest[axis]));
    rooms[1] = std::min(room, 0.5 * (grid.Highest[axis] - grid.Planes[axis].back()));
  }
  return { grid.Lowest[axis] + rooms[0], grid.Highest[axis] - rooms[1] };
}

void KeepWithin(const SpatialGrid& grid, std::vector<Point3>& points)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [low, high] = RangeWithin(grid, axis);
    for (Point3& point : points)
    {
      point[axis] = grid.Round(std::max(low, std::min(high, point[axis])));
    }
  }
}

/// Slices of walls that end between two of a stack, near their rims.
void AddLevels(const SurfaceMesh& mesh, const SpatialGrid& grid, VirtualPlanes& planes)
{
  if (mesh.StretchAxis < 0)
  {
    return;
  }
  std::vector<double>& ofStack = planes[mesh.StretchAxis];
  for (const double level : mesh.Levels)
  {
    ofStack.push_back(grid.Round(level));
  }
  std::sort(ofStack.begin(), ofStack.end());
  ofStack.erase(std::unique(ofStack.begin(), ofStack.end()), ofStack.end());
}

Box3 BoxOf(const TriangleSurface& surface)
{
  Box3 box;
  for (const auto& triangle : surface.Triangles)
  {
    for (const Index point : triangle)
    {
      box.Add(surface.Points[point]);
    }
  }
  return box;
}
}

void AppendSlice(const PlaneContours& drawn, int axis, double coordinate, Contours& contours)
{
  const Index first = static_cast<Index>(contours.U.size());
  contours.U.insert(contours.U.end(), drawn.U.begin(), drawn.U.end());
  contours.V.insert(contours.V.end(), drawn.V.begin(), drawn.V.end());
  for (Index i = 0; i < drawn.Count(); ++i)
  {
    contours.Offsets.push_back(first + drawn.Offsets[i + 1]);
    contours.Axis.push_back(static_cast<std::int8_t>(axis));
    contours.Coordinate.push_back(coordinate);
    contours.Plane.push_back(-1); // of a grid that is not made yet
    contours.Cell.push_back(-1);
    contours.Virtual.push_back(1);
  }
}

Contours MakeVirtualSlices(
  const FairSource& source, const SliceDensity& density, const Execution& execution)
{
  Contours contours;
  GuideCurves& guides = source.Guides;
  SurfaceMesh mesh = MakeSurfaceMesh(source.Geometry, source.Surface, guides, execution);
  if (source.IsBent)
  {
    KeepCorners(FindContourCorners(source.Geometry, source.CornerAngle), mesh);
    if (!MakeFair(guides, density, execution, mesh))
    {
      return contours;
    }
  }
  TriangleSurface surface = source.IsBent
    ? SubdivideSurface(mesh)
    : TriangleSurface{ mesh.Points, mesh.Corners.ListTriangles(), {} };
  if (CloseSurface(surface).Kind != SurfaceProblemKind::None)
  {
    return contours; // not reached: collapses, flips and splits keep it closed
  }
  const SpatialGrid& grid = source.Grid;
  KeepWithin(grid, surface.Points);
  const Precision precision = grid.SinglePrecision ? Precision::Single : Precision::Double;
  VirtualPlanes planes =
    source.Planes != nullptr ? *source.Planes : ChooseVirtualPlanes(grid, BoxOf(surface), density);
  if (source.Planes == nullptr)
  {
    AddLevels(mesh, grid, planes);
  }
  const double tolerance =
    ThinTolerance * std::min({ density.Spacing(0), density.Spacing(1), density.Spacing(2) });
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<PlaneContours> slices =
      SliceSurface(surface, axis, planes[axis], precision, execution);
    const auto planesU = MergePlanes(grid.Planes[FirstAxis(axis)], planes[FirstAxis(axis)]);
    const auto planesV = MergePlanes(grid.Planes[SecondAxis(axis)], planes[SecondAxis(axis)]);
    execution.For(slices.size(),
      [&](std::size_t begin, std::size_t end)
      {
        ContourThinner thinner(tolerance, planesU, planesV);
        for (std::size_t i = begin; i < end; ++i)
        {
          slices[i] = thinner.Run(slices[i]);
        }
      });
    for (std::size_t i = 0; i < slices.size(); ++i)
    {
      AppendSlice(slices[i], axis, planes[axis][i], contours);
    }
  }
  return contours;
}
}
