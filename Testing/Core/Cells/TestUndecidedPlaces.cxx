// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/UndecidedPlaces.h"

#include "Core/Reconstruct.h"
#include "Support/Random.h"
#include "Support/RandomInput.h"
#include "Support/SliceSolid.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
struct Interval
{
  int Axis;
  double Low, High;

  bool Has(int axis, double coordinate) const
  {
    return axis == this->Axis && this->Low <= coordinate && coordinate <= this->High;
  }
};

/// A place of which it is known which planes settle it.
struct OpenPlace
{
  double Evidence;
  double Uncertainty;
  Point3 Where;
  std::vector<Interval> Settled;

  bool IsSettled(int axis, double coordinate) const
  {
    return std::any_of(this->Settled.begin(), this->Settled.end(),
      [&](const Interval& i) { return i.Has(axis, coordinate); });
  }
};

void FindBox(const CycleGeometry& geometry, Index cycle, Point3& low, Point3& high)
{
  low.fill(HUGE_VAL);
  high.fill(-HUGE_VAL);
  for (const Index point : geometry.GetBorders({ cycle }))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], geometry.Graph.PointAt(point)[axis]);
      high[axis] = std::max(high[axis], geometry.Graph.PointAt(point)[axis]);
    }
  }
}

/// The entropy of a logistic, as its definition has it.
double EntropyOf(double evidence)
{
  const double p = 1.0 / (1.0 + std::exp(-evidence));
  return -(p * std::log2(p) + (1.0 - p) * std::log2(1.0 - p));
}

/// The middle half of the gap between two cycles, or of the extent of an isolated contour.
OpenPlace Describe(const CycleGeometry& geometry, const CycleJoin& join)
{
  OpenPlace place;
  place.Evidence = join.Evidence;
  place.Uncertainty = join.Impossible ? 1.0 : EntropyOf(join.Evidence);
  Point3 low[2], high[2];
  const Index cycles[2] = { join.First, join.Second };
  bool loop = false;
  for (int i = 0; i < 2; ++i)
  {
    FindBox(geometry, cycles[i], low[i], high[i]);
    if (geometry.IsLoop(cycles[i]))
    {
      loop = true;
      const int normal = geometry.Graph.Loops[geometry.LoopOf(cycles[i])].Axis;
      for (int axis = 0; axis < 3; ++axis)
      {
        if (axis != normal)
        {
          const double quarter = 0.25 * (high[i][axis] - low[i][axis]);
          place.Settled.push_back({ axis, low[i][axis] + quarter, high[i][axis] - quarter });
        }
      }
    }
  }
  int farthest = 0;
  Point3 distance{};
  for (int axis = 0; axis < 3; ++axis)
  {
    place.Where[axis] = 0.25 * (low[0][axis] + high[0][axis] + low[1][axis] + high[1][axis]);
    distance[axis] = std::abs(low[0][axis] + high[0][axis] - low[1][axis] - high[1][axis]);
    farthest = distance[axis] > distance[farthest] ? axis : farthest;
    const double from = std::min(high[0][axis], high[1][axis]);
    const double to = std::max(low[0][axis], low[1][axis]);
    if (!loop && from < to)
    {
      const double quarter = 0.25 * (to - from);
      place.Settled.push_back({ axis, from + quarter, to - quarter });
    }
  }
  if (place.Settled.empty())
  {
    place.Settled.push_back({ farthest, place.Where[farthest], place.Where[farthest] });
  }
  return place;
}

/// The most that one plane settles: one of the planes at the ends of all intervals does.
double GreatestGain(const std::vector<OpenPlace>& places)
{
  double maximum = 0.0;
  for (const OpenPlace& place : places)
  {
    for (const Interval& interval : place.Settled)
    {
      for (const double coordinate : { interval.Low, interval.High })
      {
        double gain = 0.0;
        for (const OpenPlace& p : places)
        {
          gain += p.IsSettled(interval.Axis, coordinate) ? p.Uncertainty : 0.0;
        }
        maximum = std::max(maximum, gain);
      }
    }
  }
  return maximum;
}

