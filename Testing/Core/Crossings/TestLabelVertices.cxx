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

/// Follows the winding numbers of both slices along every grid line, by signs alone: at all
/// vertices they are the same, 0 or 1.
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
/// Contours of which those of some axes are virtual.
Contours WithVirtual(const std::string& text, const std::array<bool, 3>& isVirtual)
{
  Contours contours = ParseContours(text);
  for (const std::int8_t axis : contours.Axis)
  {
    contours.Virtual.push_back(isVirtual[axis] ? 1 : 0);
  }
  return contours;
}

/// Of the octahedron's squares that of z leaves the origin out.
const char* const ZContradicts = "x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                                 "z=0: 0.2,0.2 0.8,0.2 0.8,0.8 0.2,0.8";

//----------------------------------------------------------------------------
/// One real slice against two virtual ones, which get a loop each; no weight helps them.
TEST(LabelVertices, ARealSliceOutranksVirtualOnes)
{
  Registered data(WithVirtual(ZContradicts, { true, true, false }));
  EXPECT_EQ(data.Label({ 5.0, 5.0, 0.0 }), 0);
  ASSERT_EQ(data.Crossings.Count(), 16);
  for (Index c = 8; c < 16; ++c)
  {
    const GridEdge edge = GridEdgeCode(data.Grid).Decode(data.Crossings.Edge[c]);
    EXPECT_TRUE(IsVirtualSlice(data.Grid, edge, data.Crossings.Family[c]));
  }
  EXPECT_TRUE(data.Repairs.empty());
  ExpectLabels(data, 0);
}

//----------------------------------------------------------------------------
/// Real slices across y and z contradict each other: the virtual one decides if they are as heavy.
TEST(LabelVertices, AVirtualSliceHasTheCastingVote)
{
  for (const double weight : { 1.0, 2.0 })
  {
    Registered data(WithVirtual(ZContradicts, { true, false, false }));
    EXPECT_EQ(data.Label({ 9.0, 1.0, weight }), 1);
    ASSERT_EQ(data.Repairs.size(), 1u);
    EXPECT_EQ(data.Repairs[0].Axis, weight == 1.0 ? 2 : 1);
    ExpectLabels(data, 0);
  }
}

//----------------------------------------------------------------------------
/// The majority decides among virtual slices, whatever the weights; nothing is reported.
TEST(LabelVertices, VirtualSlicesAloneAreEqual)
{
  Registered data(WithVirtual(ZContradicts, { true, true, true }));
  EXPECT_EQ(data.Label({ 0.0, 0.0, 9.0 }), 0);
  EXPECT_EQ(data.Crossings.Count(), 12);
  EXPECT_TRUE(data.Repairs.empty());
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
