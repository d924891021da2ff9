// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   solids cut by as many planes on each axis, for tests of single stages
 */

#ifndef OrthoSlicesEvenSlices_h
#define OrthoSlicesEvenSlices_h

#include "Support/RandomInput.h"
#include "Support/SliceSolid.h"

namespace orthoslices
{
namespace support
{

/// Contours on `count` planes of each axis.
inline Input Slice(const Solid& solid, int count, int subdivisions = 6)
{
  Input input;
  input.Sets =
    SliceSolid(solid, EqualPlanes(solid, { count, count, count }), subdivisions, InPlaneGrid::Free);
  return input;
}

/// A ball of radius 1 around the origin, in a box of which no plane is symmetric to another.
inline Solid UnitBall()
{
  Solid solid;
  solid.Low = { -1.23, -1.21, -1.19 };
  solid.High = { 1.17, 1.22, 1.24 };
  solid.Tubes = { Ball({ 0, 0, 0 }, 1.0) };
  return solid;
}

} // namespace support
} // namespace orthoslices

#endif
