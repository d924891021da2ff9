// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/ContourNesting.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
bool LiesOn(const ContourStack& stack, Index contour, const Point2& p)
{
  for (Index i = stack.Offsets[contour]; i < stack.Offsets[contour + 1]; ++i)
  {
    const Point2 a = stack.At(i);
    const Point2 b = stack.At(stack.Next(contour, i));
    const PlanarBox box{ { std::min(a[0], b[0]), std::min(a[1], b[1]) },
      { std::max(a[0], b[0]), std::max(a[1], b[1]) } };
    if (box.Contains(p) && SideOf(a, b, p) == 0)
    {
      return true;
    }
  }
  return false;
}

/// Decided by the first vertex that is not common to both contours.
bool Encloses(const ContourStack& stack, Index outer, Index inner)
{
  for (Index i = stack.Offsets[inner]; i < stack.Offsets[inner + 1]; ++i)
  {
    if (!LiesOn(stack, outer, stack.At(i)))
    {
      bool tied = false;
      return IsWithin(stack, outer, stack.At(i), Nudge(), tied);
    }
  }
  return true;
}
}

std::vector<PlanarBox> BoxesOf(const ContourStack& stack)
{
  constexpr double maximum = std::numeric_limits<double>::max();
  std::vector<PlanarBox> boxes(
    stack.Slice.size(), PlanarBox{ { maximum, maximum }, { -maximum, -maximum } });
  for (Index contour = 0; contour < stack.Count(); ++contour)
  {
    PlanarBox& box = boxes[contour];
    for (Index i = stack.Offsets[contour]; i < stack.Offsets[contour + 1]; ++i)
    {
      const Point2 p = stack.At(i);
      box.Low = { std::min(box.Low[0], p[0]), std::min(box.Low[1], p[1]) };
      box.High = { std::max(box.High[0], p[0]), std::max(box.High[1], p[1]) };
    }
  }
  return boxes;
}

int NudgedSideOf(const Point2& p, const Point2& q, const Point2& r, const Nudge& nudge, bool& tied)
{
  const int side = SideOf(p, q, r);
  if (side != 0)
  {
    return side;
  }
  // The determinant changes by e (p1 - q1) nudge.U + e^2 (q0 - p0) nudge.V.
  tied = true;
  const int byU = p[1] > q[1] ? nudge.U : p[1] < q[1] ? -nudge.U : 0;
  const int byV = q[0] > p[0] ? nudge.V : q[0] < p[0] ? -nudge.V : 0;
  return byU != 0 ? byU : byV;
}

bool IsWithin(
  const ContourStack& stack, Index contour, const Point2& p, const Nudge& nudge, bool& tied)
{
  const auto isAbove = [&](const Point2& q)
  {
    tied = tied || (q[1] == p[1] && nudge.V != 0);
    return q[1] > p[1] || (q[1] == p[1] && nudge.V < 0);
  };
  bool within = false;
  for (Index i = stack.Offsets[contour]; i < stack.Offsets[contour + 1]; ++i)
  {
    const Point2 a = stack.At(i);
    const Point2 b = stack.At(stack.Next(contour, i));
    const bool rises = isAbove(b);
    if (isAbove(a) != rises && NudgedSideOf(a, b, p, nudge, tied) == (rises ? 1 : -1))
    {
      within = !within;
    }
  }
  return within;
}

std::vector<Index> FindParents(const ContourStack& stack)
{
  const std::vector<Index> first = FirstContourOfSlices(stack);
  const std::vector<PlanarBox> boxes = BoxesOf(stack);
  const std::vector<double> areas = SignedAreas(stack);
  std::vector<Index> parents(stack.Slice.size(), -1);
  for (Index slice = 0; slice < stack.SliceCount(); ++slice)
  {
    for (Index inner = first[slice]; inner < first[slice + 1]; ++inner)
    {
      for (Index outer = first[slice]; outer < first[slice + 1]; ++outer)
      {
        const Index parent = parents[inner];
        const double area = std::abs(areas[outer]);
        const bool smaller = parent < 0 || area < std::abs(areas[parent]);
        if (outer != inner && smaller && area > std::abs(areas[inner]) &&
          boxes[outer].Contains(boxes[inner].Low) && boxes[outer].Contains(boxes[inner].High) &&
          Encloses(stack, outer, inner))
        {
          parents[inner] = outer;
        }
      }
    }
  }
  return parents;
}
}
