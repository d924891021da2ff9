// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/TubePatch.h"

#include "Core/Base/Vectors.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
PatchCurve RandomCurve(Random& random, Index count)
{
  PatchCurve curve;
  for (Index i = 0; i < count; ++i)
  {
    curve.Corners.push_back(random.Chance(0.3) ? -1 - i : i);
    curve.Points.push_back(
      { random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0) });
  }
  return curve;
}

double CostOf(const PatchCurve& a, const PatchCurve& b, Index i, Index j)
{
  return SquaredDistance(a.Points[i % a.Count()], b.Points[j % b.Count()]);
}

/// The least sum over all ways from (i, j) to (endI, endJ), one after another.
double LeastCost(const PatchCurve& a, const PatchCurve& b, Index i, Index j, Index endI, Index endJ)
{
  if (i == endI && j == endJ)
  {
    return CostOf(a, b, i, j);
  }
  double best = HUGE_VAL;
  for (const auto& step : { std::pair<Index, Index>{ 1, 0 }, { 0, 1 }, { 1, 1 } })
  {
    if (i + step.first <= endI && j + step.second <= endJ)
    {
      best = std::min(best, LeastCost(a, b, i + step.first, j + step.second, endI, endJ));
    }
  }
  return CostOf(a, b, i, j) + best;
}

PointPair Nearest(const PatchCurve& a, const PatchCurve& b, bool onBorders)
{
  PointPair best;
  for (Index i = 0; i < a.Count(); ++i)
  {
    for (Index j = 0; j < b.Count(); ++j)
    {
      const double distance2 = CostOf(a, b, i, j);
      if ((!onBorders || (a.Corners[i] >= 0 && b.Corners[j] >= 0)) && distance2 < best.Distance2)
      {
        best = { i, j, distance2 };
      }
    }
  }
  return best;
}
}

//----------------------------------------------------------------------------
/// Of all ways around both curves, from their nearest points to these again, none costs less.
TEST(TubePatch, PairsPointsAtTheLeastCostOfAllWays)
{
  Random random(21);
  for (int run = 0; run < 60; ++run)
  {
    SCOPED_TRACE(run);
    const PatchCurve a = RandomCurve(random, 3 + static_cast<Index>(random.Below(3)));
    const PatchCurve b = RandomCurve(random, 3 + static_cast<Index>(random.Below(3)));
    const PointPair start = Nearest(a, b, false);
    const std::vector<PointPair> pairs = PairPoints(a, b);
    ASSERT_GE(pairs.size(), 4u);
    EXPECT_EQ(pairs.front().First, start.First);
    EXPECT_EQ(pairs.front().Second, start.Second);
    EXPECT_EQ(pairs.back().First, start.First);
    EXPECT_EQ(pairs.back().Second, start.Second);
    double cost = CostOf(a, b, start.First, start.Second);
    Index stepsOfA = 0, stepsOfB = 0;
    for (std::size_t k = 1; k < pairs.size(); ++k)
    {
      const Index i = (pairs[k].First - pairs[k - 1].First + a.Count()) % a.Count();
      const Index j = (pairs[k].Second - pairs[k - 1].Second + b.Count()) % b.Count();
      EXPECT_LE(i, 1);
      EXPECT_LE(j, 1);
      EXPECT_GE(i + j, 1);
      stepsOfA += i;
      stepsOfB += j;
      cost += CostOf(a, b, pairs[k].First, pairs[k].Second);
    }
    EXPECT_EQ(stepsOfA, a.Count());
    EXPECT_EQ(stepsOfB, b.Count());
    const double least =
      LeastCost(a, b, start.First, start.Second, start.First + a.Count(), start.Second + b.Count());
    EXPECT_NEAR(cost, least, 1e-12 * least);
  }
}

//----------------------------------------------------------------------------
TEST(TubePatch, NearestPointsOnBordersLeaveOutBridges)
{
  Random random(22);
  int differ = 0;
  for (int run = 0; run < 100; ++run)
  {
    PatchCurve a = RandomCurve(random, 6);
    PatchCurve b = RandomCurve(random, 7);
    a.Corners.front() = 0;
    b.Corners.front() = 0;
    const PointPair found = FindNearestOnBorders(a, b);
    const PointPair expected = Nearest(a, b, true);
    EXPECT_EQ(found.First, expected.First);
    EXPECT_EQ(found.Second, expected.Second);
    EXPECT_EQ(found.Distance2, expected.Distance2);
    differ += Nearest(a, b, false).Distance2 < expected.Distance2 ? 1 : 0;
  }
  EXPECT_GT(differ, 20);
}

//----------------------------------------------------------------------------
/// Two circles of very many points are paired by length: each point with the one opposite.
TEST(TubePatch, CurvesOfManyPointsArePairedByLength)
{
  constexpr Index count = 4100; // its square is more than is compared point by point
  PatchCurve a, b;
  for (Index i = 0; i < count; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / count;
    a.Corners.push_back(i);
    a.Points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    b.Corners.push_back(count + i);
    b.Points.push_back({ std::cos(angle), std::sin(angle), 0.1 });
  }
  const std::vector<PointPair> pairs = PairPoints(a, b);
  EXPECT_EQ(pairs.size(), static_cast<std::size_t>(2 * count + 1));
  for (const PointPair& pair : pairs)
  {
    EXPECT_LT(std::sqrt(CostOf(a, b, pair.First, pair.Second)), 0.1 + 4.0 / count);
  }
}
