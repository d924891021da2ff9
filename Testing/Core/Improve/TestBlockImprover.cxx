// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/BlockImprover.h"

#include "Support/ClosedMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A ball of radius 1 whose rings of 16 points lie alternately close together and much more apart.
ImprovableMesh BallOfPairs()
{
  const PlainMesh mesh = support::BallOfPairs(16, -0.75, 0.25, 0.004);
  const Index count = static_cast<Index>(mesh.Points.size());
  return { CornerTable(count, mesh.Triangles), mesh.Points, mesh.Points };
}

/// How many triangles are to be looked at once more, when a block with all of a mesh was improved.
std::ptrdiff_t CountAgain(const ImprovableMesh& mesh, const BlockCells& cells)
{
  SpatialGrid grid;
  grid.Lowest = { -10.0, -10.0, -10.0 };
  grid.Highest = { 10.0, 10.0, 10.0 };
  const ImprovementLimits limits{ 0.01, 22.0 };
  std::vector<Index> all(static_cast<std::size_t>(mesh.Corners.CornerCount()) / 3);
  std::iota(all.begin(), all.end(), 0);
  MeshBlock block(mesh, Everywhere(), cells, all.data(), all.data() + all.size(), 0);
  BlockImprover improver(grid, limits, 0, block, SurfaceSamples(mesh, limits));
  improver.Run(Round::First, std::vector<std::uint8_t>(all.size(), 0));
  std::ptrdiff_t count = 0;
  for (Index triangle = 0; 3 * triangle < block.Mesh.Corners.CornerCount(); ++triangle)
  {
    count += block.Mesh.Corners.IsAlive(3 * triangle) && improver.IsOpen(triangle) ? 1 : 0;
  }
  return count;
}
}

//----------------------------------------------------------------------------
/// Of a block that has the small cubes with the surface only, larger triangles stick out. So some
/// slivers stay; they are to be tried where the block has more around them.
TEST(BlockImprover, WhatWouldLeaveTheBlockIsTriedAgain)
{
  const ImprovableMesh mesh = BallOfPairs();
  BlockCells close({ -1.1, -1.1, -1.1 }, 2.2), whole = close;
  for (Index triangle = 0; 3 * triangle < mesh.Corners.CornerCount(); ++triangle)
  {
    close.Add(BoxOfPart(mesh, triangle));
  }
  whole.Add(Everywhere());
  EXPECT_GT(CountAgain(mesh, close), 0);
  EXPECT_EQ(CountAgain(mesh, whole), 0);
}
