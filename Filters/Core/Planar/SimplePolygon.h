// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSimplePolygon_h
#define OrthoSlicesSimplePolygon_h

#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/// Whether no two sides of a polygon have a point in common but their common end. Exact. Time is of
/// order n log n where sides that are near to each other are few.
bool IsSimple(const std::vector<Point2>& polygon);
}

#endif
