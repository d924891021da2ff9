// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/OverlapCriterion.h"

#include "Core/Correspondence/CommonArea.h"
#include "Core/Correspondence/ContourNesting.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace orthoslices
{
namespace
{
using PairSet = std::set<std::pair<Index, Index>>;

struct Edge
{
  Index Contour, Start, End;
  bool Upper;
  PlanarBox Box;
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
  void AddEdges(Index begin, Index end, bool upper);
  void FindCrossings();
  void FindContainments(Index begin, Index end, Index otherBegin, Index otherEnd);
  bool DoCross(const Edge& lower, const Edge& upper, bool& tied) const;
  void AddRegion(Index lower, Index upper, bool tied);
  std::vector<Index> BoundaryOf(Index contour, Index begin, Index end) const;

  const ContourStack& Stack;
  const std::vector<Index>& Parents;
  const std::vector<PlanarBox>& Boxes;
  const std::vector<double>& Areas;
  std::vector<Edge> Edges;    ///< of both slices
  const Nudge Move{ 1, 1 };   ///< of the upper slice
  const Nudge Back{ -1, -1 }; ///< the same, for the lower one
  PairSet Certain;            ///< overlap without the nudge
  PairSet Tied;               ///< overlap with the nudge
};

void SlicePair::AddEdges(Index begin, Index end, bool upper)
{
  for (Index contour = begin; contour < end; ++contour)
  {
    for (Index i = this->Stack.Offsets[contour]; i < this->Stack.Offsets[contour + 1]; ++i)
    {
      const Index next = this->Stack.Next(contour, i);
      const Point2 a = this->Stack.At(i);
      const Point2 b = this->Stack.At(next);
      this->Edges.push_back({ contour, i, next, upper,
        { { std::min(a[0], b[0]), std::min(a[1], b[1]) },
          { std::max(a[0], b[0]), std::max(a[1], b[1]) } } });
    }
  }
}

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

/// Sweep along u; edges are sorted by where they begin.
void SlicePair::FindCrossings()
{
  std::array<std::vector<const Edge*>, 2> active;
  for (const Edge& edge : this->Edges)
  {
    std::vector<const Edge*>& others = active[edge.Upper ? 0 : 1];
    others.erase(std::remove_if(others.begin(), others.end(),
                   [&](const Edge* other) { return other->Box.High[0] < edge.Box.Low[0]; }),
      others.end());
    for (const Edge* other : others)
    {
      const bool apart =
        other->Box.High[1] < edge.Box.Low[1] || other->Box.Low[1] > edge.Box.High[1];
      const Edge& lower = edge.Upper ? *other : edge;
      const Edge& upper = edge.Upper ? edge : *other;
      bool tied = false;
      if (!apart && this->DoCross(lower, upper, tied))
      {
        // A contour has its own interior on one side and that of its parent on the other.
        for (const Index a : { lower.Contour, this->Parents[lower.Contour] })
        {
          this->AddRegion(a, upper.Contour, tied);
          this->AddRegion(a, this->Parents[upper.Contour], tied);
        }
      }
    }
    active[edge.Upper ? 1 : 0].push_back(&edge);
  }
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
  this->Edges.clear();
  this->AddEdges(lowerBegin, upperBegin, false);
  this->AddEdges(upperBegin, upperEnd, true);
  std::stable_sort(this->Edges.begin(), this->Edges.end(),
    [](const Edge& a, const Edge& b) { return a.Box.Low[0] < b.Box.Low[0]; });
  this->FindCrossings();
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
