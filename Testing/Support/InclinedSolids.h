// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   families of solids on which methods for parallel slices fail: Figures 1 and 2 of the
 * paper
 *
 * The drawings of Figure 1 are not available to us; the letters stand for
 *
 *   A  an axis so inclined to the z-slices that consecutive contours do not overlap,
 *   B  sections that are no ellipses, or branches,
 *   C  handles,
 *   D  contours of one slice that belong together, as the solid turns back between two slices,
 *
 * and every object of B and C is inclined like those of A. Objects are described by their sections
 * at each height z and then sheared: the section at z is moved by a multiple of z. Its z-slices
 * stay what they are but for the move. No section has a hole.
 */

#ifndef OrthoSlicesInclinedSolids_h
#define OrthoSlicesInclinedSolids_h

#include "Support/AnalyticSolids.h"
#include "Support/SliceSolid.h"

namespace orthoslices
{
namespace support
{

/// A solid with the slices through it: 10 z-slices at z = -0.9, -0.7, ..., 0.9 (distance 0.2) and
/// x- and y-slices at distances of about 0.08.
struct InclinedSolid
{
  char Family;
  Solid Shape; ///< with its name and the true number of components and handles
  PlaneSets Planes;
};

/// All objects of Figure 1: six or seven of each family, in alphabetical order of the families.
std::vector<InclinedSolid> FigureOneSolids();

/// Spirals like that of a cochlea, with 1.25 to 3.25 turns about a horizontal axis (Figure 2): they
/// are of family D.
std::vector<InclinedSolid> FigureTwoSolids();

/**
 * Objects like those of Figure 1 on which a method does better or worse than on its family: tubes
 * so close that the spanning tree cannot tell them apart, a fork whose sections are nearly
 * elliptical, and arches for which the Reeb graph's connections within one slice suffice.
 */
std::vector<InclinedSolid> Exceptions();

} // namespace support
} // namespace orthoslices

#endif
