// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMatchAlternating_h
#define OrthoSlicesMatchAlternating_h

#include "Core/Base/Types.h"

#include <utility>
#include <vector>

namespace orthoslices
{
/**
 * Matches two ascending lists of positions whose signs alternate from the same first sign.
 * `matched` gets pairs of indices; the unmatched entries of each list form adjacent pairs.
 * Minimises the distances of matched entries plus the lengths between the two entries of unmatched
 * pairs.
 */
void MatchAlternating(const std::vector<double>& first, const std::vector<double>& second,
  std::vector<std::pair<Index, Index>>& matched);
}

#endif
