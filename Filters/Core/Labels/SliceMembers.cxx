// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/SliceMembers.h"

#include <map>

namespace orthoslices
{
std::vector<std::vector<SliceMember>> ListSlices(const std::vector<const Contours*>& structures)
{
  std::map<std::pair<int, double>, std::vector<SliceMember>> slices;
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    const Contours& contours = *structures[i];
    for (Index contour = 0; contour < contours.Count(); ++contour)
    {
      slices[{ contours.Axis[contour], contours.Coordinate[contour] }].push_back(
        { static_cast<Index>(i), contour });
    }
  }
  std::vector<std::vector<SliceMember>> list;
  for (auto& slice : slices)
  {
    list.push_back(std::move(slice.second));
  }
  return list;
}

std::vector<Point2> PolygonOf(const Contours& contours, Index contour)
{
  std::vector<Point2> polygon;
  for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
  {
    polygon.push_back({ contours.U[i], contours.V[i] });
  }
  return polygon;
}
}
