// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesStageShares_h
#define OrthoSlicesStageShares_h

#include "Core/Options.h"
#include "Core/Slices/SpatialGrid.h"
#include "Core/Stage.h"

#include <array>
#include <cstddef>

namespace orthoslices
{
/// The stage in words for the user, for a progress bar.
const char* TextOf(Stage stage);

/// What part of a stage its loops are, of those that take a time worth mentioning.
struct LoopShares
{
  std::array<double, 8> Shares{ 1.0 }; ///< of the loops in their order; 0 where there are no more

  /// The part of the stage that is done when so many loops are; 1 after the last one.
  double StartOf(std::size_t loop) const;
};

/**
 * The part of each stage in the time of a pass, as BenchReconstruct measures it: for a progress bar
 * that moves at an even pace. What it is for an input of another kind differs, but not the order of
 * magnitude, and no result depends on it.
 */
class StageShares
{
public:
  StageShares(const Options& options, const SpatialGrid& grid);

  /// Of all stages, that part is done when this one is; 1 after the last one.
  double EndOf(Stage stage) const { return this->Ends[static_cast<std::size_t>(stage)]; }
  static LoopShares LoopsOf(Stage stage);

private:
  std::array<double, static_cast<std::size_t>(Stage::ImproveSurface) + 1> Ends;
};
}

#endif
