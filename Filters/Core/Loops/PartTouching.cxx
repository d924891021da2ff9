// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/PartTouching.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace orthoslices
{
namespace
{
/// How far from the node a corner is cut off at most, as a share of the extent of the smallest loop
/// there: too little to be seen, and far more than rounding.
constexpr double MaxCut = 1.0 / 256.0;

/// A loop on its way through a node.
struct Passing
{
  Index Region;
  Index Loop, Place; ///< of the half-edge that ends in the node
  Index From, To;    ///< the half-edges that leave the node back and forth along the loop
  /// The side on which the loop turns by less than 180 degrees, as a range of the half-edges that
  /// leave the node, counter-clockwise: from after Begin to before End.
  std::size_t Begin, End;
  bool IsStraight;
  Index Depth; ///< in how many such ranges of others it lies

  /// How many steps from the node its corner is cut off; 0: it stays.
  Index Cut() const { return this->IsStraight ? 0 : this->Depth; }
  /// Whether a half-edge that leaves the node, by its order there, is in the range.
  bool Contains(std::size_t at) const
  {
    return this->Begin < this->End ? this->Begin < at && at < this->End
                                   : this->Begin < at || at < this->End;
  }
};

/// Of half-edges that leave a node: how many steps from there corners are cut off on them.
using StepsOfHalfEdges = std::map<Index, std::set<Index>>;

StepsOfHalfEdges ListCuts(const std::vector<Passing>& passings)
{
  StepsOfHalfEdges cuts;
  for (const Passing& passing : passings)
  {
    if (passing.Cut() > 0)
    {
      cuts[passing.From].insert(passing.Cut());
      cuts[passing.To].insert(passing.Cut());
    }
  }
  return cuts;
}

/// Parts the loops of all regions.
class LoopParter
{
public:
  LoopParter(
    const PlaneWalks& walks, const PlaneFaces& faces, std::vector<std::vector<TracedLoop>>& regions)
    : Walks(walks)
    , Graph(faces)
  {
    for (std::size_t region = 0; region < regions.size(); ++region)
    {
      for (TracedLoop& loop : regions[region])
      {
        this->Loops.push_back(&loop);
        this->RegionOf.push_back(static_cast<Index>(region));
        this->Instead.emplace_back(loop.HalfEdges.size());
      }
    }
  }

  void Run();

private:
  const Point2& At(Index node) const { return this->Walks.Nodes[node]; }
  std::size_t OrderOf(Index node, Index halfEdge) const;
  Passing Describe(Index loop, Index place) const;
  std::vector<std::uint8_t> FindTouched() const;
  void FindDepths(std::vector<Passing>& passings) const;
  void ShareDepths(std::vector<Passing>& passings) const;
  double RoomAt(Index node, const std::vector<Passing>& passings) const;
  double ExtentOf(Index loop) const;
  void PartAt(Index node, std::vector<Passing>& passings);
  void Replace();

  const PlaneWalks& Walks;
  const PlaneFaces& Graph;
  std::vector<TracedLoop*> Loops; ///< of all regions, one after another
  std::vector<Index> RegionOf;    ///< of each loop
  /// Of each loop and each of its places: the points instead of the node, if there are others.
  std::vector<std::vector<std::vector<Point2>>> Instead;
};

std::size_t LoopParter::OrderOf(Index node, Index halfEdge) const
{
  const std::vector<Index>& leaving = this->Graph.Leaving(node);
  return static_cast<std::size_t>(
    std::find(leaving.begin(), leaving.end(), halfEdge) - leaving.begin());
}

Passing LoopParter::Describe(Index loop, Index place) const
{
  const std::vector<Index>& halfEdges = this->Loops[loop]->HalfEdges;
  const Index in = halfEdges[place];
  const Index out = halfEdges[(place + 1) % halfEdges.size()];
  const Index node = this->Graph.Head(in);
  Passing passing{ this->RegionOf[loop], loop, place, PlaneFaces::Twin(in), out, 0, 0, false, 0 };
  const int turn =
    SideOf(this->At(this->Graph.Tail(in)), this->At(node), this->At(this->Graph.Head(out)));
  const std::size_t from = this->OrderOf(node, passing.From);
  const std::size_t to = this->OrderOf(node, out);
  passing.IsStraight = turn == 0;
  // The left side is the one from the half-edge forth, counter-clockwise, to the one back.
  passing.Begin = turn >= 0 ? to : from;
  passing.End = turn >= 0 ? from : to;
  return passing;
}

/// In each region, outer ones have less depth. One that is around all others stays in the node:
/// depth 0.
void LoopParter::FindDepths(std::vector<Passing>& passings) const
{
  std::map<Index, Index> outermost; // how many there are, of each region
  for (Passing& inner : passings)
  {
    for (const Passing& outer : passings)
    {
      const bool isOther = &inner != &outer && inner.Region == outer.Region;
      const std::size_t at = this->OrderOf(this->Graph.Tail(inner.To), inner.To);
      inner.Depth += isOther && outer.Contains(at) ? 1 : 0;
    }
    outermost[inner.Region] += inner.Depth == 0 ? 1 : 0;
  }
  for (Passing& passing : passings)
  {
    passing.Depth += outermost[passing.Region] > 1 ? 1 : 0;
  }
}

/// What lies within a corner of another region that is cut off, is cut off as far from the node.
void LoopParter::ShareDepths(std::vector<Passing>& passings) const
{
  const std::vector<Passing> own = passings;
  for (Passing& inner : passings)
  {
    for (const Passing& outer : own)
    {
      const auto isEnd = [&](std::size_t at) { return at == outer.Begin || at == outer.End; };
      if (inner.Region != outer.Region && (isEnd(inner.Begin) || outer.Contains(inner.Begin)) &&
        (isEnd(inner.End) || outer.Contains(inner.End)))
      {
        inner.Depth = std::max(inner.Depth, outer.Cut());
      }
    }
  }
}

double LoopParter::ExtentOf(Index loop) const
{
  double extent = 0.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto less = [axis](const Point2& a, const Point2& b) { return a[axis] < b[axis]; };
    const std::vector<Point2>& points = this->Loops[loop]->Points;
    const auto range = std::minmax_element(points.begin(), points.end(), less);
    extent = std::max(extent, (*range.second)[axis] - (*range.first)[axis]);
  }
  return extent;
}

double DistanceToSegment(const Point2& x, const Point2& p, const Point2& q)
{
  const double square = SquaredDistance(p, q);
  const double share = square > 0.0 ? Dot(x - p, q - p) / square : 0.0;
  return Distance(x, Between(p, q, std::max(0.0, std::min(1.0, share))));
}

/// The distance from a node to the nearest border that does not end there; half the length of those
/// that do, as corners may be cut off at both of their ends.
double LoopParter::RoomAt(Index node, const std::vector<Passing>& passings) const
{
  double room = std::numeric_limits<double>::infinity();
  for (const TracedLoop* loop : this->Loops)
  {
    for (const Index halfEdge : loop->HalfEdges)
    {
      const Index from = this->Graph.Tail(halfEdge);
      const Index to = this->Graph.Head(halfEdge);
      const double distance = from == node || to == node
        ? 0.5 * Distance(this->At(from), this->At(to))
        : 0.5 * DistanceToSegment(this->At(node), this->At(from), this->At(to));
      room = std::min(room, distance);
    }
  }
  for (const Passing& passing : passings)
  {
    room = std::min(room, 4.0 * MaxCut * this->ExtentOf(passing.Loop));
  }
  return room;
}

/// Each loop gets the points of all corners that are cut off on its half-edges.
void LoopParter::PartAt(Index node, std::vector<Passing>& passings)
{
  this->FindDepths(passings);
  this->ShareDepths(passings);
  Index deepest = 1;
  for (const Passing& passing : passings)
  {
    deepest = std::max(deepest, passing.Depth);
  }
  StepsOfHalfEdges cuts = ListCuts(passings);
  const double step = 0.25 * this->RoomAt(node, passings) / deepest;
  for (const Passing& passing : passings)
  {
    const auto pointsOn = [&](Index halfEdge)
    {
      const Point2& end = this->At(this->Graph.Head(halfEdge));
      const std::set<Index>& of = cuts[halfEdge];
      std::vector<Point2> points;
      std::transform(of.lower_bound(passing.Cut()), of.end(), std::back_inserter(points),
        [&](Index cut)
        { return Between(this->At(node), end, step * cut / Distance(this->At(node), end)); });
      return points;
    };
    std::vector<Point2>& instead = this->Instead[passing.Loop][passing.Place];
    instead = pointsOn(passing.From);
    std::reverse(instead.begin(), instead.end());
    if (passing.Cut() == 0)
    {
      instead.push_back(this->At(node));
    }
    const std::vector<Point2> forth = pointsOn(passing.To);
    instead.insert(instead.end(), forth.begin(), forth.end());
  }
}

/// 1 for the nodes that a region passes more than once.
std::vector<std::uint8_t> LoopParter::FindTouched() const
{
  std::vector<std::uint8_t> isTouched(this->Walks.Nodes.size(), 0);
  std::vector<Index> last(this->Walks.Nodes.size(), -1); // region that passes the node
  for (std::size_t loop = 0; loop < this->Loops.size(); ++loop)
  {
    for (const Index halfEdge : this->Loops[loop]->HalfEdges)
    {
      const Index node = this->Graph.Head(halfEdge);
      isTouched[node] |= last[node] == this->RegionOf[loop] ? 1 : 0;
      last[node] = this->RegionOf[loop];
    }
  }
  return isTouched;
}

void LoopParter::Run()
{
  const std::vector<std::uint8_t> isTouched = this->FindTouched();
  std::map<Index, std::vector<Passing>> passings; // of each node
  for (std::size_t loop = 0; loop < this->Loops.size(); ++loop)
  {
    const std::vector<Index>& halfEdges = this->Loops[loop]->HalfEdges;
    for (std::size_t i = 0; i < halfEdges.size(); ++i)
    {
      const Index node = this->Graph.Head(halfEdges[i]);
      if (isTouched[node] != 0)
      {
        passings[node].push_back(this->Describe(static_cast<Index>(loop), static_cast<Index>(i)));
      }
    }
  }
  for (auto& [node, of] : passings)
  {
    this->PartAt(node, of);
  }
  if (!passings.empty())
  {
    this->Replace();
  }
}

/// Puts the points in that there are instead of nodes.
void LoopParter::Replace()
{
  for (std::size_t loop = 0; loop < this->Loops.size(); ++loop)
  {
    std::vector<Point2> points;
    for (std::size_t i = 0; i < this->Loops[loop]->Points.size(); ++i)
    {
      const std::vector<Point2>& instead = this->Instead[loop][i];
      points.insert(points.end(), instead.begin(), instead.end());
      if (instead.empty())
      {
        points.push_back(this->Loops[loop]->Points[i]);
      }
    }
    this->Loops[loop]->Points = std::move(points);
  }
}
}

void PartTouching(
  const PlaneWalks& walks, const PlaneFaces& faces, std::vector<std::vector<TracedLoop>>& regions)
{
  LoopParter(walks, faces, regions).Run();
}
}
