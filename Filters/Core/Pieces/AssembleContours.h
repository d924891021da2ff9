// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesAssembleContours_h
#define OrthoSlicesAssembleContours_h

#include "Core/Base/Box.h"
#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"
#include "Core/Pieces/ImageBorder.h"

#include <vector>

namespace orthoslices
{
struct AssembleSettings
{
  /// Of planes, of ends that are joined, and of the width of flat loops, in world units.
  double Tolerance = 0.0;
  bool Mend = false; ///< what is incomplete or not exact is mended, else it is a problem
  /// With Mend, how far the vertices of a single slice may be off their plane, in world units.
  double AloneTolerance = 0.0;
  BorderContours AtBorder = BorderContours::CloseAlong; ///< with Mend
  Box3 GivenBorder; ///< see GiveBorders; where it is empty, the border is found
};

/// What was found to be wrong with the pieces.
struct PieceProblems
{
  std::vector<Problem> Unusable; ///< their contours are not there
  std::vector<Problem> Mended;   ///< with Mend: mended, or left out
  /// Contours were closed along the sides of this box, or continued beyond them, and no contour of
  /// the input lies beyond.
  Box3 Border = Everywhere();
};

/**
 * Joins the pieces of the three axes to closed contours, finds the plane of each and appends them
 * to `contours` (the paper's input, section 3; the joining is our own).
 *
 *  - Ends are joined as JoinPieces says. A single piece of three or more points whose ends meet no
 *    others is closed by a last segment if the gap is at most twice its longest segment. Everything
 *    else with a loose end is open.
 *  - A plane's coordinate is that of the contour's first vertex; all vertices have to lie within
 *    the tolerance of it and are moved onto it.
 *  - Repeated consecutive vertices are dropped, then contours with fewer than three vertices.
 *
 * Contours with a problem are not appended. With Mend, vertices are put on their planes first, as
 * MoveOntoPlanes says, and open contours are closed as MendCurves says; loops without area are left
 * out, and whatever cannot be mended. Mended contours come after those of all axes that needed
 * nothing, and input that needs nothing gives the same either way.
 */
PieceProblems AssembleContours(std::array<Pieces, 3>&& pieces, const AssembleSettings& settings,
  Contours& contours, const Execution& execution = Execution());
}

#endif
