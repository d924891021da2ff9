// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/SpatialGrid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace orthoslices
{
double SpatialGrid::Margin(int axis, Index slab) const
{
  // A millionth of the slab is far below the detail of any contour and far above rounding: 16 steps
  // of the rounded coordinates, if these are coarse. An eighth of the slab leaves room inside.
  constexpr double share = 1e-6;
  const auto& planes = this->Planes[axis];
  const bool bounded = slab > 0 && slab < this->Count(axis);
  const double width = bounded ? planes[slab] - planes[slab - 1] : this->MeanSpacing(axis);
  const double margin = std::max(share * width, 16.0 * this->Step[axis]);
  return bounded ? std::min(margin, 0.125 * width) : margin;
}

double SpatialGrid::MoveInside(int axis, Index slab, double coordinate, double share) const
{
  const auto& planes = this->Planes[axis];
  const bool below = slab > 0;
  const bool above = slab < this->Count(axis);
  const double width = below && above ? planes[slab] - planes[slab - 1] : this->MeanSpacing(axis);
  const double margin = std::max(this->Margin(axis, slab), share * width);
  coordinate = below ? std::max(coordinate, planes[slab - 1] + margin) : coordinate;
  coordinate = above ? std::min(coordinate, planes[slab] - margin) : coordinate;
  return this->Round(coordinate);
}

void SpatialGrid::GetExtent(
  int axis, Index slab, double minimum, double maximum, double& low, double& high) const
{
  const auto& planes = this->Planes[axis];
  double beyond = std::max(this->MeanSpacing(axis), maximum - minimum);
  if (!(beyond > 0.0))
  {
    beyond = std::max(std::abs(maximum), 1.0);
  }
  low = slab > 0 ? planes[slab - 1] : this->Round(minimum - beyond);
  high = slab < this->Count(axis) ? planes[slab] : this->Round(maximum + beyond);
}

double MinMeanSpacing(const SpatialGrid& grid)
{
  double minimum = HUGE_VAL;
  for (int axis = 0; axis < 3; ++axis)
  {
    minimum = grid.Count(axis) > 1 ? std::min(minimum, grid.MeanSpacing(axis)) : minimum;
  }
  return std::isfinite(minimum) ? minimum : grid.MeanSpacing(0);
}

double MeanSpacingInSlices(const SpatialGrid& grid, int axis)
{
  double minimum = HUGE_VAL;
  for (const int other : { FirstAxis(axis), SecondAxis(axis) })
  {
    minimum = grid.Count(other) > 1 ? std::min(minimum, grid.MeanSpacing(other)) : minimum;
  }
  return std::isfinite(minimum) ? minimum : MinMeanSpacing(grid);
}

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
  std::size_t last, int axis, SpatialGrid& grid)
{
  std::vector<double>& planes = grid.Planes[axis];
  std::vector<Index> real;
  std::copy_if(order.begin() + first, order.begin() + last, std::back_inserter(real),
    [&](Index contour) { return !contours.IsVirtual(contour); });
  const Index median = real.empty() ? order[first + (last - first) / 2] : real[real.size() / 2];
  const double coordinate = grid.Round(contours.Coordinate[median]);
  for (std::size_t i = first; i < last; ++i)
  {
    contours.Coordinate[order[i]] = coordinate;
    contours.Plane[order[i]] = static_cast<Index>(planes.size());
  }
  planes.push_back(coordinate);
  grid.Virtual[axis].push_back(real.empty() ? 1 : 0);
}

/// No flags say the same as flags of nothing but real planes.
void DropFlagsOfReal(SpatialGrid& grid)
{
  for (const auto& flags : grid.Virtual)
  {
    if (std::find(flags.begin(), flags.end(), 1) != flags.end())
    {
      return;
    }
  }
  grid.Virtual = {};
}
}

namespace
{
/// Sets the steps of the precision and the extents from the coordinates of all contours.
void FindExtent(const Contours& contours, SpatialGrid& grid)
{
  Point3 low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  const auto extend = [&](int axis, double x)
  {
    low[axis] = std::min(low[axis], x);
    high[axis] = std::max(high[axis], x);
  };
  for (Index i = 0; i < contours.Count(); ++i)
  {
    const int axis = contours.Axis[i];
    extend(axis, contours.Coordinate[i]);
    for (Index v = contours.Offsets[i]; v < contours.Offsets[i + 1]; ++v)
    {
      extend(FirstAxis(axis), contours.U[v]);
      extend(SecondAxis(axis), contours.V[v]);
    }
  }
  const double epsilon = grid.SinglePrecision ? std::numeric_limits<float>::epsilon()
                                              : std::numeric_limits<double>::epsilon();
  double longest = 0.0;
  for (int axis = 0; axis < 3 && contours.Count() > 0; ++axis)
  {
    grid.Step[axis] = epsilon * std::max(std::abs(low[axis]), std::abs(high[axis]));
    grid.Extent[axis] = high[axis] - low[axis];
    longest = std::max(longest, grid.Extent[axis]);
  }
  for (double& extent : grid.Extent)
  {
    extent = extent > 0.0 ? extent : longest;
  }
}
}

SpatialGrid BuildSpatialGrid(Contours& contours, double tolerance, bool singlePrecision)
{
  SpatialGrid grid;
  grid.SinglePrecision = singlePrecision;
  FindExtent(contours, grid);
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
    const double reach = std::max(tolerance, 256.0 * grid.Step[axis]);
    std::size_t first = 0;
    for (std::size_t i = 1; i <= order.size(); ++i)
    {
      if (i == order.size() ||
        contours.Coordinate[order[i]] - contours.Coordinate[order[first]] > reach)
      {
        MergePlane(contours, order, first, i, axis, grid);
        first = i;
      }
    }
  }
  DropFlagsOfReal(grid);
  return grid;
}
}
