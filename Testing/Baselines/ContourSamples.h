// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   points on the contours with their normals in the planes, and what a signed distance is
 * there and a little off the surface
 */

#ifndef OrthoSlicesContourSamples_h
#define OrthoSlicesContourSamples_h

#include "PlanarContours.h"
#include "RadialBasisFunction.h"

#include <array>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/// Slices of constant x, y and z, oriented by nesting; any family may be empty.
using SliceFamilies = std::array<std::vector<Slice>, 3>;

/// A point on a contour.
struct ContourSample
{
  std::array<double, 3> Position;
  std::array<double, 3> Inwards; ///< unit vector in the plane of the slice
};

/// The length of all contours.
double TotalLength(const SliceFamilies& families);

/**
 * Samples about STEP apart on all contours, at least six on each, in the order of the contours.
 * Where slices cross, one of two samples closer than a tenth of the step is left out.
 */
std::vector<ContourSample> SampleContours(const SliceFamilies& families, double step);

/**
 * Zero at every sample, and +OFFSET and -OFFSET at points so far inside and outside along its
 * normal. Where such a point comes nearer to other samples than to its own, the distance is halved
 * until it does not, or the point is left out.
 */
std::vector<RadialConstraint> MakeConstraints(
  const std::vector<ContourSample>& samples, double offset);

} // namespace baselines
} // namespace orthoslices

#endif
