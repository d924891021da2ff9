// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRealizeSheets_h
#define OrthoSlicesRealizeSheets_h

#include "Core/Slabs/SlabSheets.h"

#include <vector>

namespace orthoslices
{
/**
 * Overlays the sheets that are planned for the loops of a slab by themselves, straight or sheared,
 * and the loops that no plan is about together, as they were. A plan is carried out if the surface
 * has the topology that it asks for, which is counted, and if no triangle may meet another one of
 * the slab; else its loops stay with the others. Without a plan that can be carried out, the group
 * is returned as it is.
 *
 * `width` is that of the slab. REQUIRES: the overlay of the group is valid.
 */
std::vector<SlabGroup> RealizeSheets(
  SlabGroup&& whole, const std::vector<SheetPlan>& plans, double width);
}

#endif
