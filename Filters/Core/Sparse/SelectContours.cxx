// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SelectContours.h"

#include "Core/Base/EditContours.h"

#include <algorithm>
#include <set>
#include <utility>

namespace orthoslices
{
void AddVirtual(const Contours& others, Contours& contours)
{
  contours.Virtual.resize(contours.Axis.size(), 0);
  AppendContours(others, contours);
  std::fill(contours.Virtual.end() - others.Count(), contours.Virtual.end(), std::uint8_t(1));
}

Contours SelectAxis(const Contours& contours, int axis, bool ofAxis)
{
  std::vector<std::uint8_t> isOther;
  for (const std::int8_t of : contours.Axis)
  {
    isOther.push_back((of == axis) != ofAxis ? 1 : 0);
  }
  Contours chosen = contours;
  RemoveMarked(isOther, chosen);
  return chosen;
}

bool RemoveMended(const std::vector<Repair>& repairs, const SpatialGrid& grid, Contours& contours)
{
  const auto isDrawnAnew = [](const Repair& repair)
  { return repair.Kind == RepairKind::ArcsRedrawn; };
  const bool any = std::any_of(repairs.begin(), repairs.end(), isDrawnAnew);
  std::set<std::pair<int, double>> mended; // planes, by axis and coordinate
  for (const Repair& repair : repairs)
  {
    if (!any || isDrawnAnew(repair))
    {
      mended.insert({ repair.Axis, grid.Planes[repair.Axis][repair.Plane] });
    }
  }
  std::vector<std::uint8_t> isMended;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    isMended.push_back(mended.count({ contours.Axis[i], contours.Coordinate[i] }) > 0 ? 1 : 0);
  }
  const Index before = contours.Count();
  RemoveMarked(isMended, contours);
  return contours.Count() < before;
}
}
