// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/SpatialGrid.h"

#include "Core/Base/EditContours.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace orthoslices
{
namespace
{
/// Planes that are fewer steps of the precision apart become one: closer ones leave no room for 16
/// steps of Margin on both sides and for a few patches between them.
constexpr double MinDistanceOfPlanes = 256.0;

/// Room that patches have beyond virtual contours, in SpacingAtEnds: far more than the Margin.
constexpr double RoomBeyondVirtual = 0.01;

/// Room that patches get beyond the border of the image, as a share of the distance of slices at
/// the ends: as much as MakeVirtualSlices keeps from the bounds, so that virtual contours lie on
/// the border.
constexpr double RoomBeyondBorder = 0.02;
}

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
  coordinate = std::max(coordinate, below ? planes[slab - 1] + margin : this->Lowest[axis]);
  coordinate = std::min(coordinate, above ? planes[slab] - margin : this->Highest[axis]);
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

int CountFamilies(const SpatialGrid& grid)
{
  int families = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    families += grid.Count(axis) > 0 ? 1 : 0;
  }
  return families;
}

Index MostPlanes(const SpatialGrid& grid)
{
  return std::max({ grid.Count(0), grid.Count(1), grid.Count(2) });
}

int FindOnlyFamily(const SpatialGrid& grid)
{
  int families = 0;
  int axis = -1;
  for (int i = 0; i < 3; ++i)
  {
    families += grid.Count(i) > 0 ? 1 : 0;
    axis = grid.Count(i) > 0 ? i : axis;
  }
  return families == 1 ? axis : -1;
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
/// Sets the steps of the precision and the extents from the box around all contours.
void FindExtent(const Box3& box, SpatialGrid& grid)
{
  const double epsilon = grid.SinglePrecision ? std::numeric_limits<float>::epsilon()
                                              : std::numeric_limits<double>::epsilon();
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Step[axis] =
      std::max(grid.Quantum, epsilon * std::max(std::abs(box.Low[axis]), std::abs(box.High[axis])));
    grid.Extent[axis] = box.High[axis] - box.Low[axis];
    longest = std::max(longest, grid.Extent[axis]);
  }
  for (double& extent : grid.Extent)
  {
    extent = extent > 0.0 ? extent : longest;
  }
}

/// Makes vertices values of the grid's precision. Vertices that become the same are one, but for
/// contours of which fewer than three would be left.
void RoundVertices(const SpatialGrid& grid, Contours& contours)
{
  std::vector<double> u, v;
  std::vector<Index> offsets{ 0 };
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    const std::size_t first = u.size();
    const Index begin = contours.Offsets[contour], end = contours.Offsets[contour + 1];
    for (Index i = begin; i < end; ++i)
    {
      const double x = grid.Round(contours.U[i]), y = grid.Round(contours.V[i]);
      if (u.size() == first || x != u.back() || y != v.back())
      {
        u.push_back(x);
        v.push_back(y);
      }
    }
    while (u.size() > first + 1 && u.back() == u[first] && v.back() == v[first])
    {
      u.pop_back();
      v.pop_back();
    }
    if (u.size() < first + 3)
    {
      u.resize(first);
      v.resize(first);
      u.insert(u.end(), contours.U.begin() + begin, contours.U.begin() + end);
      v.insert(v.end(), contours.V.begin() + begin, contours.V.begin() + end);
    }
    offsets.push_back(static_cast<Index>(u.size()));
  }
  contours.U.swap(u);
  contours.V.swap(v);
  contours.Offsets.swap(offsets);
}

/// The number of the grid's precision next to x, but not beyond it on the side of `outwards`.
double RoundInwards(const SpatialGrid& grid, double x, double outwards)
{
  const double rounded = grid.Round(x);
  const bool isBeyond = outwards < 0.0 ? rounded < x : rounded > x;
  if (isBeyond && grid.Quantum > 0.0)
  {
    return rounded - std::copysign(grid.Quantum, outwards);
  }
  return isBeyond ? std::nextafter(static_cast<float>(rounded), static_cast<float>(-outwards))
                  : rounded;
}

/// Mean distance of the real planes of an axis; infinite if there are fewer than two.
double MeanSpacingOfReal(const SpatialGrid& grid, int axis)
{
  std::vector<double> real;
  for (Index i = 0; i < grid.Count(axis); ++i)
  {
    if (!grid.IsVirtual(axis, i))
    {
      real.push_back(grid.Planes[axis][i]);
    }
  }
  return real.size() < 2 ? HUGE_VAL : (real.back() - real.front()) / (real.size() - 1.0);
}

/// Sets how far apart slices are at the ends of the object. REQUIRES: a box around real contours.
void SetSpacingAtEnds(const Box3& box, SpatialGrid& grid)
{
  Point3 mean, extent;
  for (int axis = 0; axis < 3; ++axis)
  {
    mean[axis] = MeanSpacingOfReal(grid, axis);
    extent[axis] = box.High[axis] - box.Low[axis];
  }
  const double longest = *std::max_element(extent.begin(), extent.end());
  for (int axis = 0; axis < 3; ++axis)
  {
    double spacing = mean[axis];
    if (!std::isfinite(spacing))
    {
      spacing = std::min(0.5 * (extent[axis] > 0.0 ? extent[axis] : longest),
        *std::min_element(mean.begin(), mean.end()));
    }
    grid.SpacingAtEnds[axis] = std::max(spacing, MinDistanceOfPlanes * grid.Step[axis]);
  }
}

/// Sets the bounds of the surface, if there are real contours: these lie in the box, and all in the
/// other one. REQUIRES: the planes are known.
void SetBounds(const Box3& box, const Box3& all, SpatialGrid& grid)
{
  if (!(box.Low[0] <= box.High[0]))
  {
    return;
  }
  SetSpacingAtEnds(box, grid);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double beyond = 0.5 * grid.SpacingAtEnds[axis];
    const double beyondVirtual = RoomBeyondVirtual * grid.SpacingAtEnds[axis];
    const double low = std::min(box.Low[axis] - beyond, all.Low[axis] - beyondVirtual);
    const double high = std::max(box.High[axis] + beyond, all.High[axis] + beyondVirtual);
    grid.Lowest[axis] = RoundInwards(grid, low, -HUGE_VAL);
    grid.Highest[axis] = RoundInwards(grid, high, HUGE_VAL);
  }
}
}

SpatialGrid BuildSpatialGrid(
  Contours& contours, double tolerance, bool singlePrecision, double quantum)
{
  SpatialGrid grid;
  grid.SinglePrecision = singlePrecision;
  grid.Quantum = quantum;
  if (quantum > 0.0)
  {
    RoundVertices(grid, contours);
  }
  const Box3 box = BoxOf(contours);
  if (contours.Count() > 0)
  {
    FindExtent(box, grid);
  }
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
    const double reach = std::max(tolerance, MinDistanceOfPlanes * grid.Step[axis]);
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
  SetBounds(BoxOf(contours, false), box, grid);
  return grid;
}

void LimitBounds(const Box3& border, SpatialGrid& grid)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double room = RoomBeyondBorder * grid.SpacingAtEnds[axis];
    grid.Lowest[axis] = std::max(grid.Lowest[axis], grid.Round(border.Low[axis] - room));
    grid.Highest[axis] = std::min(grid.Highest[axis], grid.Round(border.High[axis] + room));
  }
}
}
