// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/ImageBorder.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Whether a curve does not lie along a side of the border.
bool LeavesSide(const OpenCurve& curve, int direction, double side, double tolerance)
{
  return std::any_of(curve.Points.begin(), curve.Points.end(),
    [&](const Point2& point) { return std::abs(point[direction] - side) > tolerance; });
}

/// An end of a curve, and where it lies on the way round the rectangle.
struct BorderEnd
{
  std::size_t Curve;
  int Which;
  double Way;
  Point2 Foot; ///< on the border
};

/// The way round the rectangle, counter-clockwise from the corner below left.
class BorderWay
{
public:
  explicit BorderWay(const ImageBorder& border)
    : Border(border)
  {
    for (int side = 0; side < 4; ++side)
    {
      this->Start[side + 1] =
        this->Start[side] + Distance(this->Corner(side), this->Corner(side + 1));
    }
  }

  double Total() const { return this->Start[4]; }
  BorderEnd Place(const OpenCurve& curve, std::size_t number, int which) const;
  /// Where the way from one end on to another, counter-clockwise, turns round corners.
  std::vector<Point2> CornersBetween(double from, double to) const;
  double LengthBetween(double from, double to) const
  {
    return to >= from ? to - from : to - from + this->Total();
  }
  /// How much of the way between two ends is on sides that were not found.
  double LengthAstray(double from, double to) const;

private:
  /// Where the way turns; it leads round beyond the sides that were found.
  Point2 Corner(int number) const
  {
    const int i = number % 4;
    return { this->SideBeyond(0, i == 1 || i == 2 ? 1 : 0), this->SideBeyond(1, i >= 2 ? 1 : 0) };
  }
  double SideBeyond(int direction, int which) const
  {
    const double beyond = this->Border.IsFound[direction][which] ? this->Border.Beyond : 0.0;
    return this->Border.Side[direction][which] + (which == 1 ? beyond : -beyond);
  }

  const ImageBorder& Border;
  std::array<double, 5> Start{ 0.0, 0.0, 0.0, 0.0, 0.0 };
};

BorderEnd BorderWay::Place(const OpenCurve& curve, std::size_t number, int which) const
{
  const double reach = std::max(this->Border.Tolerance, curve.MeanSegment());
  const int side = this->Border.SideOfEnd(curve.End(which), reach);
  const Point2 corner = this->Corner(side);
  const int along = 1 - DirectionOf(side);
  Point2 foot = curve.End(which);
  foot[1 - along] = corner[1 - along];
  foot[along] =
    std::min(this->SideBeyond(along, 1), std::max(this->SideBeyond(along, 0), foot[along]));
  return { number, which, this->Start[side] + std::abs(foot[along] - corner[along]), foot };
}

std::vector<Point2> BorderWay::CornersBetween(double from, double to) const
{
  std::vector<Point2> corners;
  const double end = from + this->LengthBetween(from, to);
  for (int i = 1; i <= 8; ++i)
  {
    const double at = this->Start[i % 4] + (i / 4) * this->Total();
    if (from < at && at < end)
    {
      corners.push_back(this->Corner(i));
    }
  }
  return corners;
}

double BorderWay::LengthAstray(double from, double to) const
{
  double astray = 0.0;
  const double end = from + this->LengthBetween(from, to);
  for (int i = 0; i < 8; ++i)
  {
    const double shift = (i / 4) * this->Total();
    const double low = std::max(from, this->Start[i % 4] + shift);
    const double high = std::min(end, this->Start[i % 4 + 1] + shift);
    const bool isFound = this->Border.IsFound[DirectionOf(i % 4)][WhichOf(i % 4)];
    astray += isFound ? 0.0 : std::max(0.0, high - low);
  }
  return astray;
}

std::vector<BorderEnd> ListEnds(const BorderWay& way, const std::vector<OpenCurve>& curves)
{
  std::vector<BorderEnd> ends;
  for (std::size_t curve = 0; curve < curves.size(); ++curve)
  {
    ends.push_back(way.Place(curves[curve], curve, 0));
    ends.push_back(way.Place(curves[curve], curve, 1));
  }
  std::stable_sort(
    ends.begin(), ends.end(), [](const BorderEnd& a, const BorderEnd& b) { return a.Way < b.Way; });
  return ends;
}

/// Whether the parts of the border that begin at the ends with even numbers are inside (0), or
/// those at odd ones (1).
std::size_t ChooseInside(const BorderWay& way, const std::vector<BorderEnd>& ends)
{
  std::array<std::pair<double, double>, 2> cost{};
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const BorderEnd& next = ends[(i + 1) % ends.size()];
    cost[i % 2].first += way.LengthAstray(ends[i].Way, next.Way);
    cost[i % 2].second += way.LengthBetween(ends[i].Way, next.Way);
  }
  return cost[1] < cost[0] ? 1 : 0;
}

