// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   labels that end just on a slice, or are not drawn on one that they reach
 */

#include "Core/Frames/SplitByLabel.h"
#include "Core/ReconstructLabels.h"
#include "Support/CheckLabels.h"
#include "Support/CheckSurface.h"
#include "Support/ReconstructionMesh.h"
#include "Support/TurnedSlices.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A label.
struct Block
{
  Point3 Low, High;
};

/// Whether a label is drawn on a slice.
using Rule = std::function<bool(const Block& block, int axis, double plane)>;

bool IsWithin(const Block& block, int axis, double plane)
{
  return block.Low[axis] < plane && plane < block.High[axis];
}

using Planes = std::array<std::vector<double>, 3>;

/// What is wrong between the surfaces of blocks.
struct Found
{
  Found(const std::vector<Block>& blocks, const Planes& planes, const Rule& isDrawn,
    const Matrix3& matrix);

  SurfaceCheck Check;
  std::int64_t Crossings;
  double Volume, Overlap, Gap;
};

Found::Found(const std::vector<Block>& blocks, const Planes& planes, const Rule& isDrawn,
  const Matrix3& matrix)
{
  PieceSets sets = EmptySets();
  std::vector<Index> labels;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = FirstAxis(axis), v = SecondAxis(axis);
    for (const double plane : planes[axis])
    {
      for (std::size_t i = 0; i < blocks.size(); ++i)
      {
        const Point3 &low = blocks[i].Low, &high = blocks[i].High;
        if (isDrawn(blocks[i], axis, plane))
        {
          AddPiece(sets[axis],
            { { low[u], low[v] }, { high[u], low[v] }, { high[u], high[v] }, { low[u], high[v] } },
            plane);
          labels.push_back(static_cast<Index>(i));
        }
      }
    }
  }
  const SortedSlices sorted = SortByPlanes(MapSlices(sets, matrix), FrameOptions());
  const LabelMesh all = MeshOf(ReconstructLabels(
    SplitByLabel(sorted, labels, static_cast<Index>(blocks.size())), Options(), Execution()));
  const LabelVolumes volumes = MeasureLabels(all.Mesh, all.Labels);
  this->Check = CheckSurface(all.Mesh);
  this->Crossings = CountLabelCrossings(all.Mesh, all.Labels);
  this->Volume = std::accumulate(volumes.OfLabel.begin(), volumes.OfLabel.end(), 0.0);
  this->Overlap = volumes.Overlap / this->Volume;
  this->Gap = volumes.Gap / this->Volume;
}

/// Two blocks on two others, of which the borders lie elsewhere: together a cube.
const std::vector<Block> Stacked{ { { -1, -1, -1 }, { 0.2, 1, 0 } },
  { { 0.2, -1, -1 }, { 1, 1, 0 } }, { { -1, -1, 0 }, { -0.3, 1, 1 } },
  { { -0.3, -1, 0 }, { 1, 1, 1 } } };
}

/// The slice on which two of them end and two begin shows these, or those, or all.
TEST(LabelEnds, OnASliceThatShowsEither)
{
  const Planes planes{ { { -0.8, -0.1, 0.5 }, { -0.7, 0.1, 0.6 }, { -0.6, 0.0, 0.7 } } };
  const Rule lower = [](const Block& block, int axis, double plane)
  { return block.Low[axis] < plane && plane <= block.High[axis]; };
  const Rule upper = [](const Block& block, int axis, double plane)
  { return block.Low[axis] <= plane && plane < block.High[axis]; };
  const Rule both = [](const Block& block, int axis, double plane)
  { return block.Low[axis] <= plane && plane <= block.High[axis]; };
  for (const Rule& rule : { lower, upper, both })
  {
    for (const Matrix3& matrix : { UnitMatrix(), RandomRotation(1) })
    {
      const Found found(Stacked, planes, rule, matrix);
      EXPECT_TRUE(found.Check.IsClosedManifold());
      EXPECT_EQ(found.Crossings, 0);
      EXPECT_LT(found.Overlap, 1e-4);
      EXPECT_GT(found.Volume, 7.6);
    }
  }
}

/// A label that is not drawn on one slice of each axis, its first or last one, fills what the others
/// leave there.
TEST(LabelEnds, OnSlicesThatLackThem)
{
  const Planes planes{ { { -0.8, -0.3, 0.3, 0.8 }, { -0.7, -0.2, 0.3, 0.7 },
    { -0.75, -0.3, 0.35, 0.8 } } };
  const std::vector<Block> blocks{ { { -1, -1, -1 }, { 0.1, 1, 1 } },
    { { 0.1, -1, -1 }, { 1, 1, 1 } } };
  const Rule rule = [&](const Block& block, int axis, double plane)
  {
    const bool isLacking =
      block.Low[0] > 0.0 && plane == (axis == 0 ? planes[axis].back() : planes[axis].front());
    return !isLacking && IsWithin(block, axis, plane);
  };
  const Found found(blocks, planes, rule, UnitMatrix());
  EXPECT_TRUE(found.Check.IsClosedManifold());
  EXPECT_EQ(found.Crossings, 0);
  EXPECT_LT(found.Overlap, 1e-4);
  EXPECT_LT(found.Gap, 2e-3);
  EXPECT_NEAR(found.Volume, 8.0, 0.08);
}
