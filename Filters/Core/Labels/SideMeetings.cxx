// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/SideMeetings.h"

#include "Core/Labels/PieceMeetings.h"
#include "Core/Labels/SliceMembers.h"

#include <algorithm>
#include <tuple>

namespace orthoslices
{
namespace
{
/// Moves a contour that is within one face off its border.
void MoveInsideFace(const SpatialGrid& grid, int axis, std::vector<Point2>& polygon)
{
  const std::array<int, 2> axes{ FirstAxis(axis), SecondAxis(axis) };
  std::array<Index, 2> slabs;
  for (int i = 0; i < 2; ++i)
  {
    const auto [low, high] = std::minmax_element(polygon.begin(), polygon.end(),
      [i](const Point2& a, const Point2& b) { return a[i] < b[i]; });
    slabs[i] = grid.Slab(axes[i], (*low)[i]);
    if (grid.Slab(axes[i], (*high)[i]) != slabs[i])
    {
      return;
    }
  }
  for (Point2& vertex : polygon)
  {
    for (int i = 0; i < 2; ++i)
    {
      vertex[i] = grid.MoveInside(axes[i], slabs[i], vertex[i]);
    }
  }
}

/// Adds the sides of a contour, each from its lesser end.
void AddSides(
  const SpatialGrid& grid, const Contours& contours, Index contour, std::vector<PieceSide>& sides)
{
  const int axis = contours.Axis[contour];
  std::vector<Point2> polygon = PolygonOf(contours, contour);
  MoveInsideFace(grid, axis, polygon);
  const Point2* before = &polygon.back();
  for (const Point2& vertex : polygon)
  {
    if (vertex != *before)
    {
      const auto [from, to] = std::minmax(*before, vertex);
      sides.push_back({ axis, contours.Coordinate[contour], from, to, 0 });
    }
    before = &vertex;
  }
}

auto KeyOf(const PieceSide& side)
{
  return std::tie(side.Axis, side.Coordinate, side.From, side.To);
}
}

bool DoSidesMeet(const SpatialGrid& grid, const std::vector<Contours>& structures)
{
  std::vector<PieceSide> sides;
  for (const Contours& contours : structures)
  {
    for (Index contour = 0; contour < contours.Count(); ++contour)
    {
      AddSides(grid, contours, contour, sides);
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const PieceSide& a, const PieceSide& b) { return KeyOf(a) < KeyOf(b); });
  sides.erase(std::unique(sides.begin(), sides.end(),
                [](const PieceSide& a, const PieceSide& b) { return KeyOf(a) == KeyOf(b); }),
    sides.end());
  return !FindMeetings(sides).empty();
}
}
