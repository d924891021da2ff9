// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/BorderCaps.h"

#include "Core/MakeSurface.h"
#include "Core/Slices/BorderSlices.h"
#include "Core/Slices/EndSlices.h"
#include "Core/Slicing/SliceSurface.h"
#include "Core/Sparse/SurfaceMesh.h"
#include "Core/Sparse/VirtualSlices.h"

#include <cmath>
#include <utility>

namespace orthoslices
{
namespace
{
/// A side of the border along which contours were closed.
struct BorderSide
{
  int Axis;
  double Coordinate;
};

/// The border as the vertices of contours have it.
Box3 RoundedBorder(const Pass& pass)
{
  Box3 border = pass.Tables.Border;
  const SpatialGrid& grid = pass.Result.Grid;
  for (int axis = 0; axis < 3 && grid.Quantum > 0.0; ++axis)
  {
    border.Low[axis] = grid.Round(border.Low[axis]);
    border.High[axis] = grid.Round(border.High[axis]);
  }
  return border;
}

/// The finite sides; none if they are no values of the precision, if a slice lies on one of them,
/// or nearly so, or if a side has no slices beside it that lie as it does: one alone would cut the
/// object into cells that are far too long.
std::vector<BorderSide> ListSides(const Box3& border, const SpatialGrid& grid)
{
  std::vector<BorderSide> sides;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double room = 4.0 * RoomBeyondEnd(grid, axis);
    for (const double side : { border.Low[axis], border.High[axis] })
    {
      for (const double plane : grid.Planes[axis])
      {
        if (std::abs(plane - side) < room)
        {
          return {};
        }
      }
      if (std::isfinite(side))
      {
        if (grid.Count(axis) < 2 || grid.Round(side) != side)
        {
          return {};
        }
        sides.push_back({ axis, side });
      }
    }
  }
  return sides;
}

/// Whether a section keeps within the other sides of the border.
bool IsWithin(const PlaneContours& section, int axis, const Box3& border)
{
  const int u = FirstAxis(axis), v = SecondAxis(axis);
  for (std::size_t i = 0; i < section.U.size(); ++i)
  {
    if (section.U[i] < border.Low[u] || section.U[i] > border.High[u] ||
      section.V[i] < border.Low[v] || section.V[i] > border.High[v])
    {
      return false;
    }
  }
  return true;
}

/// The sections of a surface at the sides; none if one of them reaches beyond another side.
Contours CutAtSides(const Reconstruction& sketch, const std::vector<BorderSide>& sides,
  const Box3& border, const Execution& execution)
{
  Contours cuts;
  GuideCurves none;
  const SurfaceMesh mesh = MakeSurfaceMesh(GeometryOf(sketch), sketch.Surface, none, execution);
  TriangleSurface surface{ mesh.Points, mesh.Corners.ListTriangles(), {} };
  if (CloseSurface(surface).Kind != SurfaceProblemKind::None)
  {
    return cuts;
  }
  const SpatialGrid& grid = sketch.Grid;
  for (const BorderSide& side : sides)
  {
    const double plane = grid.Round(side.Coordinate);
    const PlaneContours section = SliceSurface(surface, side.Axis, { plane },
      grid.SinglePrecision ? Precision::Single : Precision::Double, execution)[0];
    if (!IsWithin(section, side.Axis, border))
    {
      return Contours();
    }
    AppendSlice(section, side.Axis, plane, cuts);
  }
  return cuts;
}
}

bool AddBorderSlices(Pass& pass)
{
  const Box3 border = RoundedBorder(pass);
  const std::vector<BorderSide> sides = ListSides(border, pass.Result.Grid);
  if (sides.empty() || pass.Settings.Smoothing > 0.0 || pass.Settings.Patching.Shared != nullptr ||
    pass.Result.InsideOut || pass.Result.Grid.HasVirtual())
  {
    return true;
  }
  const Point3 spacing = pass.Result.Grid.SpacingAtEnds;
  const Box3 given = std::exchange(pass.Tables.Border, Everywhere());
  Pass sketch(pass, ContinueBeyond(pass.Tables.Contours, border, spacing));
  pass.Tables.Border = given;
  sketch.SetShare(0.04, 0.5);
  sketch.Settings.Patching.Accuracy = 0.0; // its contours are cut
  sketch.Settings.Patching.OwnAccuracy = false;
  if (!ConnectContours(sketch) || !FillCycles(sketch.Settings.Patching, sketch))
  {
    pass.Result.Stopped = true;
    return false;
  }
  const Contours cuts = CutAtSides(sketch.Result, sides, border, pass.Execute);
  if (cuts.Count() > 0)
  {
    // Contours that are moved out must not widen the bounds elsewhere.
    const SpatialGrid& grid = pass.Result.Grid;
    Box3 bounds{ grid.Lowest, grid.Highest };
    Point3 beyond;
    for (int axis = 0; axis < 3; ++axis)
    {
      beyond[axis] = RoomBeyondEnd(grid, axis);
      const bool hasLow = std::isfinite(border.Low[axis]);
      const bool hasHigh = std::isfinite(border.High[axis]);
      bounds.Low[axis] = hasLow ? border.Low[axis] - 2.0 * beyond[axis] : bounds.Low[axis];
      bounds.High[axis] = hasHigh ? border.High[axis] + 2.0 * beyond[axis] : bounds.High[axis];
    }
    pass.Tables.Contours = ContinueBeyond(pass.Tables.Contours, border, beyond);
    pass.AddVirtualSlices(cuts, bounds);
  }
  pass.SetShare(0.5, 1.0);
  return true;
}
}
