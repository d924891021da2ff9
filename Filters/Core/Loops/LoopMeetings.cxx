// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/LoopMeetings.h"

#include "Core/Base/EditContours.h"
#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"
#include "Core/Loops/LoopWindings.h"
#include "Core/Planar/SegmentTree.h"

#include <algorithm>
#include <map>

namespace orthoslices
{
namespace
{
using Segment = SegmentTree::Segment;

/// A contour on its way through a point: from a point over this one to the next one.
struct Passing
{
  Point2 From, To;
};

class MeetingFinder
{
public:
  explicit MeetingFinder(const Contours& contours)
    : Set(contours)
  {
  }

  std::vector<LoopMeeting> Run(const std::vector<Index>& members);

private:
  Point2 At(Index vertex) const { return { this->Set.U[vertex], this->Set.V[vertex] }; }
  Index After(const Segment& segment, Index vertex) const;
  Index Before(const Segment& segment, Index vertex) const;
  void FindFolds(Index contour);
  void Compare(const Segment& a, const Segment& b);
  bool DoCrossIn(const Point2& x, const Segment& a, const Segment& b) const;
  Passing PassingAt(const Point2& x, const Segment& segment) const;
  bool IsCrumbBetween(const Point2& x, const Segment& a, const Segment& b) const;
  void Add(const Segment& a, const Segment& b, const Point2& where, bool isTouch = false);

  const Contours& Set;
  std::map<std::pair<Index, Index>, std::size_t> Known; ///< where in Found a pair is
  std::vector<LoopMeeting> Found;
};

Index MeetingFinder::After(const Segment& segment, Index vertex) const
{
  const Index contour = segment.Contour;
  return vertex + 1 < this->Set.Offsets[contour + 1] ? vertex + 1 : this->Set.Offsets[contour];
}

Index MeetingFinder::Before(const Segment& segment, Index vertex) const
{
  const Index contour = segment.Contour;
  return (vertex > this->Set.Offsets[contour] ? vertex : this->Set.Offsets[contour + 1]) - 1;
}

void MeetingFinder::Add(const Segment& a, const Segment& b, const Point2& where, bool isTouch)
{
  const auto pair = std::minmax(a.Contour, b.Contour);
  const auto known = this->Known.emplace(pair, this->Found.size());
  if (known.second)
  {
    this->Found.push_back({ pair.first, pair.second, where, isTouch });
  }
  else if (this->Found[known.first->second].IsTouch && !isTouch)
  {
    this->Found[known.first->second] = { pair.first, pair.second, where, false };
  }
}

/// Whether a contour that comes back to a point has next to no area on its way there, or without it.
bool MeetingFinder::IsCrumbBetween(const Point2& x, const Segment& a, const Segment& b) const
{
  const Index first = std::min(a.Vertex, b.Vertex), last = std::max(a.Vertex, b.Vertex);
  std::vector<Point2> way{ x };
  for (Index i = first + 1; i <= last; ++i)
  {
    way.push_back(this->At(i));
  }
  const double between = SignedArea(way);
  const double rest = 0.5 * TwiceSignedArea(this->Set, a.Contour) - between;
  return std::min(std::abs(between), std::abs(rest)) <=
    LittleShare * std::max(std::abs(between), std::abs(rest));
}

/// The contour near a point of a segment.
Passing MeetingFinder::PassingAt(const Point2& x, const Segment& segment) const
{
  const Index end = this->After(segment, segment.Vertex);
  if (this->At(segment.Vertex) == x)
  {
    return { this->At(this->Before(segment, segment.Vertex)), this->At(end) };
  }
  return { this->At(segment.Vertex),
    this->At(this->At(end) == x ? this->After(segment, end) : end) };
}

/// Whether the contours cross, or run along each other, at a point that is on both segments.
bool MeetingFinder::DoCrossIn(const Point2& x, const Segment& a, const Segment& b) const
{
  const Passing one = this->PassingAt(x, a);
  const Passing other = this->PassingAt(x, b);
  for (const Point2& p : { one.From, one.To })
  {
    if (AreOnOneRay(x, p, other.From) || AreOnOneRay(x, p, other.To))
    {
      return true;
    }
  }
  return IsLeftOfPath(one.From, x, one.To, other.From) !=
    IsLeftOfPath(one.From, x, one.To, other.To);
}

void MeetingFinder::Compare(const Segment& a, const Segment& b)
{
  const Point2 p = this->At(a.Vertex);
  const Point2 q = this->At(this->After(a, a.Vertex));
  const Point2 r = this->At(b.Vertex);
  const Point2 s = this->At(this->After(b, b.Vertex));
  const int sideOfR = SideOf(p, q, r);
  const int sideOfS = SideOf(p, q, s);
  if (sideOfR * sideOfS > 0)
  {
    return;
  }
  const int sideOfP = SideOf(r, s, p);
  const int sideOfQ = SideOf(r, s, q);
  if (sideOfP * sideOfQ > 0)
  {
    return;
  }
  if (sideOfR * sideOfS < 0 && sideOfP * sideOfQ < 0)
  {
    const double from = std::abs(Cross(s - r, p - r));
    const double to = std::abs(Cross(s - r, q - r));
    this->Add(a, b, Between(p, q, from + to > 0.0 ? from / (from + to) : 0.5));
    return;
  }
  const auto isWithin = [](const Point2& x, const Point2& from, const Point2& to)
  {
    return std::min(from[0], to[0]) <= x[0] && x[0] <= std::max(from[0], to[0]) &&
      std::min(from[1], to[1]) <= x[1] && x[1] <= std::max(from[1], to[1]);
  };
  const auto test = [&](const Point2& x, int side, const Point2& from, const Point2& to)
  {
    if (side != 0 || !isWithin(x, from, to))
    {
      return;
    }
    const bool isTouch = !this->DoCrossIn(x, a, b);
    if (!isTouch || a.Contour != b.Contour || !this->IsCrumbBetween(x, a, b))
    {
      this->Add(a, b, x, isTouch);
    }
  };
  test(r, sideOfR, p, q);
  test(s, sideOfS, p, q);
  test(p, sideOfP, r, s);
  test(q, sideOfQ, r, s);
}

void MeetingFinder::FindFolds(Index contour)
{
  const Index first = this->Set.Offsets[contour];
  const Index end = this->Set.Offsets[contour + 1];
  Point2 before = this->At(end - 1);
  Point2 here = this->At(first);
  for (Index i = first; i < end; ++i)
  {
    const Point2 next = this->At(i + 1 < end ? i + 1 : first);
    if (Dot(before - here, next - here) > 0.0 && SideOf(before, here, next) == 0)
    {
      this->Add({ contour, i }, { contour, i }, here);
    }
    before = here;
    here = next;
  }
}

std::vector<LoopMeeting> MeetingFinder::Run(const std::vector<Index>& members)
{
  for (const Index contour : members)
  {
    this->FindFolds(contour);
  }
  SegmentTree(this->Set, members)
    .VisitOverlaps([this](const Segment& a, const Segment& b) { this->Compare(a, b); });
  return std::move(this->Found);
}
}

std::vector<LoopMeeting> FindLoopMeetings(
  const Contours& contours, const std::vector<Index>& members)
{
  return MeetingFinder(contours).Run(members);
}
}
