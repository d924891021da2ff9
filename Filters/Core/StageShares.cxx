// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/StageShares.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// A stage: what the user reads while it runs, and what it takes.
struct StageTime
{
  Stage Of;
  const char* Text;
  double Time;      ///< in units of which all stages of three families take about 100
  LoopShares Loops; ///< of which that consists
};

/// In the order of the enumeration.
constexpr std::size_t Count = static_cast<std::size_t>(Stage::ImproveSurface) + 1;
const std::array<StageTime, Count> Times{ {
  { Stage::AssembleContours, "Closing contours", 0.6, { { 0.34, 0.33, 0.33 } } },
  { Stage::OrientContours, "Settling what is inside of contours", 1.8,
    { { 0.14, 0.09, 0.68, 0.09 } } },
  { Stage::SmoothContours, "Smoothing contours", 1.7,
    { { 0.13, 0.12, 0.12, 0.13, 0.12, 0.13, 0.12, 0.13 } } },
  { Stage::RegisterCrossings, "Cutting contours by the grid of slices", 2.2, { { 0.4, 0.6 } } },
  { Stage::ReconcileSlices, "Making slices agree", 0.8, { { 0.4, 0.6 } } },
  { Stage::PairNodePoints, "Finding where slices meet", 0.4, {} },
  { Stage::BuildNodeGraph, "Joining contours to a graph", 3.4, { { 0.06, 0.15, 0.2, 0.59 } } },
  { Stage::MeasureAgreement, "Measuring how far slices agree", 0.2, {} },
  { Stage::ThinArcs, "Leaving vertices out", 0.1, {} },
  { Stage::EmbedArcs, "Keeping contours apart", 1.4, { { 0.05, 0.18, 0.35, 0.42 } } },
  { Stage::EmbedIsolated, "Placing contours that meet no other slice", 0.1, {} },
  { Stage::TraceCycles, "Tracing cycles in cells", 0.8, { { 0.8, 0.2 } } },
  { Stage::StitchSlabs, "Joining contours of neighbouring slices", 0.1, {} },
  { Stage::LocateCentralPoints, "Placing central points", 4.4, {} },
  { Stage::FindJoins, "Judging what belongs together", 0.2, {} },
  { Stage::SeparatePatches, "Keeping patches apart", 0.3, {} },
  { Stage::MeasureTopology, "Counting components and handles", 0.1, {} },
  { Stage::FindUndecidedPlaces, "Looking for what slices leave open", 0.1, {} },
  { Stage::EstimateNormals, "Estimating normals", 15.0,
    { { 0.2, 0.18, 0.18, 0.02, 0.14, 0.14, 0.13, 0.01 } } },
  { Stage::LightenArcs, "Drawing contours with few vertices", 0.1, {} },
  { Stage::BuildInnerPatches, "Filling cycles", 67.0, { { 0.96, 0.03, 0.01 } } },
  { Stage::LayOutTriangles, "Laying out triangles", 0.2, {} },
  { Stage::ImproveSurface, "Improving triangles", 0.1,
    { { 0.3, 0.3, 0.1, 0.1, 0.05, 0.05, 0.05, 0.05 } } },
} };
}

const char* TextOf(Stage stage) { return Times[static_cast<std::size_t>(stage)].Text; }

double LoopShares::StartOf(std::size_t loop) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(loop, this->Shares.size()); ++i)
  {
    sum += this->Shares[i];
  }
  return std::min(1.0, sum);
}

StageShares::StageShares(const Options& options, const SpatialGrid& grid)
{
  const bool isLight = options.Patching.IsLight();
  const bool isStack = FindOnlyFamily(grid) >= 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < Count; ++i)
  {
    double time = Times[i].Time;
    time = isLight && Times[i].Of == Stage::ImproveSurface ? 150.0 : time;
    time = isLight && Times[i].Of == Stage::LightenArcs ? 10.0 : time;
    time = isStack && Times[i].Of == Stage::StitchSlabs ? 300.0 : time;
    sum += time;
    this->Ends[i] = sum;
  }
  for (double& end : this->Ends)
  {
    end /= sum;
  }
}

LoopShares StageShares::LoopsOf(Stage stage)
{
  return Times[static_cast<std::size_t>(stage)].Loops;
}
}
