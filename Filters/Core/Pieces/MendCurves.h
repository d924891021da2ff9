// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMendCurves_h
#define OrthoSlicesMendCurves_h

#include "Core/Base/Box.h"
#include "Core/Base/Contours.h"
#include "Core/Pieces/ImageBorder.h"

namespace orthoslices
{
/// Curves that have become loops, and what was done for that.
struct MendedCurves
{
  std::vector<OpenCurve> Loops;  ///< the last point is not the first one
  std::vector<Problem> Problems; ///< one for each loop, and one for each curve that is left out
  std::vector<Problem> Refused;  ///< curves that end at the border, with BorderContours::Refuse
};

/**
 * Makes loops of curves with loose ends, of all axes. Of what is no loop yet, in this order:
 *  - gaps that are short against the curves are closed (CloseGaps), but not between ends on the
 *    border, and overlaps trimmed;
 *  - curves that end at the border are closed along it (CloseAlongBorder), or refused; with
 *    BorderContours::LeaveOpen they go on across it for the distance of slices before they are
 *    closed, so that the surface can be cut off there;
 *  - the gaps that are left are closed, also between ends on the border.
 * What is still open is left out. Planes nearer to each other than `tolerance` are one.
 *
 * `borders` has what the contours of each axis reach; see FindBorders, and GiveBorders for
 * `givenBorder`.
 */
MendedCurves MendCurves(std::vector<OpenCurve>&& curves, double tolerance, BorderContours atBorder,
  const Box3& givenBorder, std::array<ImageBorder, 3>& borders);
}

#endif
