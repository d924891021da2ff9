// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/EndSlices.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Room between a copy and the bound, as a share of SpacingAtEnds: as far from their slice as
/// central points of flat ends are (CentralPointMargin), so that these lie on the bound.
constexpr double RoomShare = 1e-3;

/// And in steps of the precision, as planes are apart at least.
constexpr double RoomSteps = 256.0;

/// A copy is farther from its slice than so many times the room beyond it.
constexpr double MinRooms = 4.0;

/// Copies the contours of one plane to another coordinate.
void CopyPlane(const Contours& contours, Index plane, double coordinate, Contours& copies)
{
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    if (contours.Plane[contour] != plane)
    {
      continue;
    }
    const auto begin = contours.Offsets[contour], end = contours.Offsets[contour + 1];
    copies.U.insert(copies.U.end(), contours.U.begin() + begin, contours.U.begin() + end);
    copies.V.insert(copies.V.end(), contours.V.begin() + begin, contours.V.begin() + end);
    copies.Offsets.push_back(static_cast<Index>(copies.U.size()));
    copies.Axis.push_back(contours.Axis[contour]);
    copies.Coordinate.push_back(coordinate);
    copies.Plane.push_back(-1);
    copies.Cell.push_back(-1);
  }
}
}

EndSlices CopyEndSlices(const Contours& contours, const SpatialGrid& grid, double tolerance)
{
  EndSlices ends;
  const int axis = FindOnlyFamily(grid);
  if (axis < 0 || grid.HasVirtual())
  {
    return ends;
  }
  const std::vector<double>& planes = grid.Planes[axis];
  const Index last = grid.Count(axis) - 1;
  const double spacing = grid.SpacingAtEnds[axis];
  const double room = RoomBeyondEnd(grid, axis);
  const auto halfOf = [&](Index one, Index other)
  { return 0.5 * (last > 0 ? std::min(planes[other] - planes[one], spacing) : spacing); };
  const auto mayAdd = [&](double distance)
  { return distance - room > std::max(MinRooms * room, tolerance); };
  const double low = std::max(grid.Lowest[axis], planes[0] - halfOf(0, 1));
  const double high = std::min(grid.Highest[axis], planes[last] + halfOf(last - 1, last));
  if (mayAdd(planes[0] - low))
  {
    ends.Bounds.Low[axis] = low;
    CopyPlane(contours, 0, low + room, ends.Copies);
  }
  if (mayAdd(high - planes[last]))
  {
    ends.Bounds.High[axis] = high;
    CopyPlane(contours, last, high - room, ends.Copies);
  }
  return ends;
}

double RoomBeyondEnd(const SpatialGrid& grid, int axis)
{
  return std::max(RoomShare * grid.SpacingAtEnds[axis], RoomSteps * grid.Step[axis]);
}

void LimitBoundsTo(const Box3& bounds, SpatialGrid& grid)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Lowest[axis] = std::max(grid.Lowest[axis], grid.Round(bounds.Low[axis]));
    grid.Highest[axis] = std::min(grid.Highest[axis], grid.Round(bounds.High[axis]));
  }
}

bool IsBesideEndSlice(const SpatialGrid& grid, int axis, Index slab)
{
  const Index last = grid.Count(axis) - 1;
  return slab > 0 && slab <= last &&
    ((slab == 1 && grid.IsVirtual(axis, 0)) || (slab == last && grid.IsVirtual(axis, last)));
}
}
