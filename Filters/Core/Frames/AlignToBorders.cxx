// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/AlignToBorders.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// How nearly votes agree: the length of their sum, as a share of the sum of their lengths. Votes
/// that are each off by four degrees at random come to that.
constexpr double LeastAgreement = 0.96;

/// Axes of the world turn by more than that, in radians: ends that are off by less than that are still
/// found to lie on one line.
constexpr double LeastTurn = 0.001;

/// The axis of the only family; -1 if there are others, or none.
int SingleAxis(const FamilyAxes& axes)
{
  int single = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (axes.HasFamily[axis])
    {
      if (single >= 0)
      {
        return -1;
      }
      single = axis;
    }
  }
  return single;
}
}

void AlignToBorders(const Polylines& lines, FamilyAxes& axes)
{
  const int normal = SingleAxis(axes);
  if (normal < 0)
  {
    return;
  }
  const Point3 u = axes.Frame.Normal(FirstAxis(normal));
  const Point3 v = axes.Frame.Normal(SecondAxis(normal));
  double cosines = 0.0, sines = 0.0, lengths = 0.0;
  Index votes = 0;
  for (Index line = 0; line < lines.Count(); ++line)
  {
    const Index first = lines.Offsets[line], last = lines.Offsets[line + 1] - 1;
    if (lines.Closed[line] != 0 || last - first < 2)
    {
      continue;
    }
    const Point3 chord = lines.PointAt(last) - lines.PointAt(first);
    const double alongU = Dot(chord, u), alongV = Dot(chord, v);
    const double length = std::hypot(alongU, alongV);
    if (std::isfinite(length) && length > 0.0)
    {
      // Four times the angle is the same for directions at right angles.
      const double angle = 4.0 * std::atan2(alongV, alongU);
      cosines += length * std::cos(angle);
      sines += length * std::sin(angle);
      lengths += length;
      ++votes;
    }
  }
  if (votes < 2 || std::hypot(cosines, sines) < LeastAgreement * lengths)
  {
    return;
  }
  const double turn = 0.25 * std::atan2(sines, cosines);
  if (axes.Frame.IsWorld() && std::abs(turn) < LeastTurn)
  {
    return;
  }
  std::array<Point3, 3> normals;
  normals[normal] = axes.Frame.Normal(normal);
  normals[FirstAxis(normal)] = Unit(std::cos(turn) * u + std::sin(turn) * v);
  normals[SecondAxis(normal)] = Unit(std::cos(turn) * v - std::sin(turn) * u);
  axes.Frame = AxisFrame(normals);
}

AxisFrame TurnWorld(const Polylines& lines, const std::vector<std::int8_t>& axisOfLine)
{
  FamilyAxes axes;
  for (const std::int8_t axis : axisOfLine)
  {
    if (axis >= 0)
    {
      axes.HasFamily[axis] = true;
    }
  }
  AlignToBorders(lines, axes);
  return axes.Frame;
}
}
