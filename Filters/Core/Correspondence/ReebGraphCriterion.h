// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReebGraphCriterion_h
#define OrthoSlicesReebGraphCriterion_h

#include "Core/Correspondence/FindCorrespondences.h"

#include <vector>

namespace orthoslices
{
/**
 * The Reeb graph after Y. Shinagawa, T. Kunii, "Constructing a Reeb graph automatically from cross
 * sections" (1991). Its nodes are the contours; a cycle of the graph is a handle of the surface.
 *
 *   1. Between two slices with the same number of contours (outer boundaries and holes counted
 *      apart), these are connected one to one, the closest pairs first.
 *   2. Where the number changes, pairs of outer boundaries or of holes are connected, the closest
 *      ones first, as long as one of the two has no partner between these slices yet.
 *   3. If the surface has still more components or fewer handles than is known, further pairs are
 *      connected where the number changes, an outer boundary also with a hole.
 *   4. If that is still so, pairs of one slice are connected that have no partner on one side of
 *      it: the surface passes from one to the other beyond the slice. They have to bound a common
 *      area of the slice, as no surface without self-intersections could connect others.
 *
 * From step 2 on a connection is refused where it contradicts what is known: if it joins two
 * components but there are no more than the known number, or closes a cycle but there are as many
 * as the known genus. Contours that are connected through others between the same two slices are
 * not connected twice. Without knowledge nothing is refused, and steps 3 and 4 do nothing.
 *
 * Only the abstract of the paper was available to us: it has steps 1 and 2, a weight for each pair
 * and the genus as prior knowledge. Our weight, which is also the Cost, is the mean distance along
 * both contours to the other one, seen along the axis (on 32 points of each). That
 * the number of components is used as well, and steps 3 and 4, are our reading.
 *
 * Time grows with the square of the number of contours on two slices.
 */
std::vector<Correspondence> CorrespondencesByReebGraph(
  const ContourStack& stack, const PriorKnowledge& known);
}

#endif
