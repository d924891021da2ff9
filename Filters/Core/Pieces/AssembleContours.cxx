// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/AssembleContours.h"

#include "Core/Base/EditContours.h"
#include "Core/Pieces/AddLoop.h"
#include "Core/Pieces/AssembleSet.h"
#include "Core/Pieces/MendCurves.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace orthoslices
{
namespace
{
/// What the contours of each axis reach, with the points of curves.
std::array<ImageBorder, 3> FindReach(const Contours& contours, const std::vector<OpenCurve>& curves)
{
  std::array<ImageBorder, 3> borders;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      borders[contours.Axis[contour]].Add({ contours.U[i], contours.V[i] });
    }
  }
  for (const OpenCurve& curve : curves)
  {
    for (const Point2& point : curve.Points)
    {
      borders[curve.Axis].Add(point);
    }
  }
  return borders;
}

Box3 BoxOf(const Contours& contours, const std::vector<OpenCurve>& curves)
{
  Box3 box = orthoslices::BoxOf(contours);
  for (const OpenCurve& curve : curves)
  {
    box.Add(curve.Axis, curve.Plane);
    for (const Point2& point : curve.Points)
    {
      box.Add(FirstAxis(curve.Axis), point[0]);
      box.Add(SecondAxis(curve.Axis), point[1]);
    }
  }
  return box;
}

/// The least and the greatest coordinate of a curve along a direction.
std::array<double, 2> RangeOf(const OpenCurve& curve, int direction)
{
  std::array<double, 2> range{ HUGE_VAL, -HUGE_VAL };
  for (const Point2& point : curve.Points)
  {
    range = { std::min(range[0], point[direction]), std::max(range[1], point[direction]) };
  }
  return range;
}

/// The sides along which contours were closed, of all axes, beyond which there is nothing.
Box3 FindSides(
  const std::array<ImageBorder, 3>& borders, const std::vector<OpenCurve>& loops, const Box3& reach)
{
  Box3 sides = Everywhere();
  for (const OpenCurve& loop : loops)
  {
    for (int direction = 0; loop.IsAtBorder && direction < 2; ++direction)
    {
      const int axis = direction == 0 ? FirstAxis(loop.Axis) : SecondAxis(loop.Axis);
      const ImageBorder& border = borders[loop.Axis];
      const auto& [low, high] = border.Side[direction];
      const auto [least, greatest] = RangeOf(loop, direction);
      if (border.IsFound[direction][0] && least <= low && low <= reach.Low[axis])
      {
        sides.Low[axis] = low;
      }
      if (border.IsFound[direction][1] && greatest >= high && high >= reach.High[axis])
      {
        sides.High[axis] = high;
      }
    }
  }
  return sides;
}

/// Appends the loops that were made of open curves.
void AppendLoops(const std::vector<OpenCurve>& loops, double tolerance, Contours& contours,
  PieceProblems& problems)
{
  for (const OpenCurve& loop : loops)
  {
    for (const Point2& point : loop.Points)
    {
      AddPoint(point[0], point[1], contours);
    }
    if (CheckLoop(true, tolerance, contours) != LoopState::Good)
    {
      Point3 where;
      where[loop.Axis] = loop.Plane;
      where[FirstAxis(loop.Axis)] = loop.Points[0][0];
      where[SecondAxis(loop.Axis)] = loop.Points[0][1];
      DropLoop(contours);
      problems.Mended.push_back(
        { ProblemKind::Flat, loop.Axis, loop.Cell, where, loop.Length(), true });
      continue;
    }
    contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
    contours.Axis.push_back(static_cast<std::int8_t>(loop.Axis));
    contours.Coordinate.push_back(loop.Plane);
    contours.Cell.push_back(loop.Cell);
    if (!contours.Virtual.empty())
    {
      contours.Virtual.resize(contours.Axis.size(), 0);
    }
  }
}
}

PieceProblems AssembleContours(std::array<Pieces, 3>&& pieces, const AssembleSettings& settings,
  Contours& contours, const Execution& execution)
{
  PieceProblems problems;
  std::vector<OpenCurve> curves;
  for (Pieces& set : pieces)
  {
    std::vector<OpenCurve> open =
      AssembleSet(std::move(set), settings, contours, problems, execution);
    std::move(open.begin(), open.end(), std::back_inserter(curves));
  }
  if (!curves.empty())
  {
    std::array<ImageBorder, 3> borders = FindReach(contours, curves);
    const Box3 reach = BoxOf(contours, curves);
    const MendedCurves mended = MendCurves(
      std::move(curves), settings.Tolerance, settings.AtBorder, settings.GivenBorder, borders);
    problems.Mended.insert(problems.Mended.end(), mended.Problems.begin(), mended.Problems.end());
    problems.Unusable.insert(problems.Unusable.end(), mended.Refused.begin(), mended.Refused.end());
    AppendLoops(mended.Loops, settings.Tolerance, contours, problems);
    problems.Border = FindSides(borders, mended.Loops, reach);
  }
  return problems;
}
}