/// Compares the result with greedy stabbing by brute force. An end that is rounded in another
/// way may move a place from one plane to another, so that the counts are compared within those.
void ExpectGreedy(const CycleGeometry& geometry, const std::vector<CycleJoin>& joins)
{
  std::vector<OpenPlace> open;
  for (const CycleJoin& join : joins)
  {
    if (join.Impossible || std::abs(join.Evidence) < DecisiveEvidence)
    {
      open.push_back(Describe(geometry, join));
    }
  }
  const UndecidedPlaces found = FindUndecidedPlaces(geometry, joins);
  ASSERT_EQ(found.Places.size(), open.size());
  // Planes are settled in the order of their rank, each place by the best plane that settles it.
  std::vector<Index> settled(found.Planes.size(), 0);
  for (std::size_t i = 0; i < found.Places.size(); ++i)
  {
    const UndecidedPlace& place = found.Places[i];
    ASSERT_GE(place.PlaneRank, 0);
    ASSERT_LT(place.PlaneRank, static_cast<int>(found.Planes.size()));
    ++settled[place.PlaneRank];
    if (i > 0)
    {
      const UndecidedPlace& before = found.Places[i - 1];
      EXPECT_TRUE(before.PlaneRank < place.PlaneRank ||
        (before.PlaneRank == place.PlaneRank && before.Evidence >= place.Evidence));
    }
  }
  for (std::size_t rank = 0; rank < found.Planes.size(); ++rank)
  {
    const ProposedPlane& plane = found.Planes[rank];
    EXPECT_EQ(plane.Settles, settled[rank]);
    EXPECT_NEAR(plane.Gain, GreatestGain(open), 1e-9);
    const auto rest = std::remove_if(open.begin(), open.end(),
      [&](const OpenPlace& p) { return p.IsSettled(plane.Axis, plane.Coordinate); });
    EXPECT_EQ(plane.Settles, open.end() - rest);
    open.erase(rest, open.end());
    EXPECT_TRUE(rank == 0 || plane.Gain <= found.Planes[rank - 1].Gain + 1e-9);
  }
  EXPECT_TRUE(open.empty());
}

/// The uncertainty of all places.
double TotalOf(const UndecidedPlaces& undecided)
{
  double total = 0.0;
  for (const UndecidedPlace& place : undecided.Places)
  {
    total += place.Uncertainty;
  }
  return total;
}

/// A cycle whose box begins at the given point.
Index CycleAt(const CycleGeometry& geometry, const Point3& corner)
{
  Point3 low, high;
  for (Index cycle = 0; cycle < geometry.Cycles.Count(); ++cycle)
  {
    FindBox(geometry, cycle, low, high);
    if (std::hypot(low[0] - corner[0], low[1] - corner[1], low[2] - corner[2]) < 1e-3)
    {
      return cycle;
    }
  }
  ADD_FAILURE() << "no cycle begins at " << corner[0] << ", " << corner[1] << ", " << corner[2];
  return 0;
}
}

//----------------------------------------------------------------------------
TEST(UndecidedPlaces, UncertaintyByHand)
{
  EXPECT_DOUBLE_EQ(UncertaintyOf(0.0), 1.0);
  // The probability is 3/4: 2 - 3/4 log2(3) bits.
  EXPECT_NEAR(UncertaintyOf(std::log(3.0)), 2.0 - 0.75 * std::log2(3.0), 1e-14);
  for (const double evidence : { 0.1, 1.0, 1.5, 3.0, 10.0 })
  {
    EXPECT_NEAR(UncertaintyOf(evidence), EntropyOf(evidence), 1e-12);
    EXPECT_EQ(UncertaintyOf(evidence), UncertaintyOf(-evidence));
  }
  EXPECT_EQ(UncertaintyOf(1e6), 0.0);
}

