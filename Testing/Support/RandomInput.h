// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   random inputs by number, from consistent to absurd
 */

#ifndef OrthoSlicesRandomInput_h
#define OrthoSlicesRandomInput_h

#include "Core/Reconstruct.h"
#include "Support/TextContours.h"

namespace orthoslices
{
namespace support
{

struct Input
{
  std::string Name; ///< says how to make it again
  PieceSets Sets;
  Options Settings;
  bool Exact = false; ///< the families agree to the last bit
};

/// Slices of a random solid on 3 to 12 planes per axis, as they are. Never an empty set.
Input RandomConsistentInput(std::uint64_t seed);

/**
 * The same made contradictory in one of many ways: vertices, slices or planes moved, contours
 * deleted, reversed, thinned out, sets rotated, or several of these. Settings leave out what is
 * unusable.
 */
Input RandomContradictoryInput(std::uint64_t seed);

/**
 * Slices of random thin tubes and balls, about as thick as the planes are apart, on one, two or
 * three axes (the other sets are empty); the numbers of components and handles that one may expect
 * are random, too. Sets are empty or not, but never all of them.
 */
Input RandomSparseInput(std::uint64_t seed);

/// The environment's ORTHOGONAL_SLICES_RUNS, or the default, and the first seed of these runs.
std::uint64_t RandomRuns(std::uint64_t usual);
std::uint64_t FirstSeed();

} // namespace support
} // namespace orthoslices

#endif
