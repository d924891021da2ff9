// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContourNesting_h
#define OrthoSlicesContourNesting_h

#include "Core/Correspondence/ContourStack.h"

#include <vector>

namespace orthoslices
{
/// Bounding box of a contour, in the plane of its slice.
struct PlanarBox
{
  Point2 Low, High;

  bool Contains(const Point2& p) const
  {
    return p[0] >= this->Low[0] && p[0] <= this->High[0] && p[1] >= this->Low[1] &&
      p[1] <= this->High[1];
  }
};

std::vector<PlanarBox> BoxesOf(const ContourStack& stack);

/// Direction of an infinitely small move: (e u, e^2 v) for a positive e that is as small as needed.
struct Nudge
{
  int U = 0, V = 0;
};

/// The side of r + nudge against the line from p to q as SideOf() has it; never 0 for a nudge along
/// both axes. `tied` is set if it depends on the nudge.
int NudgedSideOf(const Point2& p, const Point2& q, const Point2& r, const Nudge& nudge, bool& tied);

/// Whether p + nudge lies within the contour. Without a nudge, points on the contour may count
/// either way.
bool IsWithin(
  const ContourStack& stack, Index contour, const Point2& p, const Nudge& nudge, bool& tied);

/// For each contour the smallest one of its slice that has it inside; -1 without.
std::vector<Index> FindParents(const ContourStack& stack);
}

#endif
