// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/EqualPoints.h"

#include "Support/Random.h"
#include "Support/ThreadRanks.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;

TEST(EqualPoints, CountsThoseThatFloatDoesNotTellApart)
{
  const double points[] = { 1.0, 2.0, 3.0, 1.0 + 1e-12, 2.0, 3.0, 1.001, 2.0, 3.0, 1.0, 2.0,
    3.0 - 1e-12 };
  EXPECT_EQ(CountEqualInFloat(points, 4), 2);
  EXPECT_EQ(CountEqualInFloat(points, 1), 0);
  const float floats[] = { 1.0f, 2.0f, 3.0f, 1.0000001f, 2.0f, 3.0f };
  EXPECT_EQ(CountEqualInFloat(floats, 2), 0);
}

// Of points that processes have in common, one counts; the others are as those of one process.
TEST(EqualPoints, OfSeveralProcesses)
{
  support::Random numbers(5);
  std::vector<double> points;
  for (int i = 0; i < 3000; ++i)
  {
    points.push_back(1.0e6 + static_cast<double>(numbers.Below(40)) / 10.0);
  }
  const std::int64_t equal = CountEqualInFloat(points.data(), 1000);
  EXPECT_GT(equal, 0);
  for (const int count : { 2, 5 })
  {
    support::ThreadRanks processes(count);
    processes.ForAll(
      [&](const Ranks& ranks)
      {
        // Each has ten points of the next one, too.
        const int first = 1000 * ranks.Rank / count, last = 1000 * (ranks.Rank + 1) / count;
        const int end = std::min(1000, last + 10);
        std::vector<std::uint8_t> isDuplicate(end - first, 0);
        std::fill(isDuplicate.begin() + (last - first), isDuplicate.end(), std::uint8_t(1));
        EXPECT_EQ(CountEqualInFloat(
                    points.data() + 3 * first, end - first, Execution(), ranks, isDuplicate.data()),
          equal);
      });
  }
}
