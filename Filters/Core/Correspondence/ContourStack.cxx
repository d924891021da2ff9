// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/ContourStack.h"

#include <algorithm>

namespace orthoslices
{
std::vector<Index> FirstContourOfSlices(const ContourStack& stack)
{
  std::vector<Index> first(stack.Coordinate.size() + 1);
  for (std::size_t slice = 0; slice < first.size(); ++slice)
  {
    const auto at =
      std::lower_bound(stack.Slice.begin(), stack.Slice.end(), static_cast<Index>(slice));
    first[slice] = static_cast<Index>(at - stack.Slice.begin());
  }
  return first;
}

std::vector<double> SignedAreas(const ContourStack& stack)
{
  std::vector<double> areas(stack.Slice.size(), 0.0);
  for (Index contour = 0; contour < stack.Count(); ++contour)
  {
    // Relative to a vertex of its own, so that contours far from the origin lose no digits.
    const Point2 origin = stack.At(stack.Offsets[contour]);
    for (Index i = stack.Offsets[contour]; i < stack.Offsets[contour + 1]; ++i)
    {
      const Point2 p = stack.At(i);
      const Point2 q = stack.At(stack.Next(contour, i));
      areas[contour] +=
        0.5 * ((p[0] - origin[0]) * (q[1] - origin[1]) - (p[1] - origin[1]) * (q[0] - origin[0]));
    }
  }
  return areas;
}
}
