// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/OverlayGraph.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <numeric>

namespace orthoslices
{
namespace
{
constexpr Index None = -1;
}

OverlayGraph::OverlayGraph(
  const std::vector<SlabLoop>& loops, const Point2& shift, const Point2& displacement)
  : Loops(loops)
{
  for (const SlabLoop& loop : loops)
  {
    for (const Point2& point : loop.Points)
    {
      const Index node = this->Vertices++;
      this->Places.push_back(!loop.Upper ? point
                                         : Point2{ (point[0] - shift[0]) + displacement[0],
                                             (point[1] - shift[1]) + displacement[1] });
      this->OnLevel.push_back(loop.Upper);
      this->AddNode(this->Whole, node);
    }
    this->EndChain(this->Whole, loop);
  }
}

void OverlayGraph::AddNode(Chains& chains, Index node) const
{
  chains.Numbers.push_back(node);
  chains.Nodes.U.push_back(this->Places[node][0]);
  chains.Nodes.V.push_back(this->Places[node][1]);
}

void OverlayGraph::EndChain(Chains& chains, const SlabLoop& loop) const
{
  chains.Nodes.Offsets.push_back(static_cast<Index>(chains.Numbers.size()));
  chains.Nodes.Axis.push_back(2);
  chains.Nodes.Coordinate.push_back(loop.Upper ? 1.0 : 0.0);
}

std::vector<Index> OverlayGraph::LoopsAt(bool upper) const
{
  std::vector<Index> loops;
  for (std::size_t i = 0; i < this->Loops.size(); ++i)
  {
    if (this->Loops[i].Upper == upper)
    {
      loops.push_back(static_cast<Index>(i));
    }
  }
  return loops;
}

/// Lists the crossing of two segments, if they cross. Returns false if the segments touch without
/// crossing.
bool OverlayGraph::AddCrossing(const std::array<Index, 2>& lower, const std::array<Index, 2>& upper)
{
  const Point2& p = this->Places[lower[0]];
  const Point2& q = this->Places[lower[1]];
  const Point2& r = this->Places[upper[0]];
  const Point2& s = this->Places[upper[1]];
  const int from = SideOf(p, q, r);
  const int to = SideOf(p, q, s);
  if (from * to > 0)
  {
    return true;
  }
  const int across = SideOf(r, s, p) * SideOf(r, s, q);
  if (across > 0)
  {
    return true;
  }
  if (from * to == 0 || across == 0)
  {
    return false;
  }
  const Point2 a = q - p;
  const Point2 b = s - r;
  const Point2 c = r - p;
  const double area = Cross(a, b);
  // The place on the shorter segment, and what is closest to it on the longer one: so both new
  // vertices are there even if the segments are almost parallel.
  std::array<double, 2> share;
  Point2 place;
  if (Dot(a, a) < Dot(b, b))
  {
    share[0] = Cross(c, b) / area;
    place = p + share[0] * a;
    share[1] = Dot(place - r, b) / Dot(b, b);
  }
  else
  {
    share[1] = Cross(c, a) / area;
    place = r + share[1] * b;
    share[0] = Dot(place - p, a) / Dot(a, a);
  }
  this->Places.push_back(place);
  this->OnLevel.push_back(ConstrainedTriangulation::OnBothLevels);
  this->Crossings.push_back({ { lower[0], upper[0] }, share, { None, None }, to > 0 });
  return true;
}

bool OverlayGraph::FindCrossings()
{
  std::vector<Index> all(this->Loops.size());
  std::iota(all.begin(), all.end(), 0);
  bool valid = true;
  SegmentTree(this->Whole.Nodes, all)
    .VisitOverlaps(
      [&](SegmentTree::Segment s, SegmentTree::Segment t)
      {
        if (this->Loops[s.Contour].Upper != this->Loops[t.Contour].Upper)
        {
          if (this->Loops[s.Contour].Upper)
          {
            std::swap(s, t);
          }
          valid = this->AddCrossing(this->Whole.Ends(s), this->Whole.Ends(t)) && valid;
        }
      });
  return valid;
}

/// Puts the crossings between the vertices of the loops.
bool OverlayGraph::SplitLoops()
{
  std::vector<Index> offsets(this->Vertices + 1, 0);
  for (const Crossing& crossing : this->Crossings)
  {
    ++offsets[crossing.Segment[0] + 1];
    ++offsets[crossing.Segment[1] + 1];
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<Index> here(2 * this->Crossings.size());
  std::vector<Index> end = offsets;
  for (std::size_t i = 0; i < this->Crossings.size(); ++i)
  {
    for (const Index segment : this->Crossings[i].Segment)
    {
      here[end[segment]++] = this->Vertices + static_cast<Index>(i);
    }
  }
  Index first = 0;
  for (std::size_t loop = 0; loop < this->Loops.size(); ++loop)
  {
    const int level = this->Loops[loop].Upper;
    const Index count = static_cast<Index>(this->Loops[loop].Points.size());
    for (Index i = 0; i < count; ++i)
    {
      const Index vertex = first + i;
      this->AddNode(this->Parts, vertex);
      const auto share = [&](Index node) { return this->CrossingAt(node).Share[level]; };
      std::sort(here.begin() + offsets[vertex], here.begin() + end[vertex],
        [&](Index a, Index b) { return share(a) < share(b); });
      double last = 0.0;
      for (Index j = offsets[vertex]; j < end[vertex]; ++j)
      {
        const Index node = here[j];
        if (!(share(node) > last && share(node) < 1.0))
        {
          return false;
        }
        last = share(node);
        this->AddNode(this->Parts, node);
        this->CrossingAt(node).Corner[level] =
          this->Vertices + static_cast<Index>(this->Insertions.size());
        this->Insertions.push_back({ static_cast<Index>(loop), i, last });
      }
    }
    first += count;
    this->EndChain(this->Parts, this->Loops[loop]);
  }
  return true;
}

/// Whether two segments have no point in common but an end that is the same node.
bool OverlayGraph::AreApart(const std::array<Index, 2>& s, const std::array<Index, 2>& t) const
{
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      if (s[i] == t[j])
      {
        return s[1 - i] != t[1 - j] &&
          !AreOnOneRay(this->Places[s[i]], this->Places[s[1 - i]], this->Places[t[1 - j]]);
      }
    }
  }
  const Point2& a = this->Places[s[0]];
  const Point2& b = this->Places[s[1]];
  const Point2& c = this->Places[t[0]];
  const Point2& d = this->Places[t[1]];
  return SideOf(a, b, c) * SideOf(a, b, d) > 0 || SideOf(c, d, a) * SideOf(c, d, b) > 0;
}

