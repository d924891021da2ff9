// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesOverlapCriterion_h
#define OrthoSlicesOverlapCriterion_h

#include "Core/Correspondence/FindCorrespondences.h"

#include <vector>

namespace orthoslices
{
/**
 * The overlap criterion, the oldest one: contours of neighbouring slices belong together if their
 * interiors overlap, seen along the axis.
 *
 * The interior of an outer boundary is what it encloses without its holes, that of a hole what it
 * encloses without the islands in it; outer boundaries are compared with outer boundaries and holes
 * with holes. The decision is exact: contours that touch or coincide overlap if and only if their
 * interiors have an area in common, however small. Cost is 0.
 *
 * Time grows with the number of edges, those counted repeatedly that others meet, and with the
 * number of contours of a slice that lie around one of the other slice.
 */
std::vector<Correspondence> CorrespondencesByOverlap(const ContourStack& stack);
}

#endif
