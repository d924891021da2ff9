// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSideMeetings_h
#define OrthoSlicesSideMeetings_h

#include "Core/Slices/SpatialGrid.h"

#include <vector>

namespace orthoslices
{
/**
 * Whether sides of contours, which are read from the graphs of several structures, meet on their
 * slice but in a common end of both; the same side of several contours counts as one. Exact.
 * Contours without node points are looked at as they are once they are loops of the graph, off the
 * border of their face.
 */
bool DoSidesMeet(const SpatialGrid& grid, const std::vector<Contours>& structures);
}

#endif
