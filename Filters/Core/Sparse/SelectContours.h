// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSelectContours_h
#define OrthoSlicesSelectContours_h

#include "Core/Base/Contours.h"

/// Parts and sums of contours, for surfaces from some of them or with virtual ones.
namespace orthoslices
{
/// Adds contours on virtual planes to real ones.
void AddVirtual(const Contours& others, Contours& contours);

/// The contours of an axis if `ofAxis`, else those of all others.
Contours SelectAxis(const Contours& contours, int axis, bool ofAxis);
}

#endif
