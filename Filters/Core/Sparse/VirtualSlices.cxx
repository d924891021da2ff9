// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/VirtualSlices.h"

#include "Core/Slicing/SliceSurface.h"
#include "Core/Sparse/FairSurface.h"
#include "Core/Sparse/RemeshSurface.h"
#include "Core/Sparse/SubdivideSurface.h"

#include <algorithm>
#include <utility>

namespace orthoslices
{
namespace
{
/// The surface as a mesh of equal triangles, bent as little as possible.
SurfaceMesh MakeFairSurface(const CycleGeometry& geometry, const Patches& patches,
  double edgeLength, const Execution& execution)
{
  SurfaceMesh mesh = MakeSurfaceMesh(geometry, patches, execution);
  CollapseShortEdges(edgeLength, mesh);
  FlipEdges(mesh);
  RefineEdges(edgeLength, mesh);
  CollapseShortEdges(edgeLength, mesh);
  FairSurface(EdgeWeights::Uniform, mesh);
  SplitLongEdges(edgeLength, mesh);
  CollapseShortEdges(edgeLength, mesh);
  FlipEdges(mesh);
  FairSurface(EdgeWeights::Cotangents, mesh);
  return mesh;
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
}

Contours MakeVirtualSlices(const CycleGeometry& geometry, const Patches& patches,
  const SliceDensity& density, const Execution& execution)
{
  Contours contours;
  const SurfaceMesh mesh = MakeFairSurface(geometry, patches, density.EdgeLength(), execution);
  TriangleSurface surface = SubdivideSurface(mesh);
  if (CloseSurface(surface).Kind != SurfaceProblemKind::None)
  {
    return contours; // not reached: collapses, flips and splits keep it closed
  }
  const SpatialGrid& grid = geometry.Grid;
  for (Point3& point : surface.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      // Patches need room beyond the contours, but must not leave the bounds of the real ones.
      const double room = 0.02 * grid.SpacingAtEnds[axis];
      point[axis] = grid.Round(
        std::max(grid.Lowest[axis] + room, std::min(grid.Highest[axis] - room, point[axis])));
    }
  }
  Box3 box;
  for (const auto& triangle : surface.Triangles)
  {
    for (const Index point : triangle)
    {
      box.Add(surface.Points[point]);
    }
  }
  const Precision precision = grid.SinglePrecision ? Precision::Single : Precision::Double;
  const VirtualPlanes planes = ChooseVirtualPlanes(grid, box, density);
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<PlaneContours> slices =
      SliceSurface(surface, axis, planes[axis], precision, execution);
    for (std::size_t i = 0; i < slices.size(); ++i)
    {
      Append(slices[i], axis, planes[axis][i], contours);
    }
  }
  return contours;
}
}
