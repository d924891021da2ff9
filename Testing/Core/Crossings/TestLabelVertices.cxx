// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/LabelVertices.h"

#include "Support/RandomInput.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <map>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Contours, registered and filed but not reconciled.
struct Registered
{
  explicit Registered(Contours&& contours)
    : Set(std::move(contours))
    , Grid(BuildSpatialGrid(this->Set, Stages::Tolerance))
  {
    this->File();
  }
  explicit Registered(const Input& input)
  {
    this->Set = UsableContours(input.Sets, input.Settings, this->Grid);
    this->File();
  }

  Index Label(const AxisWeights& weights = { 1.0, 1.0, 1.0 }, int background = 0)
  {
    return LabelVertices({ this->Grid, this->Crossings, this->Edges, this->Isolated }, weights,
      background, this->Repairs);
  }

  Contours Set;
  SpatialGrid Grid;
  std::vector<IsolatedLoop> Isolated;
  GridCrossings Crossings;
  EdgeRegister Edges;
  std::vector<Repair> Repairs;

private:
  void File()
  {
    this->Crossings = RegisterCrossings(this->Set, this->Grid, Execution(), this->Isolated);
    this->Edges = FileOnEdges(this->Crossings);
  }
};

/// Follows the winding numbers of both slices along every grid line, by signs alone: at all vertices
/// they are the same, 0 or 1.
void ExpectLabels(Registered& data, int background)
{
  const CrossingTables tables{ data.Grid, data.Crossings, data.Edges, data.Isolated };
  std::map<std::array<Index, 3>, std::array<int, 2>> atEnd; // of each grid line
  for (Index e = 0; e < data.Edges.Count(); ++e)
  {
    const GridEdge edge = tables.EdgeOf(e);
    auto& winding = atEnd
                      .try_emplace({ edge.Direction, edge.First, edge.Second },
                        std::array<int, 2>{ background, background })
                      .first->second;
    ASSERT_EQ(winding[0], winding[1]);
    for (const int family : { 0, 1 })
    {
      winding[family] += tables.SignSum(e, family);
    }
    ASSERT_EQ(winding[0], winding[1]);
    ASSERT_TRUE(winding[0] == 0 || winding[0] == 1) << winding[0];
  }
  for (const auto& line : atEnd)
  {
    EXPECT_EQ(line.second[0], background);
  }
}
}

//----------------------------------------------------------------------------
/// Two slices have the origin inside; the third gets a loop of four crossings at the origin.
TEST(LabelVertices, InsertsALoopWhereASliceIsOverruled)
{
  Registered data(ParseContours("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                                "z=0: 0.2,0.2 0.8,0.2 0.8,0.8 0.2,0.8"));
  EXPECT_EQ(data.Label(), 1);
  ASSERT_EQ(data.Crossings.Count(), 12);
  for (Index c = 8; c < 12; ++c)
  {
    EXPECT_EQ(data.Crossings.Position[c], 0.0);
    EXPECT_EQ(data.Crossings.RunContour[c], GridCrossings::None);
    EXPECT_EQ(data.Crossings.Previous[data.Crossings.Next[c]], c);
  }
  EXPECT_EQ(
    data.Crossings.Next[data.Crossings.Next[data.Crossings.Next[data.Crossings.Next[8]]]], 8);
  ASSERT_EQ(data.Repairs.size(), 1u);
  EXPECT_EQ(data.Repairs[0].Kind, RepairKind::VertexRelabelled);
  EXPECT_EQ(data.Repairs[0].Axis, 2);
  EXPECT_EQ(data.Repairs[0].Where, (Point3{ 0.0, 0.0, 0.0 }));
  ExpectLabels(data, 0);
}

//----------------------------------------------------------------------------
/// The same with a heavier z-slice: the two others get loops that take the origin out.
TEST(LabelVertices, TheGreaterWeightDecides)
{
  Registered data(ParseContours("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                                "z=0: 0.2,0.2 0.8,0.2 0.8,0.8 0.2,0.8"));
  EXPECT_EQ(data.Label({ 1.0, 1.0, 2.5 }), 1);
  EXPECT_EQ(data.Crossings.Count(), 16);
  ASSERT_EQ(data.Repairs.size(), 2u);
  EXPECT_EQ(data.Repairs[0].Axis, 0);
  EXPECT_EQ(data.Repairs[1].Axis, 1);
  // The x-slice crosses the axes at a distance of 1 from the vertex.
  EXPECT_EQ(data.Repairs[0].Size, 1.0);
  ExpectLabels(data, 0);
}

//----------------------------------------------------------------------------
TEST(LabelVertices, LeavesSlicesThatAgree)
{
  Registered data(ParseContours(Cube()));
  const Index before = data.Crossings.Count();
  EXPECT_EQ(data.Label(), 0);
  EXPECT_EQ(data.Crossings.Count(), before);
  EXPECT_TRUE(data.Repairs.empty());
}

//----------------------------------------------------------------------------
TEST(LabelVertices, AfterwardsAllSlicesAgreeAtEveryVertex)
{
  Index vertices = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    Registered data(RandomContradictoryInput(seed));
    SCOPED_TRACE(seed);
    vertices += data.Label();
    ExpectLabels(data, 0);
  }
  EXPECT_GT(vertices, 100);
}
