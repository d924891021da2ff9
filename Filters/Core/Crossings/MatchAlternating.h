// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMatchAlternating_h
#define OrthoSlicesMatchAlternating_h

#include "Core/Base/Types.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace orthoslices
{
/// Entries of the table of costs, of 8 bytes each, up to which the best matching is searched for: 32
/// MB and some 10 ms for one edge, enough for two thousand crossings of each family.
constexpr std::size_t LargestMatchingTable = std::size_t(1) << 22;

/**
 * Matches two ascending lists of positions whose signs alternate from the same first sign.
 * `matched` gets pairs of indices; the unmatched entries of each list form adjacent pairs.
 * Minimises the distances of matched entries plus the lengths between the two entries of unmatched
 * pairs. REQUIRES: sizes that are both even or both odd.
 *
 * Longer lists than LargestMatchingTable allows are matched in their order: as validly, but not with
 * the least change.
 */
void MatchAlternating(const std::vector<double>& first, const std::vector<double>& second,
  std::vector<std::pair<Index, Index>>& matched);
}

#endif
