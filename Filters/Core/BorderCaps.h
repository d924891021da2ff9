// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesBorderCaps_h
#define OrthoSlicesBorderCaps_h

#include "Core/Pass.h"

namespace orthoslices
{
/**
 * Where contours were closed along the border of the image, gives each side of it a virtual slice
 * that shows where the object is cut off: so the surface ends flat there, with an edge, also
 * between two slices. The slice is a section of the surface of the contours as they go on beyond
 * the border, which is made for that. Contours go on, too, by a thousandth of a spacing beyond it,
 * and the surface by two.
 *
 * Adds nothing where contours were smoothed, where patches are shared with other structures, where
 * a section reaches beyond another side of the border, if there is a slice on a side, or less than
 * two slices across the axis of one, or if a side is no value of the precision. False: stopped.
 */
bool AddBorderSlices(Pass& pass);
}

#endif
