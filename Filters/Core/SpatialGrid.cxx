// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpatialGrid.h"

#include <numeric>

namespace orthoslices
{
GridEdgeCode::GridEdgeCode(const SpatialGrid& grid)
{
  std::uint64_t base = 0;
  for (int t = 0; t < 3; ++t)
  {
    this->Count[t] = grid.Planes[t].size();
  }
  for (int t = 0; t < 3; ++t)
  {
    this->Base[t] = base;
    base += this->Count[FirstAxis(t)] * this->Count[SecondAxis(t)] * (this->Count[t] + 1);
  }
}

GridEdge GridEdgeCode::Decode(std::uint64_t code) const
{
  const int t = code >= this->Base[2] ? 2 : code >= this->Base[1] ? 1 : 0;
  code -= this->Base[t];
  const std::uint64_t slabs = this->Count[t] + 1;
  const std::uint64_t line = code / slabs;
  const std::uint64_t seconds = this->Count[SecondAxis(t)];
  return { t, static_cast<Index>(line / seconds), static_cast<Index>(line % seconds),
    static_cast<Index>(code % slabs) };
}

namespace
{
/// Contours [first, last) of the sorted list become one plane.
void MergePlane(Contours& contours, const std::vector<Index>& order, std::size_t first,
  std::size_t last, std::vector<double>& planes)
{
  const double coordinate = contours.Coordinate[order[first + (last - first) / 2]];
  for (std::size_t i = first; i < last; ++i)
  {
    contours.Coordinate[order[i]] = coordinate;
    contours.Plane[order[i]] = static_cast<Index>(planes.size());
  }
  planes.push_back(coordinate);
}
}

SpatialGrid BuildSpatialGrid(Contours& contours, double tolerance)
{
  SpatialGrid grid;
  contours.Plane.assign(contours.Count(), 0);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<Index> order;
    for (Index i = 0; i < contours.Count(); ++i)
    {
      if (contours.Axis[i] == axis)
      {
        order.push_back(i);
      }
    }
    std::stable_sort(order.begin(), order.end(),
      [&](Index a, Index b) { return contours.Coordinate[a] < contours.Coordinate[b]; });
    std::size_t first = 0;
    for (std::size_t i = 1; i <= order.size(); ++i)
    {
      if (i == order.size() ||
        contours.Coordinate[order[i]] - contours.Coordinate[order[first]] > tolerance)
      {
        MergePlane(contours, order, first, i, grid.Planes[axis]);
        first = i;
      }
    }
  }
  return grid;
}
}
