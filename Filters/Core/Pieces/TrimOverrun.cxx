// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/TrimOverrun.h"

#include "Core/Base/Predicates.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// More of a curve than that is not taken for an overrun.
constexpr double GreatestShare = 0.25;
/// A curve that passes its start comes so much closer to it than where it ends.
constexpr double PassingShare = 0.25;

struct Box2
{
  Point2 Low{ HUGE_VAL, HUGE_VAL };
  Point2 High{ -HUGE_VAL, -HUGE_VAL };

  void Add(const Point2& p)
  {
    this->Low = { std::min(this->Low[0], p[0]), std::min(this->Low[1], p[1]) };
    this->High = { std::max(this->High[0], p[0]), std::max(this->High[1], p[1]) };
  }
  bool Meets(const Box2& other) const
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
      this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1];
  }
};

/// The share of the segment from a to b at which it is nearest to p.
double NearestShare(const Point2& a, const Point2& b, const Point2& p)
{
  const double length = SquaredDistance(a, b);
  return length > 0.0 ? std::min(1.0, std::max(0.0, Dot(p - a, b - a) / length)) : 0.0;
}

/// A point of the first part and one of the last that become one.
struct Meeting
{
  std::size_t First = 0, Last = 0; ///< segments, by their first points
  double FirstShare = 0.0, LastShare = 0.0;
  double Trimmed = HUGE_VAL; ///< length of what lies before and after
  double Before = 0.0;       ///< of what lies before

  bool IsFound() const { return this->Trimmed < HUGE_VAL; }
};

/// One end of a curve: up to a quarter of its length.
struct CurvePart
{
  const std::vector<Point2>& Points;
  std::vector<double> Way; ///< length of the curve up to each point
  std::size_t Begin, End;  ///< segments

  CurvePart(const std::vector<Point2>& points, bool isLast);
  const Point2& At(std::size_t i) const { return this->Points[i]; }
  double Total() const { return this->Way.back(); }
  double WayTo(std::size_t segment, double share) const
  {
    return this->Way[segment] + share * (this->Way[segment + 1] - this->Way[segment]);
  }
  Box2 BoxOf(std::size_t segment) const
  {
    Box2 box;
    box.Add(this->At(segment));
    box.Add(this->At(segment + 1));
    return box;
  }
  /// The segments whose boxes meet that of others.
  std::vector<std::size_t> SegmentsNear(const Box2& box) const;
};

CurvePart::CurvePart(const std::vector<Point2>& points, bool isLast)
  : Points(points)
  , Way(points.size(), 0.0)
  , Begin(0)
  , End(points.size() - 1)
{
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    this->Way[i] = this->Way[i - 1] + Distance(points[i - 1], points[i]);
  }
  // The last segment may be longer; what lies beyond the quarter is not trimmed.
  const double part = GreatestShare * this->Total();
  while (
    isLast && this->Begin + 1 < this->End && this->Total() - this->Way[this->Begin + 1] >= part)
  {
    ++this->Begin;
  }
  while (!isLast && this->End > 1 && this->Way[this->End - 1] >= part)
  {
    --this->End;
  }
}

std::vector<std::size_t> CurvePart::SegmentsNear(const Box2& box) const
{
  std::vector<std::size_t> near;
  for (std::size_t i = this->Begin; i < this->End; ++i)
  {
    if (this->BoxOf(i).Meets(box))
    {
      near.push_back(i);
    }
  }
  return near;
}

/// Finds where the last part of a curve meets the first part of one, which may be the same.
class MeetingFinder
{
public:
  MeetingFinder(const std::vector<Point2>& last, const std::vector<Point2>& first)
    : Last(last, true)
    , First(first, false)
  {
    if (&last == &first)
    {
      // Neighbouring segments touch each other in any case.
      this->Last.Begin = std::max(this->Last.Begin, this->First.End + 1);
    }
  }

  Meeting Find() const;

private:
  Meeting FindContact() const;
  Meeting FindPassing() const;
  void Meet(std::size_t i, std::size_t j, Meeting& best) const;
  void Consider(Meeting meeting, Meeting& best) const;
  bool RunsAlongFirstPart(const Point2& point, double distance) const;

  CurvePart Last, First;
};

/// Takes a meeting if it trims less than the best, and no more than a quarter of either curve.
void MeetingFinder::Consider(Meeting meeting, Meeting& best) const
{
  const double before = this->First.WayTo(meeting.First, meeting.FirstShare);
  const double after = this->Last.Total() - this->Last.WayTo(meeting.Last, meeting.LastShare);
  meeting.Trimmed = before + after;
  meeting.Before = before;
  // Of a part that is drawn twice either may go: the second one does, but for rounding.
  const double rounding = 1e-9 * this->Last.Total();
  const bool isBetter = meeting.Trimmed < best.Trimmed - rounding ||
    (meeting.Trimmed <= best.Trimmed + rounding && before < best.Before);
  if (before <= GreatestShare * this->First.Total() &&
    after <= GreatestShare * this->Last.Total() && isBetter)
  {
    best = meeting;
  }
}