/// Whether the contours pass each other at the rounded crossing as they did before.
bool OverlayGraph::IsProper(
  Index node, const std::vector<Index>& next, const std::vector<Index>& before) const
{
  const Index place = 2 * (node - this->Vertices);
  const Point2& here = this->Places[node];
  const Point2& from = this->Places[before[place]];
  const Point2& to = this->Places[next[place]];
  const bool isFromLeft = IsLeftOfPath(from, here, to, this->Places[before[place + 1]]);
  const bool isToLeft = IsLeftOfPath(from, here, to, this->Places[next[place + 1]]);
  return isFromLeft != isToLeft && isToLeft == this->CrossingAt(node).ToLeft;
}

/**
 * Whether the rounded crossings left a plane graph, exactly: with this the rest is combinatorial
 * but for predicates that are exact.
 */
bool OverlayGraph::IsSimple() const
{
  std::vector<Index> chains(this->Loops.size());
  std::iota(chains.begin(), chains.end(), 0);
  bool simple = true;
  SegmentTree(this->Parts.Nodes, chains)
    .VisitOverlaps([&](const SegmentTree::Segment& s, const SegmentTree::Segment& t)
      { simple = simple && this->AreApart(this->Parts.Ends(s), this->Parts.Ends(t)); });
  std::vector<Index> next(2 * this->Crossings.size());
  std::vector<Index> before(2 * this->Crossings.size());
  for (const Index chain : chains)
  {
    const int level = this->Loops[chain].Upper;
    for (Index i = this->Parts.Nodes.Offsets[chain]; i < this->Parts.Nodes.Offsets[chain + 1]; ++i)
    {
      const Index j = this->Parts.After(chain, i);
      const Index a = this->Parts.Numbers[i];
      const Index b = this->Parts.Numbers[j];
      const Index c = this->Parts.Numbers[this->Parts.After(chain, j)];
      simple = simple && this->Places[a] != this->Places[b] &&
        !AreOnOneRay(this->Places[b], this->Places[a], this->Places[c]);
      if (this->IsCrossing(b))
      {
        before[2 * (b - this->Vertices) + level] = a;
        next[2 * (b - this->Vertices) + level] = c;
      }
    }
  }
  for (std::size_t i = 0; i < this->Crossings.size() && simple; ++i)
  {
    simple = this->IsProper(this->Vertices + static_cast<Index>(i), next, before);
  }
  return simple;
}

/**
 * Adds a chain to the borders of what is inside below only, and above only. Each part of it lies
 * inside or outside the other slice's contours and so borders one of the two.
 */
bool OverlayGraph::AddChain(
  Index chain, const SegmentTree& others, std::array<PlaneRegion, 2>& regions) const
{
  const bool upper = this->Loops[chain].Upper;
  const Index first = this->Parts.Nodes.Offsets[chain];
  const Index count = this->Parts.Nodes.Size(chain);
  const Index* nodes = this->Parts.Numbers.data() + first;
  const auto isInsideBehind = [&](Index node) { return this->CrossingAt(node).ToLeft == upper; };
  Index start = 0;
  while (start < count && !this->IsCrossing(nodes[start]))
  {
    ++start;
  }
  bool inside = false;
  if (start == count)
  {
    start = 0;
    const Point2& place = this->Places[nodes[0]];
    inside = others.CountAbove(place[0], place[1], None) % 2 != 0;
  }
  else
  {
    inside = !isInsideBehind(nodes[start]);
  }
  for (Index i = 0; i < count; ++i)
  {
    const Index from = nodes[(start + i) % count];
    const Index to = nodes[(start + i + 1) % count];
    if (this->IsCrossing(from))
    {
      if (isInsideBehind(from) == inside)
      {
        return false;
      }
      inside = !inside;
    }
    // What is inside of one slice only lies on the left of its contours, and on the right of those
    // of the other slice.
    PlaneRegion& region = regions[upper != inside];
    if (!(inside ? region.Add(to, from, upper) : region.Add(from, to, upper)))
    {
      return false;
    }
  }
  return true;
}

bool OverlayGraph::Build()
{
  return this->FindCrossings() && this->SplitLoops() && this->IsSimple();
}

bool OverlayGraph::FindRegions(std::array<PlaneRegion, 2>& regions) const
{
  regions.fill(PlaneRegion(this->Places.size()));
  const SegmentTree lower(this->Whole.Nodes, this->LoopsAt(false));
  const SegmentTree upper(this->Whole.Nodes, this->LoopsAt(true));
  for (std::size_t i = 0; i < this->Loops.size(); ++i)
  {
    if (!this->AddChain(static_cast<Index>(i), this->Loops[i].Upper ? lower : upper, regions))
    {
      return false;
    }
  }
  return true;
}
}
