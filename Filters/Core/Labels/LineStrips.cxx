// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/LineStrips.h"

#include <algorithm>

namespace orthoslices
{
StripBands::StripBands(const SpatialGrid& grid, int axis)
{
  const std::vector<double>& planes = grid.Planes[axis];
  this->Ends.push_back(-HUGE_VAL);
  for (Index plane = 0; plane < static_cast<Index>(planes.size()); ++plane)
  {
    this->Ends.push_back(grid.MoveInside(axis, plane, planes[plane]));
    this->Ends.push_back(planes[plane]);
    this->Ends.push_back(grid.MoveInside(axis, plane + 1, planes[plane]));
  }
}

Index StripBands::Find(double x) const
{
  const auto above = std::upper_bound(this->Ends.begin(), this->Ends.end(), x);
  const Index band = static_cast<Index>(above - this->Ends.begin());
  // The rim below a plane is no part of the strip.
  return band % 3 == 2 && this->Ends[band - 1] == x ? band - 1 : band;
}

bool StripBands::IsStripIn(double low, double high) const
{
  const Index first = this->Find(low), last = this->Find(high);
  return IsStrip(first) || first != last;
}

void LineNodes::Settle(const SpatialGrid& grid, int axis, const StripBands& bands)
{
  std::sort(this->Places.begin(), this->Places.end());
  this->Places.erase(std::unique(this->Places.begin(), this->Places.end()), this->Places.end());
  double last = -HUGE_VAL;
  for (const double place : this->Places)
  {
    const Index slab = bands.Find(place) / 3;
    const double gap = grid.Margin(axis, slab);
    double high = HUGE_VAL;
    if (slab < grid.Count(axis))
    {
      high = bands.EndOf(3 * slab + 1);
    }
    const double low = slab > 0 ? bands.EndOf(3 * slab) : -HUGE_VAL;
    last = std::max(last, low); // of this slab
    this->New.push_back(place < last + gap ? last : place > high - gap ? high : place);
    last = this->New.back();
  }
}

double LineNodes::NewPlace(double place, const StripBands& bands) const
{
  const auto found = std::lower_bound(this->Places.begin(), this->Places.end(), place);
  if (found != this->Places.end() && *found == place)
  {
    return this->New[found - this->Places.begin()];
  }
  const Index band = bands.Find(place);
  return StripBands::IsStrip(band) ? bands.RimOf(band) : place;
}
}
