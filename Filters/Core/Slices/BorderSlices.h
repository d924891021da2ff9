// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesBorderSlices_h
#define OrthoSlicesBorderSlices_h

#include "Core/Base/Box.h"
#include "Core/Base/Contours.h"

namespace orthoslices
{
/**
 * Contours that were closed along sides of the border of the image go on beyond these: what lies on
 * a side moves out by `beyond` (world units), at right angles to it, and the ends of such parts
 * stay where they are besides. So a slice on the border shows where the object is cut off. Sides
 * that are infinite are none. REQUIRES: no contour lies beyond the border.
 */
Contours ContinueBeyond(const Contours& contours, const Box3& border, const Point3& beyond);
}

#endif
