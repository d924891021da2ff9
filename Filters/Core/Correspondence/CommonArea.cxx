// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/CommonArea.h"

#include "Core/Planar/SegmentTree.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace orthoslices
{
namespace
{
/// Part of a boundary between two vertices of either region.
using Part = std::pair<Point2, Point2>;

/// In a point that is inside of both.
bool DoCross(const Part& a, const Part& b)
{
  return SideOf(a.first, a.second, b.first) * SideOf(a.first, a.second, b.second) < 0 &&
    SideOf(b.first, b.second, a.first) * SideOf(b.first, b.second, a.second) < 0;
}

bool LiesInside(const Point2& p, const Part& edge)
{
  for (int i = 0; i < 2; ++i)
  {
    const auto [low, high] = std::minmax(edge.first[i], edge.second[i]);
    if (p[i] < low || p[i] > high)
    {
      return false;
    }
  }
  return p != edge.first && p != edge.second && SideOf(edge.first, edge.second, p) == 0;
}

/// The boundaries of two regions, cut into parts where they touch.
class TwoBoundaries
{
public:
  TwoBoundaries(
    const ContourStack& stack, const std::vector<Index>& one, const std::vector<Index>& other)
  {
    this->Add(stack, one);
    this->Add(stack, other);
  }

  /// False if an edge crosses one of the other boundary.
  bool Split();
  /// Whether a part of this boundary has the interior of both regions beside it.
  bool PassesThroughOther(int region) const;

private:
  void Add(const ContourStack& stack, const std::vector<Index>& contours);
  Part EdgeFrom(const SegmentTree::Segment& segment) const;
  int RegionOf(const SegmentTree::Segment& segment) const
  {
    return segment.Contour < this->CountOfOne ? 0 : 1;
  }
  void AddParts(Index contour, Index vertex);
  bool IsWithin(const Part& part, const SegmentTree& edges) const;

  Contours Edges; ///< of both, those of the first region first
  Index CountOfOne = 0;
  std::vector<std::vector<Point2>> Touching; ///< of each edge: vertices of the other region on it
  std::array<std::vector<Part>, 2> Parts;
};

void TwoBoundaries::Add(const ContourStack& stack, const std::vector<Index>& contours)
{
  this->CountOfOne = this->Edges.Count();
  for (const Index contour : contours)
  {
    for (Index i = stack.Offsets[contour]; i < stack.Offsets[contour + 1]; ++i)
    {
      this->Edges.U.push_back(stack.U[i]);
      this->Edges.V.push_back(stack.V[i]);
    }
    this->Edges.Offsets.push_back(static_cast<Index>(this->Edges.U.size()));
    this->Edges.Axis.push_back(2);
    this->Edges.Coordinate.push_back(0.0);
  }
}

Part TwoBoundaries::EdgeFrom(const SegmentTree::Segment& segment) const
{
  const Contours& edges = this->Edges;
  const Index next = segment.Vertex + 1 < edges.Offsets[segment.Contour + 1]
    ? segment.Vertex + 1
    : edges.Offsets[segment.Contour];
  return { { edges.U[segment.Vertex], edges.V[segment.Vertex] }, { edges.U[next], edges.V[next] } };
}

/// Cuts an edge at the vertices of others that lie on it.
void TwoBoundaries::AddParts(Index contour, Index vertex)
{
  const Part edge = this->EdgeFrom({ contour, vertex });
  std::vector<Point2> places = this->Touching[vertex];
  places.push_back(edge.first);
  places.push_back(edge.second);
  // Along a segment, places ascend or descend in both coordinates.
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  if (edge.first > edge.second)
  {
    std::reverse(places.begin(), places.end());
  }
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
  {
    this->Parts[this->RegionOf({ contour, vertex })].push_back({ places[i], places[i + 1] });
  }
}

bool TwoBoundaries::Split()
{
  std::vector<Index> all(this->Edges.Count());
  std::iota(all.begin(), all.end(), 0);
  this->Touching.resize(this->Edges.U.size());
  bool doCross = false;
  const auto compare = [&](const SegmentTree::Segment& s, const SegmentTree::Segment& t)
  {
    if (this->RegionOf(s) == this->RegionOf(t))
    {
      return;
    }
    const Part a = this->EdgeFrom(s);
    const Part b = this->EdgeFrom(t);
    doCross = doCross || DoCross(a, b);
    for (const auto& [point, edge, number] :
      { std::make_tuple(b.first, a, s.Vertex), std::make_tuple(a.first, b, t.Vertex) })
    {
      if (LiesInside(point, edge))
      {
        this->Touching[number].push_back(point);
      }
    }
  };
  SegmentTree(this->Edges, all).VisitOverlaps(compare);
  for (Index contour = 0; contour < this->Edges.Count() && !doCross; ++contour)
  {
    for (Index i = this->Edges.Offsets[contour]; i < this->Edges.Offsets[contour + 1]; ++i)
    {
      this->AddParts(contour, i);
    }
  }
  return !doCross;
}

/// Whether a part that is on no edge lies inside; decided just behind its beginning p, as seen
/// along a ray towards +u. Where p is on the line of an edge, the end tells the side.
bool TwoBoundaries::IsWithin(const Part& part, const SegmentTree& edges) const
{
  const auto isAbove = [&](const Point2& q)
  { return q[1] > part.first[1] || (q[1] == part.first[1] && part.second[1] < part.first[1]); };
  bool within = false;
  edges.VisitAlongU(part.first[0], part.first[1],
    [&](const SegmentTree::Segment& segment)
    {
      const auto [a, b] = this->EdgeFrom(segment);
      const bool rises = isAbove(b);
      if (isAbove(a) != rises)
      {
        const int side = SideOf(a, b, part.first);
        within ^= (side != 0 ? side : SideOf(a, b, part.second)) == (rises ? 1 : -1);
      }
    });
  return within;
}

bool TwoBoundaries::PassesThroughOther(int region) const
{
  const std::vector<Part>& others = this->Parts[1 - region];
  const std::set<Part> known(others.begin(), others.end());
  std::vector<Index> members;
  for (Index contour = region == 0 ? this->CountOfOne : 0;
       contour < (region == 0 ? this->Edges.Count() : this->CountOfOne); ++contour)
  {
    members.push_back(contour);
  }
  const SegmentTree edges(this->Edges, members);
  return std::any_of(this->Parts[region].begin(), this->Parts[region].end(),
    [&](const Part& part)
    {
      return known.count(part) > 0 ||
        (known.count({ part.second, part.first }) == 0 && this->IsWithin(part, edges));
    });
}
}

bool HaveCommonArea(
  const ContourStack& stack, const std::vector<Index>& one, const std::vector<Index>& other)
{
  TwoBoundaries boundaries(stack, one, other);
  return !boundaries.Split() || boundaries.PassesThroughOther(0) ||
    boundaries.PassesThroughOther(1);
}
}
