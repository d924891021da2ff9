// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCutEars_h
#define OrthoSlicesCutEars_h

#include "Core/Base/Types.h"

#include <array>
#include <vector>

namespace orthoslices
{
/**
 * Appends the triangles of a ring of three points or more, counter-clockwise: cuts off ears, which
 * have no other point inside or on their border, until nothing is left. Where there is no ear,
 * because the ring meets itself, it cuts on nevertheless. Time is of order n log n where the ring
 * does not wind much.
 */
void CutEars(const std::vector<Point2>& points, const std::vector<Index>& ring,
  std::vector<std::array<Index, 3>>& triangles);
}

#endif
