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
  bool InPairs = false; ///< each sheet is a tube between its two loops, or a lid over its only one
  Index Faults = 0;     ///< of the overlay of all: handles, and pieces that mix the roles
};

/**
 * Where contours correspond by their role: outer contours continue outer ones, holes continue holes.
 * The overlay of a thin wall that moves by more than its thickness from one slice to the next makes
 * tunnels through it, or two rings of it that end; a thin plate gets handles. Looked at are pieces
 * of the overlay that have handles, or that join an outer contour and a hole, with all contours of
 * the regions that these bound:
 *
 * - contours that are nested in the same way on both slices continue one another one to one;
 * - otherwise those of one depth of nesting continue together, if there are some of each depth on
 *   both slices, or if hardly any of the solid lies above the other: then what is left over ends.
 *
 * A plan is no promise: see RealizeSheets. REQUIRES: the overlay of the group is valid.
 */
std::vector<SheetPlan> PlanSheets(const SlabGroup& group);
}

#endif
