// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/FindBorders.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Ends at one side agree to this share of the extent of the contours: what rounding to three
/// digits leaves.
constexpr double AgreementShare = 1e-3;
/// So many ends make a side: those of a single contour.
constexpr int FewestEnds = 2;

/// A loose end, and the first point that is well away from it.
struct LooseEnd
{
  int Axis; ///< of the slice
  Point2 At, Away;
};

/// Points may be closer together than the tolerance.
template <typename Iterator>
LooseEnd MakeLooseEnd(int axis, Iterator begin, Iterator end, double tolerance)
{
  const Iterator away = std::find_if(
    begin, end, [&](const Point2& point) { return Distance(*begin, point) > 4.0 * tolerance; });
  return { axis, *begin, away == end ? *begin : *away };
}

std::vector<LooseEnd> ListLooseEnds(
  const std::vector<OpenCurve>& curves, const std::array<ImageBorder, 3>& borders)
{
  std::vector<LooseEnd> ends;
  for (const OpenCurve& curve : curves)
  {
    const double tolerance = borders[curve.Axis].Tolerance;
    if (curve.Points.size() > 2)
    {
      ends.push_back(MakeLooseEnd(curve.Axis, curve.Points.begin(), curve.Points.end(), tolerance));
      ends.push_back(
        MakeLooseEnd(curve.Axis, curve.Points.rbegin(), curve.Points.rend(), tolerance));
    }
  }
  return ends;
}

/// Finds the sides of the border that the slices of one axis show.
class SideFinder
{
public:
  SideFinder(int axis, const std::vector<LooseEnd>& ends, ImageBorder& border)
    : Axis(axis)
    , Ends(ends)
    , Border(border)
    , Taken(ends.size(), 0)
  {
  }

  /// The side with most ends first; ends of this axis that lie at it say nothing of others, for
  /// they may well reach farthest along the other direction, too.
  void Run()
  {
    for (int side = this->FindNext(); side >= 0; side = this->FindNext())
    {
      this->Border.IsFound[DirectionOf(side)][WhichOf(side)] = true;
      for (std::size_t i = 0; i < this->Ends.size(); ++i)
      {
        this->Taken[i] |=
          this->Ends[i].Axis == this->Axis && this->IsAt(this->Ends[i], side) ? 1 : 0;
      }
    }
  }

private:
  /// Whether a curve, of whatever axis, ends at a side and does not run along it.
  bool IsAt(const LooseEnd& end, int side) const
  {
    const int across = DirectionOf(side) == 0 ? FirstAxis(this->Axis) : SecondAxis(this->Axis);
    const int direction = across == FirstAxis(end.Axis) ? 0 : 1;
    const double at = this->Border.Side[DirectionOf(side)][WhichOf(side)];
    return end.Axis != across && std::abs(end.At[direction] - at) <= this->Border.Tolerance &&
      std::abs(end.Away[direction] - at) > this->Border.Tolerance;
  }

  int FindNext() const
  {
    int next = -1;
    std::ptrdiff_t most = FewestEnds - 1;
    for (int side = 0; side < 4; ++side)
    {
      std::ptrdiff_t count = 0;
      for (std::size_t i = 0; i < this->Ends.size(); ++i)
      {
        count += !this->Taken[i] && this->IsAt(this->Ends[i], side) ? 1 : 0;
      }
      if (!this->Border.IsFound[DirectionOf(side)][WhichOf(side)] && count > most)
      {
        next = side;
        most = count;
      }
    }
    return next;
  }

  int Axis;
  const std::vector<LooseEnd>& Ends;
  ImageBorder& Border;
  std::vector<std::uint8_t> Taken;
};
}

void FindBorders(const std::vector<OpenCurve>& curves, std::array<ImageBorder, 3>& borders)
{
  for (ImageBorder& border : borders)
  {
    const double extent =
      std::max(border.Side[0][1] - border.Side[0][0], border.Side[1][1] - border.Side[1][0]);
    border.Tolerance = std::max(0.0, AgreementShare * extent);
  }
  const std::vector<LooseEnd> ends = ListLooseEnds(curves, borders);
  for (int axis = 0; axis < 3; ++axis)
  {
    SideFinder(axis, ends, borders[axis]).Run();
  }
}

void GiveBorders(const Box3& given, std::array<ImageBorder, 3>& borders)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int direction : { 0, 1 })
    {
      const int across = direction == 0 ? FirstAxis(axis) : SecondAxis(axis);
      const std::array<double, 2> sides{ given.Low[across], given.High[across] };
      for (const int which : { 0, 1 })
      {
        if (sides[0] < sides[1])
        {
          const bool isThere = std::isfinite(sides[which]);
          double& side = borders[axis].Side[direction][which];
          side = isThere ? sides[which] : side;
          borders[axis].IsFound[direction][which] = isThere;
        }
      }
    }
  }
}
}
