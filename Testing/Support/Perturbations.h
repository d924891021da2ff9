// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what happens to contours in practice, and changes that must not matter
 *
 * All of these work in place and give the same for the same seed. Lengths are world units.
 */

#ifndef OrthoSlicesPerturbations_h
#define OrthoSlicesPerturbations_h

#include "Support/TextContours.h"

namespace orthoslices
{
namespace support
{

/// Moves every vertex within its plane by up to `most` along each axis. Contours may cross then.
void MoveVertices(PieceSets& sets, double maximum, std::uint64_t seed);

/**
 * Bends every slice in its own way by up to `most` along each axis, in waves of length `wave`. As
 * two shears follow each other, whole curves never cross themselves or each other by it.
 */
void BendSlices(PieceSets& sets, double maximum, double wave, std::uint64_t seed);

/// Moves whole slices within their planes, like a patient who moved between them.
void MoveSlices(PieceSets& sets, double maximum, std::uint64_t seed);

/// Moves whole planes along their axis.
void ShiftPlanes(PieceSets& sets, double maximum, std::uint64_t seed);

/// Turns each set within its planes around the origin.
void RotateSets(PieceSets& sets, double degrees);

/// Deletes about this share of the contours, but never all of an axis.
void DropContours(PieceSets& sets, double share, std::uint64_t seed);

/// Leaves every n-th vertex of the contours of an axis, and at least three of each.
void ThinOut(Pieces& pieces, Index every);

/// Reverses about this share of the contours.
void ReverseContours(PieceSets& sets, double share, std::uint64_t seed);

/// Leaves of every coordinate what a float holds of it.
void RoundToFloat(PieceSets& sets);

/// Another order of the pieces and another first vertex of each closed one.
void ShufflePieces(PieceSets& sets, std::uint64_t seed);

/// Open pieces of two vertices in random order and direction.
void SplitIntoSegments(PieceSets& sets, std::uint64_t seed);

/// Appends every piece a second time.
void DuplicatePieces(PieceSets& sets);

/// The solid turned so that x becomes y, y becomes z and z becomes x.
void PermuteAxes(PieceSets& sets);

/// The solid with x and y exchanged.
void ExchangeXAndY(PieceSets& sets);

/// The solid seen in a mirror across the axis.
void Mirror(PieceSets& sets, int axis);

void Scale(PieceSets& sets, double factor);
void Translate(PieceSets& sets, const Point3& by);

} // namespace support
} // namespace orthoslices

#endif
