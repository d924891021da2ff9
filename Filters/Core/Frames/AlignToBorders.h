// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesAlignToBorders_h
#define OrthoSlicesAlignToBorders_h

#include "Core/Base/Polylines.h"
#include "Core/Frames/ChooseAxes.h"

namespace orthoslices
{
/**
 * Turns the axes of a single family around its normal, by 45 degrees at most, so that the borders of
 * the image at which contours end lie along them: FindBorders looks for borders there. Nothing else
 * says how an oblique image lies within its planes. Of each polyline that is open, the line from one
 * of its ends to the other votes with its length for its direction, but for right angles; if they
 * do not nearly agree, as those across gaps do not, or if there is one only, the axes stay.
 *
 * Polylines of a single segment do not vote. Does nothing where there are several families. Axes of
 * the world stay if they would turn by noise only.
 */
void AlignToBorders(const Polylines& lines, FamilyAxes& axes);

/// The axes of the world, turned likewise if all polylines are slices across one of them: there is
/// that of each, or -1.
AxisFrame TurnWorld(const Polylines& lines, const std::vector<std::int8_t>& axisOfLine);
}

#endif
