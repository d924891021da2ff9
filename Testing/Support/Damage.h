// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what is wrong with contours as people have them, done to good ones
 *
 * All of these work in place on sets of closed pieces and give the same for the same seed.
 */

#ifndef OrthoSlicesDamage_h
#define OrthoSlicesDamage_h

#include "Support/TextContours.h"

namespace orthoslices
{
namespace support
{

/// Opens about this share of the contours at any vertex; up to `lacking` of their length is lost
/// there.
void LoseEnds(PieceSets& sets, double share, double lacking, std::uint64_t seed);

/// Opens about this share of the contours, which run on past their start along up to `beyond` of
/// their length, at most `aside` world units beside it.
void RunPastStart(PieceSets& sets, double share, double beyond, double aside, std::uint64_t seed);

/// Cuts about this share of the contours into up to four open pieces in any direction, between
/// which up to `lacking` of the length is lost each time.
void BreakApart(PieceSets& sets, double share, double lacking, std::uint64_t seed);

/// Moves vertices of about this share of the contours off their plane by up to `most`.
void LeavePlane(PieceSets& sets, double share, double maximum, std::uint64_t seed);

/// Adds single segments, flat loops and loops with coordinates that are not finite, up to `count`
/// of each on each axis, on planes that there are, within the contours' box.
void AddJunk(PieceSets& sets, std::size_t count, std::uint64_t seed);

/// What an image shows that ends at a coordinate of an axis: contours on planes beyond are not
/// there, and others are cut off, so that they end exactly at it. `keepsBelow`: the image lies
/// below the border.
void CutOff(PieceSets& sets, int axis, double border, bool keepsBelow);

} // namespace support
} // namespace orthoslices

#endif
