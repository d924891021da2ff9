// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   makes an input that fails as small as it gets, for a regression test
 */

#ifndef OrthoSlicesReduceInput_h
#define OrthoSlicesReduceInput_h

#include "Support/RandomInput.h"

namespace orthoslices
{
namespace support
{

/// What is wrong with the surface of an input; empty if all is right, or if the input is refused.
std::string FindFlaws(const PieceSets& sets, const Options& options);

/**
 * Drops pieces, then vertices, and shortens numbers, as long as the input fails and for at most
 * `trials` runs.
 */
PieceSets Reduce(PieceSets sets, const Options& options, int trials = 4000);

/// The input as text with its options in a first line, for logs.
std::string Describe(const PieceSets& sets, const Options& options);

} // namespace support
} // namespace orthoslices

#endif