//----------------------------------------------------------------------------
/// Three pairs of squares above each other. One plane at x = 0.5 passes through two pairs, one at
/// x = 3.5 through the third, of which nothing is known (1 bit). Evidence of 2.5 leaves 0.387 bits
/// each, 0.775 together; evidence of 1 leaves 0.840 each, 1.680 together.
TEST(UndecidedPlaces, OneOpenPlaceCountsMoreThanTwoThatAreAlmostSettled)
{
  std::string text;
  for (const char* plane : { "z=0: ", "z=1: " })
  {
    text += std::string(plane) + "0,0 1,0 1,1 0,1\n" + plane + "0,3 1,3 1,4 0,4\n" + plane +
      "3,6 4,6 4,7 3,7\n";
  }
  const Reconstruction result = Reconstruct(ParsePieces(text), Options(), Execution());
  const CycleGeometry geometry = GeometryOf(result);
  const auto propose = [&](double evidence)
  {
    std::vector<CycleJoin> joins(3);
    const double x[] = { 0.0, 0.0, 3.0 }, y[] = { 0.0, 3.0, 6.0 };
    for (int i = 0; i < 3; ++i)
    {
      joins[i].First = CycleAt(geometry, { x[i], y[i], 0.0 });
      joins[i].Second = CycleAt(geometry, { x[i], y[i], 1.0 });
    }
    joins[0].Evidence = evidence;
    joins[1].Evidence = -evidence;
    return FindUndecidedPlaces(geometry, joins);
  };
  const struct
  {
    double Evidence, Gain;
    int Pair; ///< rank of the plane through the two
  } cases[] = { { 2.5, 0.7748, 1 }, { 1.0, 1.6800, 0 } };
  for (const auto& c : cases)
  {
    const UndecidedPlaces found = propose(c.Evidence);
    ASSERT_EQ(found.Planes.size(), 2u);
    const ProposedPlane& pair = found.Planes[c.Pair];
    EXPECT_EQ(pair.Axis, 0);
    EXPECT_NEAR(pair.Coordinate, 0.5, 1e-3);
    EXPECT_EQ(pair.Settles, 2);
    EXPECT_NEAR(pair.Gain, c.Gain, 1e-3);
    const ProposedPlane& third = found.Planes[1 - c.Pair];
    EXPECT_NEAR(third.Coordinate, 3.5, 1e-3);
    EXPECT_EQ(third.Settles, 1);
    EXPECT_DOUBLE_EQ(third.Gain, 1.0);
  }
  // What is certain enough is no undecided place.
  EXPECT_EQ(propose(3.5).Places.size(), 1u);
}

//----------------------------------------------------------------------------
TEST(UndecidedPlaces, GreedyStabbingAsBruteForceHasIt)
{
  Random random(11);
  std::size_t places = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(60); ++seed)
  {
    Input input = seed % 3 == 0 ? RandomConsistentInput(seed) : RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
    ExpectGreedy(GeometryOf(result), result.Joins);
    // The same cycles with evidence at random: many more places are undecided.
    std::vector<CycleJoin> joins = result.Joins;
    joins.resize(std::min<std::size_t>(joins.size(), 60));
    for (CycleJoin& join : joins)
    {
      join.Evidence = random.Uniform(-4.0, 4.0);
      join.Impossible = random.Chance(0.1);
    }
    ExpectGreedy(GeometryOf(result), joins);
    places += joins.size();
  }
  EXPECT_GT(places, 300u);
}

//----------------------------------------------------------------------------
TEST(UndecidedPlaces, WhatEveryRowSays)
{
  int kinds[3] = { 0, 0, 0 }, choices[3] = { 0, 0, 0 };
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const Input input = RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
    const CycleGeometry geometry = GeometryOf(result);
    for (const UndecidedPlace& place : result.Undecided.Places)
    {
      ++kinds[static_cast<int>(place.Kind)];
      ++choices[static_cast<int>(place.Choice)];
      // There is a join like that.
      const auto join = std::find_if(result.Joins.begin(), result.Joins.end(),
        [&](const CycleJoin& j)
        {
          const int loops =
            (geometry.IsLoop(j.First) ? 1 : 0) + (geometry.IsLoop(j.Second) ? 1 : 0);
          const OpenPlace open = Describe(geometry, j);
          return j.Evidence == place.Evidence && static_cast<int>(place.Kind) == loops &&
            std::abs(open.Where[0] - place.Where[0]) + std::abs(open.Where[1] - place.Where[1]) +
              std::abs(open.Where[2] - place.Where[2]) <
            1e-9;
        });
      ASSERT_NE(join, result.Joins.end());
      EXPECT_EQ(place.Choice,
        join->Impossible ? UndecidedChoice::Impossible
          : join->Chosen ? UndecidedChoice::Joined
                         : UndecidedChoice::Separate);
    }
  }
  EXPECT_GT(kinds[0], 0);
  EXPECT_GT(kinds[1], 0);
  EXPECT_GT(kinds[2], 0);
  EXPECT_GT(choices[0], 0);
  EXPECT_GT(choices[1], 0);
}

