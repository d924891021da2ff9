// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/MatchAlternating.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Pairs = std::vector<std::pair<Index, Index>>;

Pairs Match(const std::vector<double>& first, const std::vector<double>& second)
{
  Pairs pairs;
  MatchAlternating(first, second, pairs);
  return pairs;
}

/**
 * Cost of a matching after its definition, or infinity if it is none: ascending pairs, and between
 * them an even number of unmatched entries of each list, which go in pairs of neighbours.
 */
double CostOf(
  const Pairs& pairs, const std::vector<double>& first, const std::vector<double>& second)
{
  double cost = 0.0;
  std::size_t i = 0, j = 0;
  const auto skip = [&](const std::vector<double>& list, std::size_t& at, std::size_t to)
  {
    for (; at + 1 < to; at += 2)
    {
      cost += list[at + 1] - list[at];
    }
    cost += at == to ? 0.0 : HUGE_VAL;
  };
  for (const auto& pair : pairs)
  {
    skip(first, i, static_cast<std::size_t>(pair.first));
    skip(second, j, static_cast<std::size_t>(pair.second));
    cost += std::abs(first[i++] - second[j++]);
  }
  skip(first, i, first.size());
  skip(second, j, second.size());
  return cost;
}

/// Least cost of all ways to go on from entries i and j: no table, every possibility is tried.
double MinCost(const std::vector<double>& first, const std::vector<double>& second,
  std::size_t i = 0, std::size_t j = 0)
{
  if (i == first.size() && j == second.size())
  {
    return 0.0;
  }
  double minimum = HUGE_VAL;
  if (i < first.size() && j < second.size())
  {
    minimum = std::abs(first[i] - second[j]) + MinCost(first, second, i + 1, j + 1);
  }
  if (i + 1 < first.size())
  {
    minimum = std::min(minimum, first[i + 1] - first[i] + MinCost(first, second, i + 2, j));
  }
  if (j + 1 < second.size())
  {
    minimum = std::min(minimum, second[j + 1] - second[j] + MinCost(first, second, i, j + 2));
  }
  return minimum;
}

std::vector<double> RandomList(Random& random, std::size_t size)
{
  std::vector<double> list;
  for (std::size_t i = 0; i < size; ++i)
  {
    list.push_back(
      random.Chance(0.3) ? static_cast<double>(random.Below(4)) : random.Uniform(0.0, 4.0));
  }
  std::sort(list.begin(), list.end());
  return list;
}
}

//----------------------------------------------------------------------------
TEST(MatchAlternating, HandSolved)
{
  EXPECT_EQ(Match({}, {}), Pairs{});
  EXPECT_EQ(Match({ 1.0 }, { 1.5 }), (Pairs{ { 0, 0 } }));
  EXPECT_EQ(Match({ 1.0, 2.0 }, {}), Pairs{});
  EXPECT_EQ(Match({ 1.0, 2.0, 3.0 }, { 2.9 }), (Pairs{ { 2, 0 } }));
  EXPECT_EQ(Match({ 1.1 }, { 1.0, 2.0, 3.0 }), (Pairs{ { 0, 0 } }));
  EXPECT_EQ(Match({ 0.0, 9.0 }, { 0.0, 4.0, 5.0, 9.0 }), (Pairs{ { 0, 0 }, { 1, 3 } }));
  // Matching would cost 20, dropping both pairs only 2.
  EXPECT_EQ(Match({ 0.0, 1.0 }, { 10.0, 11.0 }), Pairs{});
}

//----------------------------------------------------------------------------
TEST(MatchAlternating, AsCheapAsTheBestOfAllMatchings)
{
  Random random(1);
  for (int run = 0; run < 3000; ++run)
  {
    const std::size_t n = random.Below(7);
    const std::size_t m = n % 2 + 2 * random.Below(n % 2 ? 3 : 4);
    const std::vector<double> first = RandomList(random, n), second = RandomList(random, m);
    const Pairs pairs = Match(first, second);
    EXPECT_NEAR(CostOf(pairs, first, second), MinCost(first, second), 1e-12)
      << "run " << run << ", sizes " << n << " and " << m;
  }
}

//----------------------------------------------------------------------------
TEST(MatchAlternating, ThousandsOnOneEdgeAreStillMatchedValidly)
{
  std::vector<double> first, second;
  // An odd number of them, more than there is room for in a table.
  const int count = 2 * static_cast<int>(0.5 * std::sqrt(double(LargestMatchingTable))) + 201;
  for (int i = 0; i < count; ++i)
  {
    first.push_back(i);
    second.push_back(i + 0.25);
  }
  second.resize(second.size() - 2);
  const Pairs pairs = Match(first, second);
  EXPECT_EQ(pairs.size(), second.size());
  EXPECT_GT((first.size() + 1) * (second.size() + 1), LargestMatchingTable);
  EXPECT_TRUE(std::isfinite(CostOf(pairs, first, second)));
}
