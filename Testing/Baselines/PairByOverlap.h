// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which loops of two consecutive slices belong together: the overlap criterion
 *
 * The oldest correspondence rule for parallel slices, as surveyed in D. Meyers, S. Skinner,
 * K. Sloan, "Surfaces from contours", ACM Transactions on Graphics 11(3), 1992: contours whose
 * projections along the axis overlap belong together.
 */

#ifndef OrthoSlicesPairByOverlap_h
#define OrthoSlicesPairByOverlap_h

#include "PlanarContours.h"

#include <cstddef>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/// Area common to two loops, integrated over ROWS lines on which it is exact.
double OverlapArea(const Loop& a, const Loop& b, int rows = 256);

/// Indices of two loops that belong together, one in each slice.
struct LoopPair
{
  std::size_t Below;
  std::size_t Above;
};

/**
 * One-to-one pairs in descending order of the overlap. Boundaries of the interior pair with each
 * other, and so do those of holes.
 */
std::vector<LoopPair> PairByOverlap(const Slice& below, const Slice& above);

} // namespace baselines
} // namespace orthoslices

#endif