/// Considers where segment i of the first part crosses or touches segment j of the last one.
void MeetingFinder::Meet(std::size_t i, std::size_t j, Meeting& best) const
{
  const Point2 &a = this->First.At(i), &b = this->First.At(i + 1);
  const Point2 &c = this->Last.At(j), &d = this->Last.At(j + 1);
  const int sideA = SideOf(c, d, a), sideB = SideOf(c, d, b);
  const int sideC = SideOf(a, b, c), sideD = SideOf(a, b, d);
  if (sideA * sideB < 0 && sideC * sideD < 0)
  {
    const double t = Cross(c - a, d - c) / Cross(b - a, d - c);
    this->Consider({ i, j, t, NearestShare(c, d, Between(a, b, t)) }, best);
    return;
  }
  const auto lies = [](int side, const Point2& p, const Point2& q, const Point2& r)
  {
    return side == 0 && std::min(p[0], q[0]) <= r[0] && r[0] <= std::max(p[0], q[0]) &&
      std::min(p[1], q[1]) <= r[1] && r[1] <= std::max(p[1], q[1]);
  };
  const std::pair<bool, Meeting> touches[] = { { lies(sideA, c, d, a),
                                                 { i, j, 0.0, NearestShare(c, d, a) } },
    { lies(sideB, c, d, b), { i, j, 1.0, NearestShare(c, d, b) } },
    { lies(sideC, a, b, c), { i, j, NearestShare(a, b, c), 0.0 } },
    { lies(sideD, a, b, d), { i, j, NearestShare(a, b, d), 1.0 } } };
  for (const auto& touch : touches)
  {
    if (touch.first)
    {
      this->Consider(touch.second, best);
    }
  }
}

/// Where the parts cross or touch; of several places, the one that trims least.
Meeting MeetingFinder::FindContact() const
{
  Meeting best;
  Box2 box;
  for (std::size_t i = this->First.Begin; i < this->First.End; ++i)
  {
    box.Add(this->First.At(i));
    box.Add(this->First.At(i + 1));
  }
  const std::vector<std::size_t> last = this->Last.SegmentsNear(box);
  box = Box2();
  for (const std::size_t j : last)
  {
    box.Add(this->Last.At(j));
    box.Add(this->Last.At(j + 1));
  }
  for (const std::size_t i : this->First.SegmentsNear(box))
  {
    const Box2 segment = this->First.BoxOf(i);
    for (const std::size_t j : last)
    {
      if (segment.Meets(this->Last.BoxOf(j)))
      {
        this->Meet(i, j, best);
      }
    }
  }
  return best;
}

bool MeetingFinder::RunsAlongFirstPart(const Point2& point, double distance) const
{
  for (std::size_t i = this->First.Begin; i < this->First.End; ++i)
  {
    const Point2 &a = this->First.At(i), &b = this->First.At(i + 1);
    if (Distance(point, Between(a, b, NearestShare(a, b, point))) <= distance)
    {
      return true;
    }
  }
  return false;
}

/// Where the last part passes the first point, if from there on it runs along the first part.
Meeting MeetingFinder::FindPassing() const
{
  const Point2& start = this->First.At(0);
  const double reach = PassingShare * Distance(start, this->Last.Points.back());
  Meeting nearest;
  double least = reach;
  for (std::size_t j = this->Last.Begin; j < this->Last.End; ++j)
  {
    const Point2 &a = this->Last.At(j), &b = this->Last.At(j + 1);
    const double share = NearestShare(a, b, start);
    const double distance = Distance(start, Between(a, b, share));
    if (distance < least)
    {
      least = distance;
      nearest = Meeting();
      this->Consider({ 0, j, 0.0, share }, nearest);
    }
  }
  bool along = nearest.IsFound();
  for (std::size_t j = nearest.Last + 1; along && j < this->Last.Points.size(); ++j)
  {
    along = this->RunsAlongFirstPart(this->Last.At(j), reach);
  }
  return along ? nearest : Meeting();
}

Meeting MeetingFinder::Find() const
{
  const Meeting contact = this->FindContact();
  return contact.IsFound() ? contact : this->FindPassing();
}

/// Leaves of the first curve what comes after the meeting.
void TrimFront(const Meeting& meeting, std::vector<Point2>& first)
{
  const Point2 at = Between(first[meeting.First], first[meeting.First + 1], meeting.FirstShare);
  first.erase(first.begin(), first.begin() + meeting.First);
  first.front() = at;
}
}

bool TrimOverrun(OpenCurve& curve)
{
  if (curve.Points.size() < 4)
  {
    return false;
  }
  const Meeting meeting = MeetingFinder(curve.Points, curve.Points).Find();
  if (!meeting.IsFound() || meeting.Last < meeting.First + 2)
  {
    return false;
  }
  curve.Points.resize(meeting.Last + 1);
  TrimFront(meeting, curve.Points);
  curve.Trimmed = meeting.Trimmed;
  curve.IsLoop = true;
  return true;
}

double TrimOverlap(std::vector<Point2>& curve, std::vector<Point2>& next)
{
  if (curve.size() < 3 || next.size() < 3)
  {
    return 0.0;
  }
  const Meeting meeting = MeetingFinder(curve, next).Find();
  if (!meeting.IsFound())
  {
    return 0.0;
  }
  curve.resize(meeting.Last + 1);
  TrimFront(meeting, next);
  return meeting.Trimmed;
}
}
