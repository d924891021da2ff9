// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/DoubtfulJoins.h"

#include "Core/Reconstruct.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Two stacks of squares, `wide` and 1 wide, on four z-slices at a distance of 1 and 5 apart: the
/// cycles of the slab between the second and the third slice, and joins between them to be made up.
class TwoStacks : public ::testing::Test
{
protected:
  void Slice(double wide)
  {
    std::string text;
    for (int z = 0; z < 4; ++z)
    {
      const std::string high = std::to_string(wide);
      text += "z=" + std::to_string(z) + ": 0,0 " + high + ",0 " + high + "," + high + " 0," +
        high + "; z=" + std::to_string(z) + ": 5,0 6,0 6,1 5,1\n";
    }
    Options options;
    options.Several = SeveralCycles::Discs;
    this->Result = Reconstruct(ParsePieces(text), options, Execution());
    const CycleGeometry geometry = GeometryOf(this->Result);
    for (Index cycle = 0; cycle < geometry.Cycles.Count(); ++cycle)
    {
      if (geometry.Cycles.Cell[cycle][2] == 2)
      {
        this->Cycles.push_back(cycle);
      }
    }
    ASSERT_EQ(this->Cycles.size(), 4u);
    // All in one component, unless a test says otherwise.
    std::fill(this->Result.Graph.Component.begin(), this->Result.Graph.Component.end(), 0);
  }

  CycleJoin Join(int first, int second, double evidence) const
  {
    CycleJoin join{ this->Cycles[first], this->Cycles[second] };
    join.Evidence = evidence;
    return join;
  }

  std::size_t Count(const std::vector<CycleJoin>& joins) const
  {
    return FindDoubtfulJoins(GeometryOf(this->Result), joins).size();
  }

  Reconstruction Result;
  std::vector<Index> Cycles;
};
}

//----------------------------------------------------------------------------
TEST_F(TwoStacks, OddsLessThanTwoToOneAreNearEven)
{
  this->Slice(1.0);
  EXPECT_NEAR(1.0 / (1.0 + std::exp(-NearEvenEvidence)), 2.0 / 3.0, 1e-3);
  for (const double sign : { 1.0, -1.0 })
  {
    EXPECT_EQ(this->Count({ this->Join(0, 1, sign * 0.99 * NearEvenEvidence) }), 1u);
    EXPECT_EQ(this->Count({ this->Join(0, 1, sign * 1.01 * NearEvenEvidence) }), 0u);
  }
  EXPECT_EQ(this->Count({}), 0u);
}

//----------------------------------------------------------------------------
TEST_F(TwoStacks, WhatIsImpossibleIsDoubtful)
{
  this->Slice(1.0);
  CycleJoin join = this->Join(0, 1, 5.0);
  EXPECT_EQ(this->Count({ join }), 0u);
  join.Impossible = true;
  EXPECT_EQ(this->Count({ join }), 1u);
}

//----------------------------------------------------------------------------
TEST_F(TwoStacks, NarrowPartsDoNotMatterUnlessTheyAreApart)
{
  // The diagonal of a square is 1.414 times its side.
  const double side = WidthThatMatters / std::sqrt(2.0);
  for (const double factor : { 0.99, 1.01 })
  {
    this->Cycles.clear();
    this->Slice(factor * side);
    // The small square above the small square: the cycles of a slab ascend by slice.
    std::vector<CycleJoin> joins;
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        joins.push_back(this->Join(i, j, 0.1));
      }
    }
    // Of the six pairs one is of two wide squares.
    EXPECT_EQ(this->Count(joins), factor < 1.0 ? 1u : 6u);
  }
  this->Cycles.clear();
  this->Slice(0.1);
  const CycleGeometry geometry = GeometryOf(this->Result);
  const CycleJoin join = this->Join(0, 1, 0.1);
  this->Result.Graph.Component[geometry.PartOf(join.First)] = 1;
  EXPECT_EQ(this->Count({ join }), 1u);
}

//----------------------------------------------------------------------------
TEST_F(TwoStacks, WhatOtherJoinsHaveSettledIsNoDoubt)
{
  this->Slice(1.0);
  CycleJoin open = this->Join(0, 2, 0.1);
  CycleJoin first = this->Join(0, 1, 4.0), second = this->Join(1, 2, 4.0);
  EXPECT_EQ(this->Count({ open, first, second }), 1u);
  first.Chosen = true;
  EXPECT_EQ(this->Count({ open, first, second }), 1u);
  second.Chosen = true;
  EXPECT_EQ(this->Count({ open, first, second }), 0u);

  // An isolated contour that has gone on elsewhere asks for no join.
  open.OnlyConnects = true;
  EXPECT_EQ(this->Count({ open }), 0u);
  open.Chosen = true;
  EXPECT_EQ(this->Count({ open }), 1u);
  open.Chosen = false;
  this->Result.Graph.Component[GeometryOf(this->Result).PartOf(open.First)] = 1;
  EXPECT_EQ(this->Count({ open }), 1u);
}
