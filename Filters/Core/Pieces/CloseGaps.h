// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCloseGaps_h
#define OrthoSlicesCloseGaps_h

#include "Core/Pieces/OpenCurve.h"

#include <functional>

namespace orthoslices
{
/// Whether an end of one curve may be joined to one of another, or of the same: 0 is its first
/// point, 1 its last.
using JointFilter =
  std::function<bool(const OpenCurve& curve, int which, const OpenCurve& other, int otherWhich)>;

/**
 * Closes gaps between curves of one slice: the nearest loose ends are joined first, until no gap is
 * left that is short, which is a fifth of the length of each curve at it. The chord over the gap of
 * a circle then cuts off less than 3 % of its area. A curve closes itself rather than joining
 * another one whose end is only a little nearer.
 *
 * Curves that have become loops are moved from `curves` to the end of `closed`. Of a joined curve
 * the cell is that of the longer part.
 */
void CloseGaps(
  const JointFilter& mayJoin, std::vector<OpenCurve>& curves, std::vector<OpenCurve>& closed);
}

#endif
