// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMissingLabels_h
#define OrthoSlicesMissingLabels_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"

#include <array>
#include <vector>

/**
 * Structures that slices lack, although those before and after them have them and nothing else is
 * drawn in their place: labels that have been overlooked there (our own addition). What
 * FindMissingContours is for a structure by itself, this is for one among others, with which it
 * shares its borders.
 *
 * A structure is lacking on a slice if it is drawn on the next slices before and after it on which
 * it is drawn at all, with one other slice between them at most. One that is lacking on more of the
 * planes of an axis than MostLacking is taken at its word there. Where all slices are of one family,
 * it must not shrink towards the gap, as ends do.
 *
 * It gets what is in it before or after, is in any structure both before and after, and is in none
 * on the slice: so it has the borders that others have drawn there. But it gets nothing if others
 * are drawn on half of what is in it both before and after: then it is not there.
 */
namespace orthoslices
{
/// A structure that is lacking on more of the planes of an axis that it passes through is taken at
/// its word there.
constexpr double MostLacking = 0.5;

/// The contours that structures lack, of Cell -1, with the interior on their left and Plane to be
/// found; one table for each structure. Deterministic.
std::vector<Contours> FindMissingLabels(
  const std::vector<const Contours*>& structures, const Execution& execution);

/**
 * What structures leave on a slice of what all of them cover together there: what the only one
 * that the slice lacks is in. `whole` are contours on that slice, as a surface around all shows
 * them; so they run along drawn ones only about: what lies between them is left out if it is thinner
 * than `thickness`. The contours have Cell -1, and Plane is to be found. Deterministic.
 */
Contours FindRest(
  const Contours& whole, double thickness, const std::vector<const Contours*>& structures);
}

#endif
