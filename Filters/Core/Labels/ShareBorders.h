// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesShareBorders_h
#define OrthoSlicesShareBorders_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace orthoslices
{
/// Areas of structures, and of what two of them have in common, summed over all slices.
struct CommonAreas
{
  std::vector<double> OfStructure;
  std::map<std::pair<Index, Index>, double> OfPair; ///< the lesser number first
};

/// Which structures may have a place in common: ascending lists of them, the empty one included.
using StructureSets = std::set<std::vector<Index>>;

/// Sets that places of a slice, by its axis and coordinate, get in the place of others.
using SetReplacements =
  std::map<std::pair<int, double>, std::map<std::vector<Index>, std::vector<Index>>>;

/// What ShareBorders has found.
struct SharedBorders
{
  CommonAreas Areas;
  std::vector<Index> Vanished; ///< of each structure: contours of which nothing is left
  StructureSets Sets;          ///< that places have, but for slivers
  Contours Union;              ///< of all structures, on each slice
  std::set<Point3> Junctions;  ///< vertices at which contours part or meet
};

/**
 * Makes contours of several structures on one slice have the same vertices where they run along
 * each other (our own addition). Vertices closer than `thickness` to a contour of a structure
 * before theirs are moved onto it. Then the sides of all contours are split where they meet,
 * exactly, so that a vertex of one is a vertex of all that pass through it. A face of the plane
 * graph between them that is thinner than `thickness` (twice its area by its length) is a *sliver*,
 * of a gap or an overlap that nobody has drawn on purpose: it becomes what one of its neighbours
 * is. So do, if `allowed` is not empty, faces that sets of structures have in common that are not
 * among those allowed. The neighbour is chosen that leaves the first structure as it is, and of
 * these one that leaves the second one as it is, and so on: so of two contours that run along each
 * other, the one of the lesser number stays.
 *
 * Before all that, places with sets that are `replaced` on their slice get the others.
 *
 * Contours that meet no others of their slice, or others in vertices of both alone, stay as they
 * are. The others are traced anew, in the place of all contours of their structure on that slice.
 * Where a structure touches itself then, its corners are cut off, and its neighbours get the
 * vertices of that (TraceRegions); these are junctions, too.
 * REQUIRES: contours have their interior on the left, and do not cross others of their structure.
 */
SharedBorders ShareBorders(double thickness, const StructureSets& allowed,
  const Execution& execution, const std::vector<Contours*>& structures,
  const SetReplacements& replaced = {});
}

#endif
