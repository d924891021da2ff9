// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   slices of one family up to their cycles, for tests of slabs
 */

#ifndef OrthoSlicesLoopStack_h
#define OrthoSlicesLoopStack_h

#include "Core/Reconstruct.h"
#include "Support/TextContours.h"

namespace orthoslices
{
namespace support
{
/// The tables of slices of one family, whose contours are all loops of G.
struct LoopStack
{
  explicit LoopStack(const std::string& text)
  {
    Options options;
    options.Orient = Orientation::AsDrawn;
    Reconstruct(ParsePieces(text), options, Execution(),
      [this](Stage stage, const StageTables&, const Reconstruction& result)
      {
        if (stage == Stage::TraceCycles)
        {
          this->Result = result;
        }
      });
  }

  CycleGeometry Geometry() const { return GeometryOf(this->Result); }

  Reconstruction Result;
};

/// Two squares of which each has a corner in the other, as seen along the axis.
constexpr char TwoSquares[] = "z=0: 0,0 2,0 2,2 0,2; z=1: 1,1 3,1 3,3 1,3";

} // namespace support
} // namespace orthoslices

#endif
