// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFindCrossings_h
#define OrthoSlicesFindCrossings_h

#include "Core/Base/Execution.h"
#include "Core/Base/Types.h"

#include <utility>
#include <vector>

namespace orthoslices
{
/**
 * Pairs of triangles that do not certainly meet in their common corners only, at least one of which
 * is marked; ascending, each pair once. Those that are not marked are taken to be apart from each
 * other. Time grows as n log n with the number of triangles, where few of them are near each other.
 */
std::vector<std::pair<Index, Index>> FindCrossings(const std::vector<Point3>& points,
  const std::vector<std::array<Index, 3>>& triangles, const std::vector<std::uint8_t>& isMarked,
  const Execution& execution);
}

#endif
