// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/ReconcileSlices.h"

#include "Support/Random.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

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
  for (int i = 0; i < 3001; ++i)
  {
    first.push_back(i);
    second.push_back(i + 0.25);
  }
  second.resize(2999);
  const Pairs pairs = Match(first, second);
  EXPECT_EQ(pairs.size(), 2999u);
  EXPECT_TRUE(std::isfinite(CostOf(pairs, first, second)));
}

//----------------------------------------------------------------------------
namespace
{
void ExpectUntouched(const Stages& stages)
{
  EXPECT_EQ(stages.Reconciled.Vertices, 0);
  EXPECT_EQ(stages.Reconciled.Edges, 0);
  EXPECT_EQ(stages.Crossings.Edge, stages.Registered.Edge);
  EXPECT_EQ(stages.Crossings.Position, stages.Registered.Position);
  EXPECT_EQ(stages.Crossings.Next, stages.Registered.Next);
  EXPECT_EQ(stages.Crossings.Previous, stages.Registered.Previous);
  EXPECT_EQ(stages.Crossings.RunNext, stages.Registered.RunNext);
  EXPECT_EQ(stages.Crossings.RunCount, stages.Registered.RunCount);
}
}

TEST(ReconcileSlices, SlicesThatAgreeAreLeftBitForBit)
{
  ExpectUntouched(Stages(Cube()));
  ExpectUntouched(Stages(Octahedron()));
  for (std::uint64_t seed = 0; seed < 60; seed += 2)
  {
    SCOPED_TRACE(seed);
    const Input input = RandomConsistentInput(seed);
    ASSERT_TRUE(input.Exact);
    ExpectUntouched(Stages(input));
  }
}

//----------------------------------------------------------------------------
namespace
{
/// Crossings of each family on an edge, as filed.
std::map<std::uint64_t, std::array<std::vector<Index>, 2>> ByEdge(const Stages& stages)
{
  std::map<std::uint64_t, std::array<std::vector<Index>, 2>> edges;
  for (const Index c : stages.Edges.Crossing)
  {
    if (!stages.Crossings.IsRemoved(c))
    {
      edges[stages.Crossings.Edge[c]][stages.Crossings.Family[c]].push_back(c);
    }
  }
  return edges;
}

void ExpectReconciled(const Stages& stages)
{
  const GridCrossings& crossings = stages.Crossings;
  for (const auto& edge : ByEdge(stages))
  {
    const auto& first = edge.second[0];
    const auto& second = edge.second[1];
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      EXPECT_EQ(crossings.Sign(first[i]), crossings.Sign(second[i]));
      if (i > 0)
      {
        EXPECT_EQ(crossings.Sign(first[i]), -crossings.Sign(first[i - 1]));
        EXPECT_GE(crossings.Position[first[i]], crossings.Position[first[i - 1]]);
        EXPECT_GE(crossings.Position[second[i]], crossings.Position[second[i - 1]]);
      }
    }
  }
}

void ExpectLinked(const GridCrossings& crossings)
{
  for (Index c = 0; c < crossings.Count(); ++c)
  {
    if (!crossings.IsRemoved(c))
    {
      const Index next = crossings.Next[c];
      ASSERT_FALSE(crossings.IsRemoved(next));
      EXPECT_EQ(crossings.Previous[next], c);
      Index run = c;
      while (crossings.RunNext[run] != GridCrossings::None)
      {
        run = crossings.RunNext[run];
      }
      EXPECT_EQ(crossings.ArcLastRun[c], run);
    }
  }
}
}

TEST(ReconcileSlices, AfterwardsBothFamiliesAgreeOnEveryEdge)
{
  Index changed = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed)
  {
    const Input input = RandomContradictoryInput(seed);
    SCOPED_TRACE(input.Name);
    const Stages stages(input);
    ExpectReconciled(stages);
    ExpectLinked(stages.Crossings);
    changed += stages.Reconciled.Edges;
  }
  EXPECT_GT(changed, 1000);
}

//----------------------------------------------------------------------------
/// Two of three slices say that the origin is inside: the third gets a loop around it.
TEST(ReconcileSlices, LoopIsInsertedWhereTheMajorityIsInside)
{
  const Stages stages("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                      "z=0: 0.2,0.2 0.8,0.2 0.8,0.8 0.2,0.8");
  EXPECT_EQ(stages.Reconciled.Vertices, 1);
  EXPECT_EQ(stages.Reconciled.Edges, 0);
  EXPECT_EQ(stages.Isolated.size(), 1u); // the small square crosses nothing
  EXPECT_EQ(stages.Registered.Count(), 8);
  EXPECT_EQ(stages.Crossings.Count(), 12);
  ASSERT_EQ(stages.Nodes.Count(), 6);
  for (Index node = 0; node < 6; ++node)
  {
    // The loop meets the x- and y-axis at the origin, the others meet them at distance 1.
    const bool alongZ = stages.EdgeOf(stages.Nodes.First[node]).Direction == 2;
    EXPECT_EQ(stages.Nodes.Disagreement(node), alongZ ? 0.0 : 1.0);
  }
  EXPECT_EQ(stages.Cycles.Count(), 8);
}

//----------------------------------------------------------------------------
/// Only one of three slices says that the origin is inside: its contour passes by.
TEST(ReconcileSlices, ContourIsTakenOffAVertexThatTheMajorityHasOutside)
{
  const Stages stages("x=0: 2,2 3,2 3,3 2,3; y=0: 2,2 3,2 3,3 2,3; z=0: -1,-1 1,-1 1,1 -1,1");
  EXPECT_EQ(stages.Reconciled.Vertices, 1);
  EXPECT_EQ(stages.Reconciled.Edges, 4);
  EXPECT_EQ(stages.Nodes.Count(), 0);
  EXPECT_EQ(stages.Cycles.Count(), 0);
  EXPECT_GE(stages.Isolated.size(), 2u);
}

//----------------------------------------------------------------------------
/// A dent of one slice that its neighbours do not have is snipped off the edge.
TEST(ReconcileSlices, DentThatOneSliceHasAloneIsSnipped)
{
  // Without the notch up to (0.5, 0.5) across the x-axis this is the square of Octahedron().
  const Stages stages("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                      "z=0: -1,-1 0.4,-1 0.5,0.5 0.6,-1 1,-1 1,1 -1,1");
  EXPECT_EQ(stages.Reconciled.Vertices, 0);
  EXPECT_EQ(stages.Reconciled.Edges, 1);
  EXPECT_EQ(stages.Nodes.Count(), 6);
  EXPECT_EQ(stages.Cycles.Count(), 8);
  for (Index node = 0; node < 6; ++node)
  {
    EXPECT_EQ(stages.Nodes.Disagreement(node), 0.0);
  }
}
