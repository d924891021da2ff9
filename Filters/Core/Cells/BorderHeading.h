// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesBorderHeading_h
#define OrthoSlicesBorderHeading_h

#include "Core/Graph/CycleGeometry.h"

#include <vector>

namespace orthoslices
{
/// A place on the border of a cycle, and the direction in which the surface leaves it into the
/// cell.
struct Heading
{
  Point3 Place;     ///< in world units
  Point3 Direction; ///< unit vector, tangent to the surface, across the border
  Point3 Normal;    ///< of the surface, outwards
  double Weight;    ///< share of the border's length; the sum over a cycle is 1
};

/**
 * The headings of a cycle at places evenly along its border. Where the surface goes from a contour
 * is known up to its tilt against the slice. The tilt is that of the normals at the node points,
 * and in between it changes evenly with the length of the arc; a loop, of which no tilt is known,
 * is left at right angles to its slice. `nodeNormals` has x, y, z for each node, or 0 if not known.
 */
std::vector<Heading> FindHeadings(
  const CycleGeometry& geometry, const std::vector<double>& nodeNormals, Index cycle);

/**
 * How far the surface of a cycle has to turn to get across: at each heading the least sum of the
 * two angles that it and the heading at another place have against the straight line between them,
 * as a part of 180 degrees; the mean over the border. It is 0 if the border is that of a sheet,
 * whose surface leaves one side of it straight towards another one, whatever shape it has
 * otherwise; 1 if it is the end of a tube, which has to turn back.
 */
double TurnAcross(const std::vector<Heading>& headings);

/**
 * How far it would have to turn to get from each of two cycles to the nearest place of the other
 * one: 0 for the two ends of a straight tube, 1 for two sheets above each other.
 */
double TurnBetween(const std::vector<Heading>& first, const std::vector<Heading>& second);
}

#endif
