// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/OrientContours.h"

#include "Core/Base/EditContours.h"
#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"
#include "Core/Planar/SegmentTree.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
using Slice = std::vector<Index>; ///< contours on one plane

class SliceOrienter
{
public:
  SliceOrienter(
    Contours& contours, std::vector<std::uint8_t>& removed, std::vector<Problem>& problems)
    : Set(contours)
    , Removed(removed)
    , Problems(problems)
  {
  }

  void RemoveVirtual(const Slice& slice);
  void FindCrossing(const Slice& slice);
  void OrientByNesting(const Slice& slice);

private:
  void VisitPair(SegmentTree::Segment a, SegmentTree::Segment b);
  std::array<Point2, 2> Ends(SegmentTree::Segment segment) const;
  bool DoCross(SegmentTree::Segment a, SegmentTree::Segment b) const;
  void Mark(Index contour, ProblemKind kind, Index vertex);

  Slice Members(const Slice& slice) const;
  bool IsOuter(const SegmentTree& tree, Index contour) const;

  Contours& Set;
  std::vector<std::uint8_t>& Removed;
  std::vector<Problem>& Problems;
  std::vector<Index> Reported;
};

/// The contours of a slice that are not removed.
Slice SliceOrienter::Members(const Slice& slice) const
{
  Slice members;
  std::copy_if(slice.begin(), slice.end(), std::back_inserter(members),
    [this](Index contour) { return !this->Removed[contour]; });
  return members;
}

/// Whether a contour encloses the interior: of places spread over it, the middles of sides, most lie
/// within an even number of others. Noise may have put a few of them beyond another contour.
bool SliceOrienter::IsOuter(const SegmentTree& tree, Index contour) const
{
  constexpr Index places = 15;
  const Index count = this->Set.Size(contour);
  Index outer = 0;
  for (Index k = 0; k < places; ++k)
  {
    const Index vertex =
      this->Set.Offsets[contour] + static_cast<Index>(std::int64_t(k) * count / places);
    const auto ends = this->Ends({ contour, vertex });
    const Point2 middle = Between(ends[0], ends[1], 0.5);
    outer += tree.CountAbove(middle[0], middle[1], contour) % 2 == 0 ? 1 : 0;
  }
  return 2 * outer > places;
}

/// Contours of a virtual plane that has become one with a real one are not those of the slice.
void SliceOrienter::RemoveVirtual(const Slice& slice)
{
  for (const Index contour : slice)
  {
    this->Removed[contour] = this->Set.IsVirtual(contour) ? 1 : 0;
  }
}

std::array<Point2, 2> SliceOrienter::Ends(SegmentTree::Segment segment) const
{
  const Index i = segment.Vertex;
  const Index j =
    i + 1 < this->Set.Offsets[segment.Contour + 1] ? i + 1 : this->Set.Offsets[segment.Contour];
  return { Point2{ this->Set.U[i], this->Set.V[i] }, Point2{ this->Set.U[j], this->Set.V[j] } };
}

bool SliceOrienter::DoCross(SegmentTree::Segment a, SegmentTree::Segment b) const
{
  const auto p = this->Ends(a);
  const auto q = this->Ends(b);
  return SideOf(p[0], p[1], q[0]) * SideOf(p[0], p[1], q[1]) < 0 &&
    SideOf(q[0], q[1], p[0]) * SideOf(q[0], q[1], p[1]) < 0;
}

void SliceOrienter::Mark(Index contour, ProblemKind kind, Index vertex)
{
  this->Reported.push_back(contour);
  this->Removed[contour] = 1;
  this->Problems.push_back({ kind, this->Set.Axis[contour], this->Set.Cell[contour],
    this->Set.World(contour, vertex), 0.0, true });
}

void SliceOrienter::VisitPair(SegmentTree::Segment a, SegmentTree::Segment b)
{
  const auto reported = [this](Index contour)
  {
    return std::find(this->Reported.begin(), this->Reported.end(), contour) != this->Reported.end();
  };
  if (!this->DoCross(a, b) || reported(a.Contour) || reported(b.Contour))
  {
    return;
  }
  if (a.Contour == b.Contour)
  {
    this->Mark(a.Contour, ProblemKind::CrossesItself, a.Vertex);
    return;
  }
  const double areaA = std::abs(TwiceSignedArea(this->Set, a.Contour));
  const double areaB = std::abs(TwiceSignedArea(this->Set, b.Contour));
  const SegmentTree::Segment smaller = areaA < areaB ? a : b;
  this->Mark(smaller.Contour, ProblemKind::CrossesOther, smaller.Vertex);
}

void SliceOrienter::FindCrossing(const Slice& slice)
{
  const SegmentTree tree(this->Set, this->Members(slice));
  tree.VisitOverlaps(
    [this](SegmentTree::Segment a, SegmentTree::Segment b) { this->VisitPair(a, b); });
}

void SliceOrienter::OrientByNesting(const Slice& slice)
{
  const Slice members = this->Members(slice);
  const SegmentTree tree(this->Set, members.size() > 1 ? members : Slice());
  std::vector<Index> reversed;
  for (const Index contour : members)
  {
    if ((TwiceSignedArea(this->Set, contour) > 0.0) != this->IsOuter(tree, contour))
    {
      reversed.push_back(contour);
    }
  }
  for (const Index contour : reversed)
  {
    const Index begin = this->Set.Offsets[contour];
    const Index end = this->Set.Offsets[contour + 1];
    std::reverse(this->Set.U.begin() + begin, this->Set.U.begin() + end);
    std::reverse(this->Set.V.begin() + begin, this->Set.V.begin() + end);
  }
}
}

bool BoundOutside(const Contours& contours)
{
  double area = 0.0;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    area += contours.IsVirtual(contour) ? 0.0 : TwiceSignedArea(contours, contour);
  }
  return area < 0.0;
}

void OrientContours(Orientation orientation, bool removeCrossing, Index firstSettled,
  const Execution& execution, Contours& contours, std::vector<Problem>& crossing)
{
  const std::vector<Slice> slices = GroupBySlice(contours);
  std::vector<std::uint8_t> removed(contours.Count(), 0);
  std::vector<std::vector<Problem>> found(slices.size());
  execution.For(slices.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto isVirtual = [&](Index contour) { return contours.IsVirtual(contour); };
        const bool isSettled = slices[i].front() >= firstSettled;
        if (isSettled || std::all_of(slices[i].begin(), slices[i].end(), isVirtual))
        {
          continue;
        }
        SliceOrienter orienter(contours, removed, found[i]);
        orienter.RemoveVirtual(slices[i]);
        if (removeCrossing)
        {
          orienter.FindCrossing(slices[i]);
        }
        if (orientation == Orientation::ByNesting)
        {
          orienter.OrientByNesting(slices[i]);
        }
      }
    });
  for (const std::vector<Problem>& list : found)
  {
    crossing.insert(crossing.end(), list.begin(), list.end());
  }
  if (std::any_of(removed.begin(), removed.end(), [](std::uint8_t flag) { return flag != 0; }))
  {
    RemoveMarked(removed, contours);
  }
}
}
