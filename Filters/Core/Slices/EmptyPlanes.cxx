// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/EmptyPlanes.h"

#include "Core/Base/EditContours.h"

#include <algorithm>
#include <iterator>

namespace orthoslices
{
namespace
{
/// Where contours of other axes are along an axis: ranges, ascending by their lower ends.
std::vector<std::array<double, 2>> RangesAlong(int axis, const Contours& contours)
{
  std::vector<std::array<double, 2>> ranges;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    if (contours.Axis[contour] == axis)
    {
      continue;
    }
    const auto& along = FirstAxis(contours.Axis[contour]) == axis ? contours.U : contours.V;
    const auto ends = std::minmax_element(
      along.begin() + contours.Offsets[contour], along.begin() + contours.Offsets[contour + 1]);
    ranges.push_back({ *ends.first, *ends.second });
  }
  std::sort(ranges.begin(), ranges.end());
  return ranges;
}

/// The planes of an axis that can be added.
std::vector<double> ChoosePlanes(int axis, const std::vector<double>& planes, EmptyPlanes which,
  const Contours& contours, const SpatialGrid& grid)
{
  const std::vector<double>& own = grid.Planes[axis];
  std::vector<double> others, chosen;
  std::set_difference(
    planes.begin(), planes.end(), own.begin(), own.end(), std::back_inserter(others));
  const Box3 box = BoxOf(contours);
  const auto above = std::upper_bound(others.begin(), others.end(), box.High[axis]);
  const auto inside = std::lower_bound(others.begin(), others.end(), box.Low[axis]);
  if (inside != others.begin())
  {
    chosen.push_back(*(inside - 1));
  }
  const std::vector<std::array<double, 2>> ranges =
    grid.HasVirtual() ? std::vector<std::array<double, 2>>() : RangesAlong(axis, contours);
  const bool all = grid.HasVirtual() || (which == EmptyPlanes::All && !ranges.empty());
  if (all)
  {
    chosen.insert(chosen.end(), inside, above);
  }
  std::size_t next = 0;
  double end = -HUGE_VAL; // of the ranges that begin below a plane
  for (auto plane = inside; plane != above && !all && !ranges.empty(); ++plane)
  {
    for (; next < ranges.size() && ranges[next][0] < *plane; ++next)
    {
      end = std::max(end, ranges[next][1]);
    }
    if (end < *plane)
    {
      chosen.push_back(*plane);
    }
  }
  if (above != others.end())
  {
    chosen.push_back(*above);
  }
  return chosen;
}
}

void AddEmptyPlanes(const std::array<std::vector<double>, 3>& planes, EmptyPlanes which,
  Contours& contours, SpatialGrid& grid)
{
  const bool hasVirtual = grid.HasVirtual();
  std::array<std::vector<double>, 3> added;
  for (int axis = 0; axis < 3; ++axis)
  {
    added[axis] = ChoosePlanes(axis, planes[axis], which, contours, grid);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double plane : added[axis])
    {
      std::vector<double>& own = grid.Planes[axis];
      const auto place = std::lower_bound(own.begin(), own.end(), plane);
      if (hasVirtual)
      {
        grid.Virtual[axis].insert(
          grid.Virtual[axis].begin() + (place - own.begin()), std::uint8_t(1));
      }
      own.insert(place, plane);
    }
  }
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    const std::vector<double>& own = grid.Planes[contours.Axis[contour]];
    contours.Plane[contour] = static_cast<Index>(
      std::lower_bound(own.begin(), own.end(), contours.Coordinate[contour]) - own.begin());
  }
}
}
