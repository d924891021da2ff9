// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/EqualPoints.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace orthoslices
{
namespace
{
template <typename Coordinate>
std::int64_t CountEqual(const Coordinate* points, std::int64_t count)
{
  std::vector<std::array<float, 3>> rounded(static_cast<std::size_t>(count));
  for (std::array<float, 3>& point : rounded)
  {
    for (float& x : point)
    {
      x = static_cast<float>(*points++);
    }
  }
  std::sort(rounded.begin(), rounded.end());
  return rounded.end() - std::unique(rounded.begin(), rounded.end());
}
}

std::int64_t CountEqualInFloat(const double* points, std::int64_t count)
{
  return CountEqual(points, count);
}

std::int64_t CountEqualInFloat(const float* points, std::int64_t count)
{
  return CountEqual(points, count);
}
}
