// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesDoubtfulJoins_h
#define OrthoSlicesDoubtfulJoins_h

#include "Core/Cells/CycleJoin.h"
#include "Core/Graph/CycleGeometry.h"

#include <vector>

namespace orthoslices
{
/// Evidence up to which the odds are near even: less than two to one (ln 2), for or against.
constexpr double NearEvenEvidence = 0.693;

/// From this width on a part matters to whoever looks at the surface, in mean plane spacings: what
/// is narrower than the slices are apart is not resolved by them anyway.
constexpr double WidthThatMatters = 1.0;

/**
 * The joins that the user should be told of, in the order given (our own addition): those on which
 * the odds are near even and that matter. `joins` are those of the finished surface, with what was
 * chosen among them.
 *
 * The odds are near even if the evidence is less than NearEvenEvidence for or against, or if the
 * join was to be made but is impossible. They are not if the two cycles belong to one patch all the
 * same, through a third cycle, nor if the join could only have connected what is connected anyway.
 *
 * A join matters if its two cycles are left in different components, or if both are at least
 * WidthThatMatters wide, by the diagonal of their bounding boxes. The mean plane spacing is the
 * geometric mean of those axes that have two planes or more.
 *
 * The numbers were chosen so that of the shapes in Data that were cut from meshes, sliced in three
 * families, those give no doubt whose topology comes out right (10 sets), and those give one whose
 * topology comes out wrong (4 sets).
 */
std::vector<CycleJoin> FindDoubtfulJoins(
  const CycleGeometry& geometry, const std::vector<CycleJoin>& joins);
}

#endif
