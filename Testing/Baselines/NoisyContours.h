// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   contours as an unsteady hand draws them
 */

#ifndef OrthoSlicesNoisyContours_h
#define OrthoSlicesNoisyContours_h

#include "Baseline.h"

#include <cstdint>

namespace orthoslices
{
namespace baselines
{

/**
 * A copy of the slices in which every vertex was moved within its plane: a normally distributed
 * random number of standard deviation DEVIATION is added to each of its two coordinates. Points of
 * one family at the same place stay together, so closed contours stay closed. A vertex moves into
 * the same direction for all deviations; contours may cross afterwards.
 */
SliceSets AddNoise(const SliceSets& slices, double deviation, std::uint64_t seed);

} // namespace baselines
} // namespace orthoslices

#endif