//----------------------------------------------------------------------------
TEST(UndecidedPlaces, PlacesBeyondTheLastPlaneHaveNone)
{
  const Input input = RandomConsistentInput(5);
  const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
  std::vector<CycleJoin> joins = result.Joins;
  for (CycleJoin& join : joins)
  {
    join.Evidence = 0.0;
  }
  const CycleGeometry geometry = GeometryOf(result);
  const UndecidedPlaces all = FindUndecidedPlaces(geometry, joins);
  ASSERT_GT(all.Planes.size(), 2u);
  for (const Index maximum : { 0, 1, 2 })
  {
    const UndecidedPlaces some = FindUndecidedPlaces(geometry, joins, maximum);
    EXPECT_EQ(some.Planes.size(), static_cast<std::size_t>(maximum));
    EXPECT_EQ(some.Places.size(), all.Places.size());
    Index settled = 0;
    for (const ProposedPlane& plane : some.Planes)
    {
      settled += plane.Settles;
    }
    for (std::size_t i = 0; i < some.Places.size(); ++i)
    {
      const bool has = i < static_cast<std::size_t>(settled);
      EXPECT_EQ(some.Places[i].PlaneRank >= 0, has);
      EXPECT_LT(some.Places[i].PlaneRank, static_cast<int>(maximum));
    }
  }
}

//----------------------------------------------------------------------------
TEST(UndecidedPlaces, NoneWithoutJoins)
{
  const Input input = RandomConsistentInput(5);
  const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
  const UndecidedPlaces none = FindUndecidedPlaces(GeometryOf(result), {});
  EXPECT_TRUE(none.Places.empty());
  EXPECT_TRUE(none.Planes.empty());
}

//----------------------------------------------------------------------------
/// Slices of vessels thinner than the distance of the planes: whoever adds the proposed slices
/// knows more.
TEST(UndecidedPlaces, ProposedSlicesSettleThinVessels)
{
  const std::array<Point3, 6> directions{ { { 1.0, 0.1, 0.05 }, { 0.05, 1.0, 0.12 },
    { 0.07, 0.11, 1.0 }, { 1.0, 0.8, 0.1 }, { 0.1, 0.9, 1.0 }, { 0.6, 0.7, 0.8 } } };
  double first = 0.0, last = 0.0;
  for (const Point3& d : directions)
  {
    SCOPED_TRACE(::testing::Message() << d[0] << ", " << d[1] << ", " << d[2]);
    Solid solid;
    solid.Low = { -1.211, -1.223, -1.237 };
    solid.High = { 1.217, 1.213, 1.229 };
    solid.Tubes = { Capsule({ -0.9 * d[0], -0.9 * d[1], -0.9 * d[2] },
                      { 0.9 * d[0], 0.9 * d[1], 0.9 * d[2] }, 0.08),
      Ball({ 0.0, 0.0, 0.0 }, 0.4) };
    PlaneSets planes = EqualPlanes(solid, { 8, 8, 8 });
    const auto undecided = [&]
    {
      return Reconstruct(SliceSolid(solid, planes, 6, InPlaneGrid::Free), Options(), Execution())
        .Undecided;
    };
    const UndecidedPlaces before = undecided();
    UndecidedPlaces now = before;
    for (int round = 0; round < 8 && !now.Planes.empty(); ++round)
    {
      std::vector<double>& axis = planes[now.Planes[0].Axis];
      axis.insert(std::lower_bound(axis.begin(), axis.end(), now.Planes[0].Coordinate),
        now.Planes[0].Coordinate);
      now = undecided();
    }
    EXPECT_TRUE(before.Places.empty() || TotalOf(now) < TotalOf(before));
    first += TotalOf(before);
    last += TotalOf(now);
  }
  EXPECT_GT(first, 6.0);
  EXPECT_LE(last, first / 4);
}
