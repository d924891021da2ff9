// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/CycleGeometry.h"

namespace orthoslices
{
std::vector<Index> CycleGeometry::GetBorders(const std::vector<Index>& cycles) const
{
  std::vector<Index> borders, border, places;
  for (const Index cycle : cycles)
  {
    this->GetBoundary(cycle, border, places);
    borders.insert(borders.end(), border.begin(), border.end());
  }
  return borders;
}
}
