// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/VirtualPlanes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
/// As many slices show the shape of an object; fewer are sparse.
constexpr double FewPlanes = 12.0;
/// More virtual planes than this on one axis cost more than they show.
constexpr double ManyPlanes = 64.0;
/// A stack of so many slices and a few across is no longer few.
constexpr double FewInStack = 17.0;
/// And a spacing that was given gets no more than so many.
constexpr double PlanesAtMost = 1024.0;
/// A slab is divided if its halves are not much narrower than wanted.
constexpr double WideSlab = 1.4;
/// An axis has few planes if another one has so many times more.
constexpr Index FewAgainstMany = 3;
/// Across so many planes a surface can bend,
constexpr Index EnoughPlanes = 8;
/// and across so many where a few slices across guide it, all of one family: those of two families
/// cut the stack into cells whose patches are as near to the object as the surface of so few
/// slices.
constexpr Index EnoughGuidedPlanes = 5;
/// As few slices across guide a stack of any height.
constexpr Index FewAcross = 2;
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Of the axes that have planes.
double DensestSpacing(const SpatialGrid& grid)
{
  double least = Infinity;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (grid.Count(axis) > 0)
    {
      least = std::min(least, grid.MeanSpacing(axis));
    }
  }
  return least;
}

/// The axis with enough planes, each other one having few against it, and both together some: at
/// most FewAcross, or one for FewAgainstMany; -1 if there is none.
int FindStack(const SpatialGrid& grid)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const Index one = grid.Count(FirstAxis(axis)), other = grid.Count(SecondAxis(axis));
    const Index part = grid.Count(axis) / FewAgainstMany;
    const Index enough = std::min(one, other) > 0 ? EnoughPlanes : EnoughGuidedPlanes;
    if (grid.Count(axis) >= enough && one + other > 0 && std::max(one, other) <= part &&
      one + other <= std::max(FewAcross, part))
    {
      return axis;
    }
  }
  return -1;
}

/// Whether there are several families, none with as many slices as show a shape, or a stack of not
/// many more with a few across. Stacks of fewer are left to the slices across.
bool HasFewOfAll(const SpatialGrid& grid)
{
  const Index most = MostPlanes(grid);
  return CountFamilies(grid) > 1 &&
    (FindStack(grid) < 0 ? most < FewPlanes : most >= EnoughPlanes && most < FewInStack);
}

/// Whether families are missing, or have few slices, and the others carry a surface across.
bool NeedsMore(const SpatialGrid& grid)
{
  const auto [least, most] = std::minmax({ grid.Count(0), grid.Count(1), grid.Count(2) });
  Index fewest = most;
  for (int axis = 0; axis < 3; ++axis)
  {
    fewest = grid.Count(axis) > 0 ? std::min(fewest, grid.Count(axis)) : fewest;
  }
  const int families = CountFamilies(grid);
  const bool isStack = families == 1 || most >= FewAgainstMany * fewest;
  return isStack ? families == 1 || most >= EnoughPlanes || FindStack(grid) >= 0 : least == 0;
}
}

SliceDensity::SliceDensity(
  const SpatialGrid& grid, const Box3& contours, double spacing, SparseRule rule)
  : Wide{ Infinity, Infinity, Infinity }
{
  const Point3 extent = contours.High - contours.Low;
  this->Longest = static_cast<int>(std::max_element(extent.begin(), extent.end()) - extent.begin());
  const bool ofField = rule == SparseRule::Field;
  if (ofField ? !HasFewOfAll(grid) : !(spacing > 0.0) && !NeedsMore(grid))
  {
    return;
  }
  this->Stack = FindStack(grid);
  this->OfField = ofField;
  this->IsFine = !ofField && this->Stack < 0 && CountFamilies(grid) == 2;
  const double densest = DensestSpacing(grid);
  const Index most = MostPlanes(grid);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double given = std::max(spacing, extent[axis] / PlanesAtMost);
    this->Target[axis] = spacing > 0.0
      ? given
      : std::clamp(densest, extent[axis] / ManyPlanes, extent[axis] / FewPlanes);
    if (spacing > 0.0 || ofField)
    {
      this->Wide[axis] = WideSlab * this->Target[axis];
    }
    else if (grid.Count(axis) * FewAgainstMany <= most)
    {
      this->Wide[axis] = WideSlab * std::max(densest, extent[axis] / FewPlanes);
    }
    const auto& planes = grid.Planes[axis];
    this->Sparse |= planes.empty();
    for (std::size_t i = 0; i <= planes.size() && !planes.empty(); ++i)
    {
      const double low = i > 0 ? planes[i - 1] : contours.Low[axis];
      const double high = i < planes.size() ? planes[i] : contours.High[axis];
      this->Sparse |= this->CountParts(axis, high - low) > 1;
    }
  }
}

void SliceDensity::Coarsen()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Target[axis] *= 2.0;
    this->Wide[axis] = std::max(this->Wide[axis], WideSlab * this->Target[axis]);
  }
}

double SliceDensity::EdgeLength() const
{
  // For a stack, less than 0.45 makes the error no smaller. The contours of two families are closer
  // together: with 0.5 it is 5 to 10 parts in 100 greater, with 0.25 2 smaller, in twice the time.
  constexpr double usual = 0.5, ofTwoFamilies = 0.35;
  return (this->IsFine ? ofTwoFamilies : usual) * this->Target[this->Longest];
}

int SliceDensity::CountParts(int axis, double width) const
{
  if (width <= this->Wide[axis])
  {
    return 1;
  }
  return static_cast<int>(std::lround(width / this->Target[axis]));
}

VirtualPlanes ChooseVirtualPlanes(
  const SpatialGrid& grid, const Box3& surface, const SliceDensity& density)
{
  VirtualPlanes result;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& planes = grid.Planes[axis];
    const auto divide = [&](double low, double high, double from, double to, int parts)
    {
      for (int i = 0; i < parts; ++i)
      {
        const double plane = grid.Round(low + (high - low) * (from + i) / (parts - 1 + from + to));
        result[axis].push_back(plane);
      }
    };
    const double low = surface.Low[axis];
    const double high = surface.High[axis];
    if (planes.empty())
    {
      const int count =
        std::max(1, static_cast<int>(std::lround((high - low) / density.Spacing(axis))));
      divide(low, high, 0.5, 0.5, count);
      continue;
    }
    // The last slab ends where the surface does, half a spacing beyond the last plane.
    divide(low, planes.front(), 0.5, 1.0, density.CountParts(axis, planes.front() - low) - 1);
    for (std::size_t i = 1; i < planes.size(); ++i)
    {
      divide(planes[i - 1], planes[i], 1.0, 1.0,
        density.CountParts(axis, planes[i] - planes[i - 1]) - 1);
    }
    divide(planes.back(), high, 1.0, 0.5, density.CountParts(axis, high - planes.back()) - 1);
  }
  return result;
}
}
