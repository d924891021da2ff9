// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLoopRule_h
#define OrthoSlicesLoopRule_h

namespace orthoslices
{
/// What of a slice is inside, where its contours meet.
enum class LoopRule
{
  Union,   ///< loops that cross count together, loops within others are holes, and so on inwards
  EvenOdd, ///< what an odd number of loops runs around
  NonZero  ///< what loops run around more often in one direction than in the other one
};
}

#endif