/// Follows curves and parts of the border in turn.
class LoopFollower
{
public:
  LoopFollower(const BorderWay& way, const std::vector<OpenCurve>& curves)
    : Way(way)
    , Curves(curves)
    , Ends(ListEnds(way, curves))
    , Inside(ChooseInside(way, this->Ends))
    , NumberOf(2 * curves.size())
  {
    for (std::size_t i = 0; i < this->Ends.size(); ++i)
    {
      this->NumberOf[2 * this->Ends[i].Curve + this->Ends[i].Which] = i;
    }
  }

  std::vector<BorderLoop> Run() const;

private:
  BorderLoop Follow(std::size_t curve, std::vector<std::uint8_t>& done) const;
  std::size_t AddBorder(std::size_t end, BorderLoop& loop) const;

  const BorderWay& Way;
  const std::vector<OpenCurve>& Curves;
  std::vector<BorderEnd> Ends; ///< in their order round the border
  std::size_t Inside;
  std::vector<std::size_t> NumberOf; ///< of the ends, by 2 * curve + which
};

/// Goes from an end along the inside of the border to the next one, and returns that.
std::size_t LoopFollower::AddBorder(std::size_t end, BorderLoop& loop) const
{
  const bool forward = end % 2 == this->Inside;
  const std::size_t count = this->Ends.size();
  const std::size_t other = forward ? (end + 1) % count : (end + count - 1) % count;
  const BorderEnd& from = this->Ends[forward ? end : other];
  const BorderEnd& to = this->Ends[forward ? other : end];
  std::vector<Point2> corners = this->Way.CornersBetween(from.Way, to.Way);
  if (!forward)
  {
    std::reverse(corners.begin(), corners.end());
  }
  loop.AlongBorder += this->Way.LengthBetween(from.Way, to.Way);
  std::vector<Point2>& points = loop.Curve.Points;
  points.push_back(this->Ends[end].Foot);
  points.insert(points.end(), corners.begin(), corners.end());
  points.push_back(this->Ends[other].Foot);
  return other;
}

BorderLoop LoopFollower::Follow(std::size_t curve, std::vector<std::uint8_t>& done) const
{
  BorderLoop loop;
  loop.Curve = this->Curves[curve];
  loop.Curve.Points.clear();
  int start = 0;
  while (!done[curve])
  {
    done[curve] = 1;
    std::vector<Point2> points = this->Curves[curve].Points;
    if (start == 1)
    {
      std::reverse(points.begin(), points.end());
    }
    loop.Curve.Points.insert(loop.Curve.Points.end(), points.begin(), points.end());
    const std::size_t next = this->AddBorder(this->NumberOf[2 * curve + (1 - start)], loop);
    curve = this->Ends[next].Curve;
    start = this->Ends[next].Which;
  }
  return loop;
}

std::vector<BorderLoop> LoopFollower::Run() const
{
  std::vector<BorderLoop> loops;
  std::vector<std::uint8_t> done(this->Curves.size(), 0);
  for (std::size_t curve = 0; curve < this->Curves.size(); ++curve)
  {
    if (!done[curve])
    {
      loops.push_back(this->Follow(curve, done));
    }
  }
  return loops;
}
}

void ImageBorder::Add(const Point2& point)
{
  for (const int direction : { 0, 1 })
  {
    this->Side[direction][0] = std::min(this->Side[direction][0], point[direction]);
    this->Side[direction][1] = std::max(this->Side[direction][1], point[direction]);
  }
}

int ImageBorder::SideOfEnd(const Point2& end, double distance) const
{
  int nearest = -1;
  for (int side = 0; side < 4; ++side)
  {
    const int direction = DirectionOf(side), which = WhichOf(side);
    const double found = std::abs(end[direction] - this->Side[direction][which]);
    if (this->IsFound[direction][which] && (nearest < 0 ? found <= distance : found < distance))
    {
      nearest = side;
      distance = found;
    }
  }
  return nearest;
}

bool ImageBorder::EndsAtBorder(const OpenCurve& curve) const
{
  const double reach = std::max(this->Tolerance, curve.MeanSegment());
  const int first = curve.Points.size() > 2 ? this->SideOfEnd(curve.End(0), reach) : -1;
  const int last = first >= 0 ? this->SideOfEnd(curve.End(1), reach) : -1;
  return last >= 0 &&
    (first != last ||
      LeavesSide(curve, DirectionOf(first), this->Side[DirectionOf(first)][WhichOf(first)],
        this->Tolerance));
}

std::vector<BorderLoop> CloseAlongBorder(
  const ImageBorder& border, const std::vector<OpenCurve>& curves)
{
  const BorderWay way(border);
  return LoopFollower(way, curves).Run();
}
}
