// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   contours of an implicit solid on given planes, without the project's own slicer
 *
 * Marching squares on a fine grid in every plane; each vertex is moved along its grid edge onto the
 * curve by Newton's method, guarded by bisection. Interior on the left.
 */

#ifndef OrthoSlicesSliceSolid_h
#define OrthoSlicesSliceSolid_h

#include "Support/AnalyticSolids.h"
#include "Support/TextContours.h"

namespace orthoslices
{
namespace support
{

using PlaneSets = std::array<std::vector<double>, 3>;

enum class InPlaneGrid
{
  /// The grid lines include the planes of the other families, so that contours meet exactly, and
  /// always in a vertex: no rounding can make the families disagree.
  Aligned,
  /// Every family has a grid of its own: contours meet as exact cuts of a real shape do, up to the
  /// height of a chord over its curve.
  Free
};

/// `count` planes on each axis at equal distances, the first half a distance inside the box.
PlaneSets EqualPlanes(const Solid& solid, const std::array<int, 3>& count);

/// `count` planes on each axis at random distances, at least a quarter of the mean one.
PlaneSets RandomPlanes(const Solid& solid, const std::array<int, 3>& count, std::uint64_t seed);

/// Contours as closed pieces; `subdivisions` cells of the in-plane grid in each slab.
PieceSets SliceSolid(
  const Solid& solid, const PlaneSets& planes, int subdivisions, InPlaneGrid grid);

/// The same with another number of cells along each axis.
PieceSets SliceSolid(const Solid& solid, const PlaneSets& planes,
  const std::array<int, 3>& subdivisions, InPlaneGrid grid);

/// The tilted torus on 8, 9 and 10 planes; the families agree to the last bit.
const PieceSets& TorusSlices();

} // namespace support
} // namespace orthoslices

#endif
