// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OrientContours.h"

#include "SegmentTree.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
using Slice = std::vector<Index>; ///< contours on one plane

std::vector<Slice> GroupBySlice(const Contours& contours)
{
  std::vector<Index> order(contours.Count());
  for (Index i = 0; i < contours.Count(); ++i)
  {
    order[i] = i;
  }
  const auto key = [&](Index i) { return std::make_pair(contours.Axis[i], contours.Plane[i]); };
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  std::vector<Slice> slices;
  for (const Index i : order)
  {
    if (slices.empty() || key(slices.back().front()) != key(i))
    {
      slices.emplace_back();
    }
    slices.back().push_back(i);
  }
  return slices;
}

/// Side of point r against the line through p and q: 1 left, -1 right, 0 not certain.
int CertainSide(const double p[2], const double q[2], const double r[2])
{
  const double left = (p[0] - r[0]) * (q[1] - r[1]);
  const double right = (p[1] - r[1]) * (q[0] - r[0]);
  // Shewchuk's bound for the rounding error of the 2D orientation test.
  const double bound = 3.3306690738754716e-16 * (std::abs(left) + std::abs(right));
  const double det = left - right;
  return det > bound ? 1 : det < -bound ? -1 : 0;
}

class SliceOrienter
{
public:
  SliceOrienter(Contours& contours, std::vector<std::uint8_t>& bad, std::vector<Problem>& problems)
    : Set(contours)
    , Bad(bad)
    , Problems(problems)
  {
  }

  void RemoveCrossing(const Slice& slice);
  void OrientByNesting(const Slice& slice);

private:
  void VisitPair(SegmentTree::Segment a, SegmentTree::Segment b);
  void GetSegment(SegmentTree::Segment segment, double p[2], double q[2]) const;
  bool CertainlyCross(SegmentTree::Segment a, SegmentTree::Segment b) const;
  void Mark(Index contour, ProblemKind kind, Index vertex);

  Contours& Set;
  std::vector<std::uint8_t>& Bad;
  std::vector<Problem>& Problems;
};

void SliceOrienter::GetSegment(SegmentTree::Segment segment, double p[2], double q[2]) const
{
  const Index i = segment.Vertex;
  const Index j =
    i + 1 < this->Set.Offsets[segment.Contour + 1] ? i + 1 : this->Set.Offsets[segment.Contour];
  p[0] = this->Set.U[i];
  p[1] = this->Set.V[i];
  q[0] = this->Set.U[j];
  q[1] = this->Set.V[j];
}

bool SliceOrienter::CertainlyCross(SegmentTree::Segment a, SegmentTree::Segment b) const
{
  double a0[2], a1[2], b0[2], b1[2];
  this->GetSegment(a, a0, a1);
  this->GetSegment(b, b0, b1);
  return CertainSide(a0, a1, b0) * CertainSide(a0, a1, b1) < 0 &&
    CertainSide(b0, b1, a0) * CertainSide(b0, b1, a1) < 0;
}

void SliceOrienter::Mark(Index contour, ProblemKind kind, Index vertex)
{
  this->Bad[contour] = 1;
  this->Problems.push_back(
    { kind, this->Set.Axis[contour], this->Set.Cell[contour], this->Set.World(contour, vertex) });
}

void SliceOrienter::VisitPair(SegmentTree::Segment a, SegmentTree::Segment b)
{
  if (this->Bad[a.Contour] || this->Bad[b.Contour] || !this->CertainlyCross(a, b))
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

void SliceOrienter::RemoveCrossing(const Slice& slice)
{
  const SegmentTree tree(this->Set, slice);
  tree.VisitOverlaps(
    [this](SegmentTree::Segment a, SegmentTree::Segment b) { this->VisitPair(a, b); });
}

void SliceOrienter::OrientByNesting(const Slice& slice)
{
  Slice members;
  std::copy_if(slice.begin(), slice.end(), std::back_inserter(members),
    [this](Index contour) { return !this->Bad[contour]; });
  const SegmentTree tree(this->Set, members.size() > 1 ? members : Slice());
  std::vector<Index> reversed;
  for (const Index contour : members)
  {
    // An extreme vertex, so that a contour that touches another one is judged where they part.
    const Index begin = this->Set.Offsets[contour];
    const auto u = this->Set.U.begin();
    const Index extreme =
      static_cast<Index>(std::min_element(u + begin, u + this->Set.Offsets[contour + 1]) - u);
    const Index depth = tree.CountAbove(this->Set.U[extreme], this->Set.V[extreme], contour);
    const bool outer = depth % 2 == 0;
    if ((TwiceSignedArea(this->Set, contour) > 0.0) != outer)
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

void RemoveMarked(const std::vector<std::uint8_t>& marked, Contours& contours)
{
  Contours kept;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    if (marked[i])
    {
      continue;
    }
    const Index begin = contours.Offsets[i];
    const Index end = contours.Offsets[i + 1];
    kept.U.insert(kept.U.end(), contours.U.begin() + begin, contours.U.begin() + end);
    kept.V.insert(kept.V.end(), contours.V.begin() + begin, contours.V.begin() + end);
    kept.Offsets.push_back(static_cast<Index>(kept.U.size()));
    kept.Axis.push_back(contours.Axis[i]);
    kept.Coordinate.push_back(contours.Coordinate[i]);
    kept.Plane.push_back(contours.Plane[i]);
    kept.Cell.push_back(contours.Cell[i]);
  }
  contours = std::move(kept);
}
}

double TwiceSignedArea(const Contours& contours, Index contour)
{
  const Index begin = contours.Offsets[contour];
  const Index end = contours.Offsets[contour + 1];
  const double u0 = contours.U[begin];
  const double v0 = contours.V[begin];
  double area = 0.0;
  for (Index i = begin + 1; i + 1 < end; ++i)
  {
    area += (contours.U[i] - u0) * (contours.V[i + 1] - v0) -
      (contours.U[i + 1] - u0) * (contours.V[i] - v0);
  }
  return area;
}

void OrientContours(Orientation orientation, const Execution& execution, Contours& contours,
  std::vector<Problem>& problems)
{
  const std::vector<Slice> slices = GroupBySlice(contours);
  std::vector<std::uint8_t> bad(contours.Count(), 0);
  std::vector<std::vector<Problem>> found(slices.size());
  execution.For(slices.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        SliceOrienter orienter(contours, bad, found[i]);
        orienter.RemoveCrossing(slices[i]);
        if (orientation == Orientation::ByNesting)
        {
          orienter.OrientByNesting(slices[i]);
        }
      }
    });
  for (const std::vector<Problem>& list : found)
  {
    problems.insert(problems.end(), list.begin(), list.end());
  }
  if (std::any_of(bad.begin(), bad.end(), [](std::uint8_t flag) { return flag != 0; }))
  {
    RemoveMarked(bad, contours);
  }
}
}
