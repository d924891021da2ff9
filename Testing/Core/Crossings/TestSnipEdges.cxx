// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/SnipEdges.h"

#include "Core/Crossings/CheckCrossings.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// The square of Octahedron() in three slices, but that of z has another form.
struct Snipped
{
  /// The slices across the axes of `isVirtual` are virtual ones.
  explicit Snipped(const std::string& zSlice,
    const std::array<bool, 3>& isVirtual = { false, false, false }, bool ofStructures = false)
  {
    this->Set = ParseContours("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1; z=0:" + zSlice);
    for (const std::int8_t axis : this->Set.Axis)
    {
      this->Set.Virtual.push_back(isVirtual[axis] ? 1 : 0);
    }
    this->Grid = BuildSpatialGrid(this->Set, Stages::Tolerance);
    this->Grid.BothWays = ofStructures;
    this->Crossings = RegisterCrossings(this->Set, this->Grid, Execution(), this->Isolated);
    this->Before = this->Crossings.Count();
    this->Edges = FileOnEdges(this->Crossings);
    this->SnippedEdges =
      SnipEdges({ this->Grid, this->Crossings, this->Edges, this->Isolated }, 0, this->Repairs);
  }

  Index Removed() const
  {
    Index removed = 0;
    for (Index c = 0; c < this->Crossings.Count(); ++c)
    {
      removed += this->Crossings.IsRemoved(c) ? 1 : 0;
    }
    return removed;
  }

  /// The vertices of the z-slice that are left.
  Index CountVertices() const
  {
    Index vertices = 0;
    for (Index c = 0; c < this->Crossings.Count(); ++c)
    {
      for (Index run = this->Crossings.IsRemoved(c) ? GridCrossings::None : c;
           run != GridCrossings::None; run = this->Crossings.RunNext[run])
      {
        vertices += this->Crossings.RunContour[run] == 2 ? this->Crossings.RunCount[run] : 0;
      }
    }
    return vertices;
  }

  Contours Set;
  SpatialGrid Grid;
  std::vector<IsolatedLoop> Isolated;
  GridCrossings Crossings;
  EdgeRegister Edges;
  std::vector<Repair> Repairs;
  Index Before, SnippedEdges;
};
}

//----------------------------------------------------------------------------
TEST(SnipEdges, LeavesSlicesThatAgree)
{
  const Snipped data(" -1,-1 1,-1 1,1 -1,1");
  EXPECT_EQ(data.SnippedEdges, 0);
  EXPECT_EQ(data.Removed(), 0);
  EXPECT_TRUE(data.Repairs.empty());
}

//----------------------------------------------------------------------------
/// A notch across the x-axis, between x = 0.4667 and 0.5333, which the y-slice does not have.
TEST(SnipEdges, TakesOutADentThatOneSliceHasAlone)
{
  const Snipped data(" -1,-1 0.4,-1 0.5,0.5 0.6,-1 1,-1 1,1 -1,1");
  EXPECT_EQ(data.SnippedEdges, 1);
  EXPECT_EQ(data.Removed(), 2);
  ASSERT_EQ(data.Repairs.size(), 1u);
  EXPECT_EQ(data.Repairs[0].Kind, RepairKind::CrossingsSnipped);
  EXPECT_EQ(data.Repairs[0].Axis, 2);
  EXPECT_NEAR(data.Repairs[0].Where[0], 0.5, 1e-12);
  EXPECT_NEAR(data.Repairs[0].Size, 0.2 / 3.0, 1e-12);
  // The tip of the dent, of one vertex, is left over; the two arcs before and after it are one now.
  EXPECT_TRUE(data.Isolated.empty());
  Index length = 0;
  for (Index c = 0; c < data.Crossings.Count(); ++c)
  {
    if (!data.Crossings.IsRemoved(c) && data.Crossings.RunContour[c] == 2)
    {
      ++length;
      EXPECT_EQ(data.Crossings.Previous[data.Crossings.Next[c]], c);
    }
  }
  EXPECT_EQ(length, 4);
}

//----------------------------------------------------------------------------
/// A notch that ends on the x-axis: of structures, the vertex there stays, and so does all beside it.
TEST(SnipEdges, KeepsATipOfStructuresThatEndsOnALine)
{
  const std::string notch = " -1,-1 0.4,-1 0.5,0 0.6,-1 1,-1 1,1 -1,1";
  EXPECT_EQ(Snipped(notch).CountVertices(), 6);
  const Snipped data(notch, { false, false, false }, true);
  EXPECT_EQ(data.Removed(), 2);
  EXPECT_EQ(data.CountVertices(), 7);
  EXPECT_TRUE(data.Isolated.empty());
}

//----------------------------------------------------------------------------
/// The part that is cut off has three vertices: it is listed, to become a contour of its own.
TEST(SnipEdges, ListsAPartThatClosesInItself)
{
  const Snipped data(" -1,-1 0.4,-1 0.4,0.5 0.5,0.6 0.6,0.5 0.6,-1 1,-1 1,1 -1,1");
  EXPECT_EQ(data.SnippedEdges, 1);
  ASSERT_EQ(data.Isolated.size(), 1u);
  Index vertices = 0;
  for (Index run = data.Isolated[0].FirstRun; run != GridCrossings::None;
       run = data.Crossings.RunNext[run])
  {
    vertices += data.Crossings.RunCount[run];
  }
  EXPECT_EQ(vertices, 3);
}

//----------------------------------------------------------------------------
/// The notch is real, the y-slice is not: that gets a loop of two crossings at the same places.
TEST(SnipEdges, GivesAVirtualSliceWhatARealOneHasAlone)
{
  const Snipped data(
    " -1,-1 0.4,-1 0.5,0.5 0.6,-1 1,-1 1,1 -1,1", std::array<bool, 3>{ true, true, false });
  EXPECT_EQ(data.SnippedEdges, 0);
  EXPECT_EQ(data.Removed(), 0);
  EXPECT_TRUE(data.Repairs.empty());
  ASSERT_EQ(data.Crossings.Count(), data.Before + 2);
  const Index a = data.Before, b = data.Before + 1;
  EXPECT_NEAR(data.Crossings.Position[a], 0.5 - 0.1 / 3.0, 1e-12);
  EXPECT_NEAR(data.Crossings.Position[b], 0.5 + 0.1 / 3.0, 1e-12);
  EXPECT_EQ(data.Crossings.Sign(a), -1);
  EXPECT_EQ(data.Crossings.Sign(b), 1);
  EXPECT_EQ(data.Crossings.Next[a], b);
  EXPECT_EQ(data.Crossings.Next[b], a);
  EXPECT_EQ(CheckCrossingOrder(data.Crossings), "");
  EXPECT_EQ(CheckSlicesAgree(data.Crossings, data.Edges), "");
}

//----------------------------------------------------------------------------
/// The notch is virtual: it is taken out, which is nothing that has to be reported.
TEST(SnipEdges, DoesNotReportWhatItTakesFromAVirtualSlice)
{
  for (const bool allVirtual : { false, true })
  {
    const Snipped data(" -1,-1 0.4,-1 0.5,0.5 0.6,-1 1,-1 1,1 -1,1",
      std::array<bool, 3>{ allVirtual, allVirtual, true });
    EXPECT_EQ(data.Removed(), 2);
    EXPECT_EQ(data.Crossings.Count(), data.Before);
    EXPECT_EQ(data.SnippedEdges, 0);
    EXPECT_TRUE(data.Repairs.empty());
    EXPECT_EQ(CheckSlicesAgree(data.Crossings, data.Edges), "");
  }
}
