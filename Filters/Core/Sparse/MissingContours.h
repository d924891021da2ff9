// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMissingContours_h
#define OrthoSlicesMissingContours_h

#include "Core/Base/Execution.h"
#include "Core/Crossings/Repair.h"
#include "Core/Slices/SpatialGrid.h"

namespace orthoslices
{
/**
 * Contours that slices lack although those before and after them show that there is something: one
 * of several parts has not been drawn there. Our own addition; between the two contours the shape
 * is interpolated, as in S. P. Raya and J. K. Udupa, "Shape-Based Interpolation of Multidimensional
 * Objects", IEEE Transactions on Medical Imaging 9 (1990), but from vertex to vertex.
 *
 * A contour is proposed for each slice between two contours
 *  - that are one or two slices apart, on which others are drawn (else there was no slice),
 *  - neither of which overlaps one of the next slice towards the other one,
 *  - that overlap, each the nearest of this kind for the other one, and are alike in size,
 *  - that do not shrink towards the gap, as ends do: each has one to continue on its far side, of
 *    which it encloses at least MinShareOfSteady.
 * It divides the way from one contour to the other, at equal parts of their lengths. It is taken if
 * it neither touches itself nor another contour of its slice, and has its inside where these have
 * it. If there are slices of other families, one of them at least has to pass through it, and all
 * that do must be inside there.
 *
 * Returns the contours, of Cell -1 and with the interior on the same side as their neighbours, and
 * a report of each: the middle of the contour and its length. REQUIRES: contours are oriented,
 * Plane is set. Time is linear in the number of vertices, where few contours of neighbouring slices
 * overlap.
 */
struct MissingContours
{
  Contours Found;
  std::vector<Repair> Repairs;
};
MissingContours FindMissingContours(
  const Contours& contours, const SpatialGrid& grid, const Execution& execution = Execution());
}

#endif
