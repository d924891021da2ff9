// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/ReconcileSlices.h"

#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <map>

using namespace orthoslices;
using namespace orthoslices::support;

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
