// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSliceImage_h
#define OrthoSlicesSliceImage_h

#include "Core/Slicing/PlaneContours.h"

#include <vector>

namespace orthoslices
{
/// The samples of one plane of an image: sample (i, j) is Values[i + j * SizeU].
struct SamplePlane
{
  Index SizeU = 0, SizeV = 0;
  std::vector<double> Values;
  /// The samples, by their places in Values, at the lower left corners of squares in which inside
  /// samples on a diagonal are joined; ascending.
  std::vector<std::size_t> Joined = {};
};

/**
 * Draws the contours around the samples that are at least `threshold` (NaN is not).
 *
 * The plane is surrounded with one ring of outside samples, so `us` and `vs` have SizeU + 2 and
 * SizeV + 2 ascending coordinates, the first and last of them for the ring.
 *
 * Guarantees:
 *  1. Contours are closed, have the interior on their left, and neither cross nor touch each other
 *     or themselves (before rounding to `precision`).
 *  2. Every vertex lies on a line between two neighbouring samples, at the linearly interpolated
 *     threshold but at least 1e-4 of the spacing from both; halfway if one of them belongs to the
 * ring or is not finite. It depends on these two samples only and is computed in one direction:
 *     orthogonal planes of an image share it exactly.
 *  3. Of four samples around a square, two inside and two outside on its diagonals, the inside
 *     ones are kept apart, but for squares in SamplePlane::Joined.
 */
PlaneContours SliceImage(const SamplePlane& plane, double threshold, const std::vector<double>& us,
  const std::vector<double>& vs, Precision precision);
}

#endif
