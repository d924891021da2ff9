// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/MendCurves.h"

#include "Core/Pieces/CloseGaps.h"
#include "Core/Pieces/FindBorders.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
Point3 WorldOf(const OpenCurve& curve, const Point2& point)
{
  Point3 world;
  world[curve.Axis] = curve.Plane;
  world[FirstAxis(curve.Axis)] = point[0];
  world[SecondAxis(curve.Axis)] = point[1];
  return world;
}

/// The greatest mean distance of the slices that have open curves, of any axis; with one slice
/// each, a tenth of what the contours reach. REQUIRES: sorted curves.
double FindSpacing(const std::vector<OpenCurve>& curves, const std::array<ImageBorder, 3>& borders)
{
  double spacing = 0.0, extent = 0.0;
  for (std::size_t begin = 0; begin < curves.size();)
  {
    const int axis = curves[begin].Axis;
    std::size_t end = begin, planes = 0;
    for (; end < curves.size() && curves[end].Axis == axis; ++end)
    {
      planes += end == begin || curves[end].Plane != curves[end - 1].Plane ? 1 : 0;
    }
    const double length = curves[end - 1].Plane - curves[begin].Plane;
    spacing = std::max(spacing, planes > 1 ? length / (planes - 1.0) : 0.0);
    extent = std::max(extent, borders[axis].Side[0][1] - borders[axis].Side[0][0]);
    begin = end;
  }
  return spacing > 0.0 ? spacing : 0.1 * extent;
}

/// Mends the curves of one slice.
class SliceMender
{
public:
  SliceMender(const ImageBorder& border, BorderContours atBorder, MendedCurves& result)
    : Border(border)
    , AtBorder(atBorder)
    , Result(result)
  {
  }

  void Run(std::vector<OpenCurve>&& curves);

private:
  void CloseGaps(bool alsoAtBorder);
  void CloseAtBorder();
  void LeaveOut(const OpenCurve& curve);
  void ReportLoop(const OpenCurve& loop);
  void Report(ProblemKind kind, const OpenCurve& curve, const Point2& at, double size);

  const ImageBorder& Border;
  BorderContours AtBorder;
  MendedCurves& Result;
  std::vector<OpenCurve> Curves;
};

void SliceMender::Report(ProblemKind kind, const OpenCurve& curve, const Point2& at, double size)
{
  this->Result.Problems.push_back(
    { kind, curve.Axis, curve.Cell, WorldOf(curve, at), size, false });
}

void SliceMender::ReportLoop(const OpenCurve& loop)
{
  if (loop.Gap > 0.0)
  {
    this->Report(ProblemKind::GapClosed, loop, loop.GapAt, loop.Gap);
  }
  if (loop.Trimmed > 0.0)
  {
    this->Report(ProblemKind::OverrunTrimmed, loop, loop.End(0), loop.Trimmed);
  }
}

void SliceMender::LeaveOut(const OpenCurve& curve)
{
  const bool isShort = curve.Points.size() < 3;
  this->Report(isShort ? ProblemKind::TooShort : ProblemKind::Open, curve, curve.End(0),
    isShort ? curve.Length() : curve.EndDistance());
  this->Result.Problems.back().IsLeftOut = true;
}

void SliceMender::CloseGaps(bool alsoAtBorder)
{
  const auto mayJoin = [&](
                         const OpenCurve& curve, int which, const OpenCurve& other, int otherWhich)
  {
    const bool first = this->Border.IsOnBorder(curve.End(which));
    const bool second = this->Border.IsOnBorder(other.End(otherWhich));
    // A loop may well begin where it reaches farthest, and what it lacks be short all the same.
    return alsoAtBorder || (&curve == &other ? !(first && second) : !first && !second);
  };
  const std::size_t before = this->Result.Loops.size();
  orthoslices::CloseGaps(mayJoin, this->Curves, this->Result.Loops);
  for (std::size_t i = before; i < this->Result.Loops.size(); ++i)
  {
    this->ReportLoop(this->Result.Loops[i]);
  }
}

void SliceMender::CloseAtBorder()
{
  const auto middle = std::stable_partition(this->Curves.begin(), this->Curves.end(),
    [this](const OpenCurve& curve) { return !this->Border.EndsAtBorder(curve); });
  const std::vector<OpenCurve> ending(middle, this->Curves.end());
  if (ending.empty())
  {
    return;
  }
  this->Curves.erase(middle, this->Curves.end());
  if (this->AtBorder == BorderContours::Refuse)
  {
    for (const OpenCurve& curve : ending)
    {
      this->Result.Refused.push_back({ ProblemKind::Open, curve.Axis, curve.Cell,
        WorldOf(curve, curve.End(0)), curve.EndDistance(), true });
    }
    return;
  }
  for (BorderLoop& loop : CloseAlongBorder(this->Border, ending))
  {
    const bool isOpen = this->AtBorder == BorderContours::LeaveOpen;
    this->Report(isOpen ? ProblemKind::LeftOpen : ProblemKind::ClosedAlongBorder, loop.Curve,
      loop.Curve.End(0), loop.AlongBorder);
    loop.Curve.IsAtBorder = true;
    this->Result.Loops.push_back(std::move(loop.Curve));
  }
}

void SliceMender::Run(std::vector<OpenCurve>&& curves)
{
  for (OpenCurve& curve : curves)
  {
    if (curve.IsLoop)
    {
      this->ReportLoop(curve);
    }
    (curve.IsLoop ? this->Result.Loops : this->Curves).push_back(std::move(curve));
  }
  this->CloseGaps(false);
  this->CloseAtBorder();
  this->CloseGaps(true);
  for (const OpenCurve& curve : this->Curves)
  {
    this->LeaveOut(curve);
  }
}
}

MendedCurves MendCurves(std::vector<OpenCurve>&& curves, double tolerance, BorderContours atBorder,
  const Box3& givenBorder, std::array<ImageBorder, 3>& borders)
{
  MendedCurves result;
  std::stable_sort(curves.begin(), curves.end(),
    [](const OpenCurve& a, const OpenCurve& b)
    { return std::make_pair(a.Axis, a.Plane) < std::make_pair(b.Axis, b.Plane); });
  FindBorders(curves, borders);
  GiveBorders(givenBorder, borders);
  const double beyond = atBorder == BorderContours::LeaveOpen ? FindSpacing(curves, borders) : 0.0;
  for (ImageBorder& border : borders)
  {
    border.Beyond = beyond;
  }
  for (auto begin = curves.begin(); begin != curves.end();)
  {
    const auto isElsewhere = [&](const OpenCurve& curve)
    { return curve.Axis != begin->Axis || curve.Plane - begin->Plane > tolerance; };
    const auto end = std::find_if(begin, curves.end(), isElsewhere);
    const ImageBorder& border = borders[begin->Axis];
    SliceMender(border, atBorder, result)
      .Run({ std::make_move_iterator(begin), std::make_move_iterator(end) });
    begin = end;
  }
  return result;
}
}
