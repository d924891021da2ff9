// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/MatchAlternating.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
void MatchAlternating(const std::vector<double>& first, const std::vector<double>& second,
  std::vector<std::pair<Index, Index>>& matched)
{
  const std::size_t n = first.size();
  const std::size_t m = second.size();
  matched.clear();
  if ((n + 1) * (m + 1) > LargestMatchingTable)
  {
    // Thousands of crossings on one edge: match in order; still valid, no longer the least change.
    for (std::size_t i = 0; i < std::min(n, m); ++i)
    {
      matched.emplace_back(static_cast<Index>(i), static_cast<Index>(i));
    }
    return;
  }
  constexpr double unreachable = std::numeric_limits<double>::infinity();
  std::vector<double> cost((n + 1) * (m + 1), unreachable);
  const auto at = [&](std::size_t i, std::size_t j) -> double& { return cost[i * (m + 1) + j]; };
  // The three ways to end the matching of the first i and the first j entries.
  const auto match = [&](std::size_t i, std::size_t j)
  {
    return i > 0 && j > 0 ? at(i - 1, j - 1) + std::abs(first[i - 1] - second[j - 1]) : unreachable;
  };
  const auto dropFirst = [&](std::size_t i, std::size_t j)
  { return i > 1 ? at(i - 2, j) + (first[i - 1] - first[i - 2]) : unreachable; };
  const auto dropSecond = [&](std::size_t i, std::size_t j)
  { return j > 1 ? at(i, j - 2) + (second[j - 1] - second[j - 2]) : unreachable; };
  for (std::size_t i = 0; i <= n; ++i)
  {
    for (std::size_t j = i % 2; j <= m; j += 2)
    {
      at(i, j) = i + j == 0 ? 0.0 : std::min({ match(i, j), dropFirst(i, j), dropSecond(i, j) });
    }
  }
  for (std::size_t i = n, j = m; i + j > 0;)
  {
    if (at(i, j) == match(i, j))
    {
      matched.emplace_back(static_cast<Index>(--i), static_cast<Index>(--j));
    }
    else if (at(i, j) == dropFirst(i, j))
    {
      i -= 2;
    }
    else
    {
      j -= 2;
    }
  }
  std::reverse(matched.begin(), matched.end());
}
}
