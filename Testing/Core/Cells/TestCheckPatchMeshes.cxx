// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CheckPatchMeshes.h"

#include "Support/Stages.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Triangles = std::vector<std::array<Index, 3>>;

/// The border of a cycle as a fan around its point -1.
Triangles FanOf(const Stages& stages, Index cycle)
{
  const Index count = static_cast<Index>(stages.Geometry().GetBorders({ cycle }).size());
  Triangles triangles;
  for (Index i = 0; i < count; ++i)
  {
    triangles.push_back({ i, (i + 1) % count, -1 });
  }
  return triangles;
}
}

//----------------------------------------------------------------------------
TEST(CheckPatchMeshes, AFanCoversItsBorder)
{
  const Stages stages{ Cube(3) };
  for (Index cycle = 0; cycle < stages.Cycles.Count(); ++cycle)
  {
    EXPECT_EQ(CheckPatchCoversBorders(stages.Geometry(), { cycle }, FanOf(stages, cycle)), "");
  }
}

//----------------------------------------------------------------------------
TEST(CheckPatchMeshes, FindsAHoleATurnedTriangleAndOneTooMany)
{
  const Stages stages{ Cube() };
  Triangles hole = FanOf(stages, 0);
  hole.pop_back();
  EXPECT_NE(CheckPatchCoversBorders(stages.Geometry(), { 0 }, hole), "");
  Triangles turned = FanOf(stages, 0);
  std::swap(turned[0][0], turned[0][1]);
  EXPECT_NE(CheckPatchCoversBorders(stages.Geometry(), { 0 }, turned), "");
  Triangles twice = FanOf(stages, 0);
  twice.push_back(twice.front());
  EXPECT_NE(CheckPatchCoversBorders(stages.Geometry(), { 0 }, twice), "");
  EXPECT_NE(CheckPatchCoversBorders(stages.Geometry(), { 0, 1 }, FanOf(stages, 0)), "");
}

//----------------------------------------------------------------------------
TEST(CheckPatchMeshes, FindsACycleWithTwoPatches)
{
  const Stages stages{ Cube() };
  PatchMesh mesh;
  mesh.Cycles = { 0 };
  mesh.Points = { { 0, 0, 0 } };
  mesh.Triangles = FanOf(stages, 0);
  EXPECT_EQ(CheckPatchMeshes(stages.Geometry(), { mesh }), "");
  EXPECT_NE(CheckPatchMeshes(stages.Geometry(), { mesh, mesh }), "");
}
