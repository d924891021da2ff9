// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSlabSheets_h
#define OrthoSlicesSlabSheets_h

#include "Core/Slabs/SlabGroup.h"

#include <vector>

namespace orthoslices
{
/**
 * Loops of a slab that belong together otherwise than their overlay has it. Loops of one sheet are
 * overlaid by themselves, without the others.
 */
struct SheetPlan
{
  std::vector<Index> Loops;               ///< members of the group, ascending: those of all sheets
  std::vector<std::vector<Index>> Sheets; ///< members of the group, of one role each
  std::vector<Index> Depth; ///< of each sheet: how many loops of the plan are around its loops
  bool InPairs = false; ///< each sheet is a tube between its two loops, or a lid over its only one
  Index Faults = 0;     ///< of the overlay of all: handles, and pieces that mix the roles
  /// Whether the sheets may be overlaid apart; else only together, sheared.
  bool MayPart = true;
};

/**
 * Where contours correspond by their role: outer contours continue outer ones, holes continue
 * holes. The overlay of a thin wall that moves by more than its thickness from one slice to the
 * next makes tunnels through it, or two rings of it that end; a thin plate gets handles. Looked at
 * are pieces of the overlay that have handles, or that join an outer contour and a hole, with all
 * contours of the regions that these bound:
 *
 * - contours that are nested in the same way on both slices continue one another one to one;
 * - otherwise those of one depth of nesting continue together, and what is left over ends.
 *
 * Lids over single contours that are close together for their size and for the width of the slab
 * become tubes, if they are the closest ones of their role and of similar size.
 *
 * A hole that opens to the outside between two slices looks alike. Then most of the wall around it
 * lies above itself, and does not do so better after moving one of the slices. So sheets of holes
 * and of outer contours part only where less than half of the solid lies above itself.
 *
 * A plan is no promise: see RealizeSheets. `width` is that of the slab. REQUIRES: the overlay of
 * the group is valid.
 */
std::vector<SheetPlan> PlanSheets(const SlabGroup& group, double width);
}

#endif
