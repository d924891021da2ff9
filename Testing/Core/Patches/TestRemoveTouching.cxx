// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/RemoveTouching.h"

#include "Core/Base/Vectors.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A thin plate: in the middle cell, two square sheets at z = 1.45 and 1.55, and no slice between.
class RemoveTouchingTest : public testing::Test
{
protected:
  RemoveTouchingTest()
    : Slices("x=1: 0.5,1.45 2.5,1.45 2.5,1.55 0.5,1.55; x=2: 0.5,1.45 2.5,1.45 2.5,1.55 0.5,1.55;"
             "y=1: 1.45,0.5 1.55,0.5 1.55,2.5 1.45,2.5; y=2: 1.45,0.5 1.55,0.5 1.55,2.5 1.45,2.5")
    , Geometry(Slices.Geometry())
    , Cells(GroupByCell(Slices.Grid, Slices.Cycles, Execution()))
    , MeshOf(Slices.Cycles.Count(), -1)
  {
    for (Index cycle = 0; cycle < this->Slices.Cycles.Count(); ++cycle)
    {
      std::vector<Index> border, places;
      this->Geometry.GetBoundary(cycle, border, places);
      Point3 center{ 0.0, 0.0, 0.0 };
      for (const Index point : border)
      {
        center =
          center + (1.0 / static_cast<double>(border.size())) * this->Slices.Graph.PointAt(point);
      }
      this->CentralPoints.insert(this->CentralPoints.end(), center.begin(), center.end());
      if (this->Slices.Cycles.Cell[cycle] == std::array<Index, 3>{ 1, 1, 0 })
      {
        (center[2] < 1.5 ? this->Lower : this->Upper) = cycle;
      }
    }
  }

  /// The fan of a cycle around a point.
  InnerPatch FanAround(Index cycle, const Point3& point) const
  {
    InnerPatch patch;
    patch.Points = { point };
    patch.Normals = { { 0.0, 0.0, 0.0 } };
    const Index size = static_cast<Index>(this->Geometry.GetBorders({ cycle }).size());
    for (Index i = 0; i < size; ++i)
    {
      patch.Triangles.push_back({ -1, i, (i + 1) % size });
    }
    return patch;
  }

  /// The cycles that have a patch left, of those sheets of the middle cell that had one.
  std::vector<Index> Left(const std::vector<std::pair<Index, double>>& heights) const
  {
    InnerPatches patches;
    for (Index cycle = 0; cycle < this->Slices.Cycles.Count(); ++cycle)
    {
      for (const auto& height : heights)
      {
        if (height.first == cycle)
        {
          patches.Add(cycle, this->FanAround(cycle, { 1.5, 1.5, height.second }));
        }
      }
    }
    RemoveTouching(
      { this->Geometry, this->Cells, this->Normals, this->CentralPoints, this->Meshes },
      this->MeshOf, Execution(), patches);
    return patches.Cycle;
  }

  Stages Slices;
  CycleGeometry Geometry;
  CellGroups Cells;
  SurfaceNormals Normals;
  std::vector<double> CentralPoints;
  std::vector<PatchMesh> Meshes;
  std::vector<Index> MeshOf;
  Index Lower = -1, Upper = -1;
};
}

//----------------------------------------------------------------------------
TEST_F(RemoveTouchingTest, LeavesPatchesThatAreApart)
{
  ASSERT_GE(this->Lower, 0);
  ASSERT_GE(this->Upper, 0);
  EXPECT_EQ(this->Left({ { this->Lower, 1.3 }, { this->Upper, 1.7 } }).size(), 2u);
  EXPECT_EQ(this->Left({ { this->Lower, 1.48 }, { this->Upper, 1.52 } }).size(), 2u);
}

//----------------------------------------------------------------------------
TEST_F(RemoveTouchingTest, TakesOutBothPatchesThatCross)
{
  EXPECT_TRUE(this->Left({ { this->Lower, 1.6 }, { this->Upper, 1.4 } }).empty());
}

//----------------------------------------------------------------------------
/// Above the flat fan of the upper sheet, which has no patch, but below the patch of that.
TEST_F(RemoveTouchingTest, TakesOutAPatchThatCrossesAFan)
{
  EXPECT_TRUE(this->Left({ { this->Lower, 1.6 } }).empty());
  EXPECT_EQ(this->Left({ { this->Lower, 1.6 }, { this->Upper, 1.7 } }).size(), 2u);
}

//----------------------------------------------------------------------------
TEST_F(RemoveTouchingTest, TakesOutAPatchThatCrossesAMesh)
{
  const InnerPatch upper = this->FanAround(this->Upper, { 1.5, 1.5, 1.7 });
  this->Meshes.push_back({ PatchKind::Joined, { this->Upper }, upper.Points, upper.Triangles });
  this->MeshOf[this->Upper] = 0;
  EXPECT_EQ(this->Left({ { this->Lower, 1.6 } }), std::vector<Index>{ this->Lower });
  EXPECT_TRUE(this->Left({ { this->Lower, 1.8 } }).empty());
}
