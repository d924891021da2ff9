// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/OverlapCriterion.h"

#include "Core/Correspondence/CommonArea.h"
#include "Core/Correspondence/ContourNesting.h"
#include "Core/Planar/SegmentTree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace orthoslices
{
namespace
{
using PairSet = std::set<std::pair<Index, Index>>;

struct Edge
{
  Index Contour, Start, End;
};

/**
 * Two neighbouring slices, the upper one moved by an infinitely small nudge, so that nothing
 * touches. Then two regions overlap if and only if their boundaries cross, or a whole contour that
 * bounds one lies in the other: both sides of every crossing and of every contour's first vertex
 * are listed. Regions that overlap without the nudge are among them; where the nudge decided,
 * they are compared once more.
 */
class SlicePair
{
public:
  SlicePair(const ContourStack& stack, const std::vector<Index>& parents,
    const std::vector<PlanarBox>& boxes, const std::vector<double>& areas)
    : Stack(stack)
    , Parents(parents)
    , Boxes(boxes)
    , Areas(areas)
  {
  }

  PairSet Overlaps(Index lowerBegin, Index upperBegin, Index upperEnd);

private:
  void FindCrossings(Index lowerBegin, Index upperBegin, Index upperEnd);
  void FindContainments(Index begin, Index end, Index otherBegin, Index otherEnd);
  bool DoCross(const Edge& lower, const Edge& upper, bool& tied) const;
  void AddRegion(Index lower, Index upper, bool tied);
  std::vector<Index> BoundaryOf(Index contour, Index begin, Index end) const;

  const ContourStack& Stack;
  const std::vector<Index>& Parents;
  const std::vector<PlanarBox>& Boxes;
  const std::vector<double>& Areas;
  const Nudge Move{ 1, 1 };   ///< of the upper slice
  const Nudge Back{ -1, -1 }; ///< the same, for the lower one
  PairSet Certain;            ///< overlap without the nudge
  PairSet Tied;               ///< overlap with the nudge
};

bool SlicePair::DoCross(const Edge& lower, const Edge& upper, bool& tied) const
{
  const Point2 a = this->Stack.At(lower.Start), b = this->Stack.At(lower.End);
  const Point2 c = this->Stack.At(upper.Start), d = this->Stack.At(upper.End);
  return NudgedSideOf(a, b, c, this->Move, tied) != NudgedSideOf(a, b, d, this->Move, tied) &&
    NudgedSideOf(c, d, a, this->Back, tied) != NudgedSideOf(c, d, b, this->Back, tied);
}

/// Outer boundaries correspond to outer boundaries, holes to holes.
void SlicePair::AddRegion(Index lower, Index upper, bool tied)
{
  if (lower >= 0 && upper >= 0 && (this->Areas[lower] > 0.0) == (this->Areas[upper] > 0.0))
  {
    (tied ? this->Tied : this->Certain).insert({ lower, upper });
  }
}

void SlicePair::FindCrossings(Index lowerBegin, Index upperBegin, Index upperEnd)
{
  const Index first = this->Stack.Offsets[lowerBegin];
  Contours both; // numbered from 0
  both.U.assign(
    this->Stack.U.begin() + first, this->Stack.U.begin() + this->Stack.Offsets[upperEnd]);
  both.V.assign(
    this->Stack.V.begin() + first, this->Stack.V.begin() + this->Stack.Offsets[upperEnd]);
  for (Index contour = lowerBegin; contour < upperEnd; ++contour)
  {
    both.Offsets.push_back(this->Stack.Offsets[contour + 1] - first);
  }
  std::vector<Index> all(upperEnd - lowerBegin);
  std::iota(all.begin(), all.end(), 0);
  const auto edgeOf = [&](const SegmentTree::Segment& segment)
  {
    const Index contour = lowerBegin + segment.Contour;
    const Index start = first + segment.Vertex;
    return Edge{ contour, start, this->Stack.Next(contour, start) };
  };
  const auto compare = [&](const SegmentTree::Segment& s, const SegmentTree::Segment& t)
  {
    const Edge one = edgeOf(s);
    const Edge other = edgeOf(t);
    if ((one.Contour < upperBegin) == (other.Contour < upperBegin))
    {
      return;
    }
    const Edge& lower = one.Contour < upperBegin ? one : other;
    const Edge& upper = one.Contour < upperBegin ? other : one;
    bool tied = false;
    if (this->DoCross(lower, upper, tied))
    {
      // A contour has its own interior on one side and that of its parent on the other.
      for (const Index a : { lower.Contour, this->Parents[lower.Contour] })
      {
        this->AddRegion(a, upper.Contour, tied);
        this->AddRegion(a, this->Parents[upper.Contour], tied);
      }
    }
  };
  SegmentTree(both, std::move(all)).VisitOverlaps(compare);
}

/// The region of the other slice in which the first vertex of each contour lies.
void SlicePair::FindContainments(Index begin, Index end, Index otherBegin, Index otherEnd)
{
  const bool upper = begin > otherBegin;
  for (Index contour = begin; contour < end; ++contour)
  {
    const Point2 p = this->Stack.At(this->Stack.Offsets[contour]);
    Index region = -1;
    bool tied = false;
    for (Index other = otherBegin; other < otherEnd; ++other)
    {
      if (this->Boxes[other].Contains(p) &&
        (region < 0 || std::abs(this->Areas[other]) < std::abs(this->Areas[region])) &&
        IsWithin(this->Stack, other, p, upper ? this->Move : this->Back, tied))
      {
        region = other;
      }
    }
    for (const Index side : { contour, this->Parents[contour] })
    {
      this->AddRegion(upper ? region : side, upper ? side : region, tied);
    }
  }
}

/// The contours that bound the interior of one of its slice: itself and its children.
std::vector<Index> SlicePair::BoundaryOf(Index contour, Index begin, Index end) const
{
  std::vector<Index> boundary{ contour };
  for (Index i = begin; i < end; ++i)
  {
    if (this->Parents[i] == contour)
    {
      boundary.push_back(i);
    }
  }
  return boundary;
}

PairSet SlicePair::Overlaps(Index lowerBegin, Index upperBegin, Index upperEnd)
{
  this->Certain.clear();
  this->Tied.clear();
  this->FindCrossings(lowerBegin, upperBegin, upperEnd);
  this->FindContainments(lowerBegin, upperBegin, upperBegin, upperEnd);
  this->FindContainments(upperBegin, upperEnd, lowerBegin, upperBegin);
  for (const auto& pair : this->Tied)
  {
    if (this->Certain.count(pair) == 0 &&
      HaveCommonArea(this->Stack, this->BoundaryOf(pair.first, lowerBegin, upperBegin),
        this->BoundaryOf(pair.second, upperBegin, upperEnd)))
    {
      this->Certain.insert(pair);
    }
  }
  return this->Certain;
}
}

std::vector<Correspondence> CorrespondencesByOverlap(const ContourStack& stack)
{
  const std::vector<Index> first = FirstContourOfSlices(stack);
  const std::vector<Index> parents = FindParents(stack);
  const std::vector<PlanarBox> boxes = BoxesOf(stack);
  const std::vector<double> areas = SignedAreas(stack);
  SlicePair slices(stack, parents, boxes, areas);
  std::vector<Correspondence> pairs;
  for (Index slice = 0; slice + 1 < stack.SliceCount(); ++slice)
  {
    for (const auto& pair : slices.Overlaps(first[slice], first[slice + 1], first[slice + 2]))
    {
      pairs.push_back({ pair.first, pair.second });
    }
  }
  return pairs;
}
}
