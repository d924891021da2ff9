// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SelectContours.h"

#include "Core/Base/EditContours.h"

#include <algorithm>

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
}
