// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   solids with walls, cavities and branchings, and few planes to cut them by
 *
 * For slices that are far apart in one direction or more, as a stack with one slice across it: what
 * connects the contours is known from the solid, and has to be found from what the slices show.
 */

#ifndef OrthoSlicesSparseSolids_h
#define OrthoSlicesSparseSolids_h

#include "Support/SliceSolid.h"

namespace orthoslices
{
namespace support
{

/// A pipe along z of outer radius 1 and height 2. One component of genus 1.
Solid Pipe(double wall);
/// A ball of radius 1 with a round cavity. Two components of genus 0.
Solid BallWithCavity(double wall);
/// An ellipsoid's shell, as high as 2.4 times its radius 1, cut off in its upper part: open at the
/// top, as the wall of a ventricle. One component of genus 0.
Solid OpenShell(double wall);
/// A pipe with a floor. One component of genus 0.
Solid Beaker(double wall);
/// A torus around an axis, of radii 1 - `minor` and `minor`. One component of genus 1.
Solid TorusAround(int axis, double minor);
/// Two balls of radius 1 side by side along an axis. Two components of genus 0.
Solid TwoBalls(int axis, double gap);
/// A ball of radius 1.
Solid PlainBall();

/// All of these, with walls of several widths.
std::vector<Solid> AllSparseSolids();

/**
 * So many planes on each axis: evenly through the box; a single one, and all planes of an axis of
 * which `offset` is not 0, are moved by that part of the box's width.
 */
PlaneSets FewPlanes(
  const Solid& solid, const std::array<int, 3>& count, const std::array<double, 3>& offset);

/// Contours on them whose edges are about as short, one part in `cells` (default: 32) of the box's
/// width, however few planes an axis has.
PieceSets SliceByFewPlanes(const Solid& solid, const PlaneSets& planes,
  InPlaneGrid grid = InPlaneGrid::Free, int cells = 32);

} // namespace support
} // namespace orthoslices

#endif
