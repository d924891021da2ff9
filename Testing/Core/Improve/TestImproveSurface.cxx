// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/ImproveSurface.h"

#include "Core/Reconstruct.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SliceSolid.h"
#include "Support/SmoothSolids.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Options Light(double accuracy)
{
  Options options;
  options.Patching.Accuracy = accuracy;
  return options;
}

PieceSets LightTorus()
{
  const SmoothSolid solid = SmoothTorus();
  return SliceSolid(solid, EqualPlanes(solid, { 12, 12, 12 }), 8, InPlaneGrid::Aligned);
}
}

//----------------------------------------------------------------------------
TEST(ImproveSurface, PatchesKeepTheirTriangles)
{
  const Reconstruction result = Reconstruct(LightTorus(), Light(0.025), Execution());
  const Patches& patches = result.Surface;
  ASSERT_TRUE(patches.Improved.Any());
  EXPECT_EQ(static_cast<std::size_t>(3 * patches.TriangleCount()), patches.Improved.Corners.size());
  EXPECT_EQ(patches.Offsets.size(), static_cast<std::size_t>(result.Cycles.Count()) + 1);
  EXPECT_TRUE(std::is_sorted(patches.Offsets.begin(), patches.Offsets.end()));
  EXPECT_TRUE(std::is_sorted(patches.Improved.Origin.begin(), patches.Improved.Origin.end()));
  EXPECT_EQ(3 * patches.Improved.Origin.size(), patches.Improved.Points.size());
  EXPECT_EQ(DescribeFlaws(MeshOf(result)), "");
}

//----------------------------------------------------------------------------
/// Contours that contradict each other, and solids of any shape: closed and embedded.
TEST(ImproveSurface, RandomInputStaysEmbedded)
{
  const std::uint64_t first = FirstSeed();
  for (std::uint64_t seed = first; seed < first + RandomRuns(60); ++seed)
  {
    Input input = seed % 2 == 0 ? RandomConsistentInput(seed) : RandomContradictoryInput(seed);
    SCOPED_TRACE(input.Name);
    input.Settings.Patching.Accuracy = seed % 3 == 0 ? 0.2 : 0.03;
    const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
    EXPECT_EQ(DescribeFlaws(MeshOf(result)), "");
  }
}

//----------------------------------------------------------------------------
/// One, two and three families of few planes across thin tubes: patches of several polygons, fans
/// of many triangles, walls near each other.
TEST(ImproveSurface, SparseInputStaysEmbedded)
{
  const std::uint64_t first = FirstSeed();
  for (std::uint64_t seed = first; seed < first + RandomRuns(60); ++seed)
  {
    Input input = RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    input.Settings.Patching.OwnAccuracy = seed % 2 == 0;
    input.Settings.Patching.Accuracy = seed % 2 == 0 ? 0.0 : 0.1;
    const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
    EXPECT_EQ(DescribeFlaws(MeshOf(result)), "");
  }
}

//----------------------------------------------------------------------------
TEST(ImproveSurface, TheSameForAnyNumberOfThreads)
{
  const Reconstruction one = Reconstruct(LightTorus(), Light(0.03), Execution());
  const Reconstruction many = Reconstruct(LightTorus(), Light(0.03), ManyThreads());
  EXPECT_EQ(one.Surface.Improved.Points, many.Surface.Improved.Points);
  EXPECT_EQ(one.Surface.Improved.Corners, many.Surface.Improved.Corners);
}
