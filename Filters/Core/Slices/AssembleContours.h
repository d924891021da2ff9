// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesAssembleContours_h
#define OrthoSlicesAssembleContours_h

#include "Core/Base/Contours.h"

#include <vector>

namespace orthoslices
{
/**
 * Joins the pieces of one axis to closed contours, finds the plane of each and appends them to
 * `contours` (the paper's input, section 3; the joining is our own).
 *
 *  - End points that coincide exactly are joined; what is still loose is joined to the nearest
 * loose end within `tolerance`. Where more than two ends meet, the pieces are paired so that they
 * do not cross.
 *  - A piece of three or more points with two loose ends is closed by a last segment if the gap is
 * at most twice its longest segment. Everything else with a loose end is open.
 *  - A plane's coordinate is that of the contour's first vertex; all vertices have to lie within
 * `tolerance` of it and are moved onto it.
 *  - Repeated consecutive vertices are dropped, then contours with fewer than three vertices.
 *
 * Contours with a problem are not appended; the problem is.
 */
void AssembleContours(
  Pieces&& pieces, double tolerance, Contours& contours, std::vector<Problem>& problems);
}

#endif
