// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/CreasePatch.h"

#include "Core/Base/Vectors.h"
#include "Support/CheckPatch.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
struct Crease
{
  Crease(const Stages& stages, const std::array<Index, 3>& cell)
  {
    const auto& cells = stages.Cycles.Cell;
    this->Cycle = static_cast<Index>(std::find(cells.begin(), cells.end(), cell) - cells.begin());
    this->Normals = EstimateNormals(stages.Geometry(), 1.05, {}, Execution());
    this->Border.Set(stages.Geometry(), this->Normals, this->Cycle);
    this->Deviation =
      BuildCreasePatch(stages.Grid, this->Border, this->Normals.Corners, this->Patch);
  }

  Index Cycle = 0;
  SurfaceNormals Normals;
  PatchBorder Border;
  InnerPatch Patch;
  double Deviation = 0.0;
};

/// The most that a weak pull to the middle of the border may do.
constexpr double Pull = 3e-3;
}

//----------------------------------------------------------------------------
TEST(CreasePatch, PointOfACubesVertexIsTheVertex)
{
  const Stages stages{ Cube() };
  for (const Index x : { 0, 2 })
  {
    for (const Index z : { 0, 2 })
    {
      const Crease crease(stages, { x, 0, z });
      ASSERT_EQ(crease.Patch.Points.size(), 1u);
      const Point3 vertex{ x == 0 ? 0.5 : 2.5, 0.5, z == 0 ? 0.5 : 2.5 };
      EXPECT_LT(Length(crease.Patch.Points[0] - vertex), Pull);
      EXPECT_LT(crease.Deviation, Pull);
      EXPECT_TRUE(HasCorner(crease.Border, crease.Normals.Corners));
    }
  }
}

//----------------------------------------------------------------------------
TEST(CreasePatch, PointOfACubesEdgeLiesOnIt)
{
  const Stages stages{ Cube() };
  const Crease crease(stages, { 0, 0, 1 });
  ASSERT_EQ(crease.Patch.Points.size(), 1u);
  EXPECT_NEAR(crease.Patch.Points[0][0], 0.5, Pull);
  EXPECT_NEAR(crease.Patch.Points[0][1], 0.5, Pull);
  EXPECT_NEAR(crease.Patch.Points[0][2], 1.5, 1e-9); // free along the edge: in the middle
  EXPECT_LT(crease.Deviation, Pull);
}

//----------------------------------------------------------------------------
TEST(CreasePatch, OfAFlatBorderIsItsCenter)
{
  const Stages stages{ Cube() };
  const Crease crease(stages, { 1, 1, 0 });
  EXPECT_LT(Length(crease.Patch.Points.at(0) - Point3{ 1.5, 1.5, 0.5 }), 1e-9);
  EXPECT_FALSE(HasCorner(crease.Border, crease.Normals.Corners));
  EXPECT_LT(crease.Deviation, 1e-6);
}

//----------------------------------------------------------------------------
TEST(CreasePatch, IsAFanWithItsPointInsideTheCell)
{
  Index cycles = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    const SurfaceNormals normals = EstimateNormals(stages.Geometry(), 0.5, {}, Execution());
    PatchBorder border;
    InnerPatch patch;
    for (Index cycle = 0; cycle < stages.Cycles.Count(); ++cycle)
    {
      border.Set(stages.Geometry(), normals, cycle);
      if (!HasCorner(border, normals.Corners))
      {
        continue;
      }
      const double deviation = BuildCreasePatch(stages.Grid, border, normals.Corners, patch);
      EXPECT_GE(deviation, 0.0);
      EXPECT_EQ(std::isfinite(deviation), patch.Points.size() == 1);
      if (!std::isfinite(deviation))
      {
        continue; // its planes meet too far away
      }
      ++cycles;
      const PatchMesh mesh{ PatchKind::Joined, { cycle }, patch.Points, patch.Triangles };
      ASSERT_EQ(DescribePatchFlaws(stages.Geometry(), mesh), "") << seed << ", " << cycle;
      EXPECT_EQ(patch.Triangles.size(), border.Points.size());
      EXPECT_EQ(patch.Normals, std::vector<Point3>(1, Point3{ 0, 0, 0 }));
    }
  }
  EXPECT_GT(cycles, 100);
}

//----------------------------------------------------------------------------
TEST(CreasePatch, CornersSayNothing)
{
  const Stages stages{ Cube() };
  Crease crease(stages, { 0, 0, 1 });
  const Point3 before = crease.Patch.Points[0];
  for (Index i = 0; i < crease.Border.Count(); ++i)
  {
    if (crease.Normals.Corners[crease.Border.Points[i]] != 0)
    {
      crease.Border.Normals[i] = { 0.0, 0.0, 1.0 };
    }
  }
  BuildCreasePatch(stages.Grid, crease.Border, crease.Normals.Corners, crease.Patch);
  EXPECT_EQ(crease.Patch.Points[0], before);
}
