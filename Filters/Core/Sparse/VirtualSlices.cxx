// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/VirtualSlices.h"

#include "Core/Slicing/SliceSurface.h"
#include "Core/Sparse/FairSurface.h"
#include "Core/Sparse/GuideSurface.h"
#include "Core/Sparse/RemeshSurface.h"
#include "Core/Sparse/SubdivideSurface.h"
#include "Core/Sparse/ThinContours.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace orthoslices
{
namespace
{
/// Surfaces that are farther from a guide, in edges, are taken for others.
constexpr double ReachOfGuides = 3.0;

/// Makes the surface a mesh of equal triangles, bent as little as possible. False if stopped.
bool MakeFair(const std::vector<Point3>& guides, double edgeLength, const Execution& execution,
  SurfaceMesh& mesh)
{
  const std::function<void()> steps[] = {
    [&] { CollapseShortEdges(edgeLength, mesh); },
    [&] { FlipEdges(mesh); },
    [&] { RefineEdges(edgeLength, mesh); },
    [&] { CollapseShortEdges(edgeLength, mesh); },
    [&] { FairSurface(EdgeWeights::Uniform, mesh); },
    [&] { GuideSurface(guides, ReachOfGuides * edgeLength, mesh); },
    [&] { SplitLongEdges(edgeLength, mesh); },
    [&] { CollapseShortEdges(edgeLength, mesh); },
    [&] { FlipEdges(mesh); },
    [&] { FairSurface(EdgeWeights::Cotangents, mesh); },
  };
  double done = 0.0;
  for (const auto& step : steps)
  {
    if (!execution.Continue(done / static_cast<double>(std::size(steps))))
    {
      return false;
    }
    step();
    done += 1.0;
  }
  return execution.Continue(1.0);
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

void Append(const PlaneContours& drawn, int axis, double coordinate, Contours& contours)
{
  const Index first = static_cast<Index>(contours.U.size());
  contours.U.insert(contours.U.end(), drawn.U.begin(), drawn.U.end());
  contours.V.insert(contours.V.end(), drawn.V.begin(), drawn.V.end());
  for (Index i = 0; i < drawn.Count(); ++i)
  {
    contours.Offsets.push_back(first + drawn.Offsets[i + 1]);
    contours.Axis.push_back(static_cast<std::int8_t>(axis));
    contours.Coordinate.push_back(coordinate);
    contours.Cell.push_back(-1);
    contours.Virtual.push_back(1);
  }
}

/// Patches need room beyond the contours, but must not leave the bounds of the real ones.
void KeepWithin(const SpatialGrid& grid, std::vector<Point3>& points)
{
  for (Point3& point : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double room = 0.02 * grid.SpacingAtEnds[axis];
      point[axis] = grid.Round(
        std::max(grid.Lowest[axis] + room, std::min(grid.Highest[axis] - room, point[axis])));
    }
  }
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

Contours MakeVirtualSlices(
  const FairSource& source, const SliceDensity& density, const Execution& execution)
{
  Contours contours;
  SurfaceMesh mesh = MakeSurfaceMesh(source.Geometry, source.Surface, execution);
  if (!MakeFair(source.Guides, density.EdgeLength(), execution, mesh))
  {
    return contours;
  }
  TriangleSurface surface = SubdivideSurface(mesh);
  if (CloseSurface(surface).Kind != SurfaceProblemKind::None)
  {
    return contours; // not reached: collapses, flips and splits keep it closed
  }
  const SpatialGrid& grid = source.Grid;
  KeepWithin(grid, surface.Points);
  const Precision precision = grid.SinglePrecision ? Precision::Single : Precision::Double;
  const VirtualPlanes planes = ChooseVirtualPlanes(grid, BoxOf(surface), density);
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
      Append(slices[i], axis, planes[axis][i], contours);
    }
  }
  return contours;
}
}
