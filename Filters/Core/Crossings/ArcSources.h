// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesArcSources_h
#define OrthoSlicesArcSources_h

#include "Core/Crossings/RegisterCrossings.h"

#include <vector>

namespace orthoslices
{
/// What has no source: contours that were added, and those of virtual planes.
constexpr std::int64_t NoSource = -1;

/// Where a contour comes from: its cell (Contours::Cell), or NoSource.
std::int64_t SourceOf(const Contours& contours, Index contour);

/**
 * For each arc the source of the contour that it is a part of; of an arc made of parts of several
 * contours, that of the part with the most vertices. Arcs that reconciliation added have the source
 * of the next arc along their contour that has one. That of arcs that were removed is NoSource.
 */
std::vector<std::int64_t> FindArcSources(const Contours& contours, const GridCrossings& crossings);
}

#endif
