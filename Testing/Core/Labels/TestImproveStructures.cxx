// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/ImproveStructures.h"

#include "Core/ReconstructLabels.h"
#include "Support/CheckEmbedding.h"
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
/// Two labels that are the same torus.
LabelSurfaces ReconstructTwice(const Execution& execution)
{
  const SmoothSolid solid = SmoothTorus();
  std::vector<SortedSlices> labels(2);
  for (SortedSlices& label : labels)
  {
    label.Slices = SliceSolid(solid, EqualPlanes(solid, { 12, 12, 12 }), 8, InPlaneGrid::Aligned);
    for (Pieces& pieces : label.Slices)
    {
      pieces.Cell.assign(pieces.Cell.size(), 0);
    }
    label.From = { { 0 }, { 0 }, { 0 } };
  }
  Options options;
  options.Patching.Accuracy = 0.025;
  return ReconstructLabels(std::move(labels), options, execution);
}
}

//----------------------------------------------------------------------------
TEST(ImproveStructures, WhatIsCommonStaysCommon)
{
  const LabelSurfaces surfaces = ReconstructTwice(Execution());
  ASSERT_EQ(surfaces.OfLabel.size(), 2u);
  const Patches &first = surfaces.OfLabel[0].Surface, &second = surfaces.OfLabel[1].Surface;
  ASSERT_TRUE(first.Improved.Any());
  EXPECT_EQ(first.Improved.Points, second.Improved.Points);
  EXPECT_EQ(first.Improved.Corners, second.Improved.Corners);
  EXPECT_EQ(first.Improved.Origin, second.Improved.Origin);
  EXPECT_EQ(first.Offsets, second.Offsets);
  EXPECT_EQ(static_cast<std::size_t>(3 * first.TriangleCount()), first.Improved.Corners.size());
  EXPECT_TRUE(std::is_sorted(first.Offsets.begin(), first.Offsets.end()));
  EXPECT_EQ(DescribeFlaws(MeshOf(surfaces.OfLabel[0])), "");
}

//----------------------------------------------------------------------------
TEST(ImproveStructures, TheSameForAnyNumberOfThreads)
{
  const LabelSurfaces one = ReconstructTwice(Execution()), many = ReconstructTwice(ManyThreads());
  EXPECT_EQ(one.OfLabel[0].Surface.Improved.Points, many.OfLabel[0].Surface.Improved.Points);
  EXPECT_EQ(one.OfLabel[0].Surface.Improved.Corners, many.OfLabel[0].Surface.Improved.Corners);
}

//----------------------------------------------------------------------------
/// It asks often whether to go on, at the end of the progress of all stages before.
TEST(ImproveStructures, CanBeStopped)
{
  int asked = 0;
  Execution execution;
  execution.Continue = [&](double progress)
  {
    asked += progress == 0.75 ? 1 : 0;
    return asked < 20;
  };
  EXPECT_TRUE(ReconstructTwice(execution).Stopped);
  EXPECT_EQ(asked, 20);
}
