// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCutAtBorder_h
#define OrthoSlicesCutAtBorder_h

#include "Core/Base/Box.h"
#include "Core/Base/AxisFrame.h"

class vtkPolyData;

namespace orthoslices
{
/**
 * Cuts off what of a surface of triangles lies beyond the sides of a box that are finite, so that
 * it ends on them with a boundary. The box is that of coordinates along the axes of the frame.
 * Triangles across a side are divided; arrays are interpolated at the points on it, and passed on
 * to the parts. Triangles that lie on a side go, and points of no triangle. Parts that touch in a
 * point of a side have one each.
 */
void CutAtBorder(const Box3& border, const AxisFrame& frame, vtkPolyData* surface);
}

#endif
