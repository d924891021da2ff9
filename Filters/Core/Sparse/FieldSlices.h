// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFieldSlices_h
#define OrthoSlicesFieldSlices_h

#include "Core/Sparse/SliceField.h"
#include "Core/Sparse/VirtualPlanes.h"

namespace orthoslices
{
/**
 * What slices on the planes of ChooseVirtualPlanes would show, if the object were where the field
 * is positive: its contours there, of Cell -1 and with Virtual set, closed and with the interior on
 * their left.
 *
 * The field is evaluated on one lattice that has all planes among its own: contours of two planes
 * cross the line where these meet at the same place, to the last bit. What leaves the bounds of the
 * grid is cut off.
 */
Contours CutField(const SliceField& field, const SpatialGrid& grid, const SliceDensity& density,
  const Execution& execution);
/// The same on planes that are given.
Contours CutField(const SliceField& field, const SpatialGrid& grid, const SliceDensity& density,
  const VirtualPlanes& planes, const Execution& execution);
}

#endif
