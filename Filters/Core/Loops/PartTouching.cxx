// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/PartTouching.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <limits>

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
  Index Loop, Place; ///< of the half-edge that ends in the node
  Index From, To;    ///< the half-edges that leave the node back and forth along the loop
  /// The side on which the loop turns by less than 180 degrees, as a range of the half-edges that
  /// leave the node, counter-clockwise: from after Begin to before End.
  std::size_t Begin, End;
  bool IsStraight;
  Index Depth; ///< in how many such ranges of others it lies
};

class LoopParter
{
public:
  LoopParter(const PlaneWalks& walks, const PlaneFaces& faces, std::vector<TracedLoop>& loops)
    : Walks(walks)
    , Graph(faces)
    , Loops(loops)
  {
  }

  void Run();

private:
  const Point2& At(Index node) const { return this->Walks.Nodes[node]; }
  std::size_t OrderOf(Index node, Index halfEdge) const;
  Passing Describe(Index loop, Index place) const;
  void FindDepths(std::vector<Passing>& passings) const;
  double RoomAt(Index node, const std::vector<Passing>& passings) const;
  double ExtentOf(Index loop) const;
  void PartAt(Index node, std::vector<Passing>& passings);

  const PlaneWalks& Walks;
  const PlaneFaces& Graph;
  std::vector<TracedLoop>& Loops;
  /// Of each loop and each of its places: the points instead of the node, if corners are cut off.
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
  const std::vector<Index>& halfEdges = this->Loops[loop].HalfEdges;
  const Index in = halfEdges[place];
  const Index out = halfEdges[(place + 1) % halfEdges.size()];
  const Index node = this->Graph.Head(in);
  Passing passing{ loop, place, PlaneFaces::Twin(in), out, 0, 0, false, 0 };
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

/// Outer ones have less depth. One that is around all others stays in the node: depth 0.
void LoopParter::FindDepths(std::vector<Passing>& passings) const
{
  const auto isWithin = [this](const Passing& inner, const Passing& outer)
  {
    const std::size_t at = this->OrderOf(this->Graph.Tail(inner.To), inner.To);
    return outer.Begin < outer.End ? outer.Begin < at && at < outer.End
                                   : outer.Begin < at || at < outer.End;
  };
  Index outermost = 0;
  for (Passing& inner : passings)
  {
    for (const Passing& outer : passings)
    {
      inner.Depth += &inner != &outer && isWithin(inner, outer) ? 1 : 0;
    }
    outermost += inner.Depth == 0 ? 1 : 0;
  }
  for (Passing& passing : passings)
  {
    passing.Depth += outermost > 1 ? 1 : 0;
  }
}

double LoopParter::ExtentOf(Index loop) const
{
  double extent = 0.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto less = [axis](const Point2& a, const Point2& b) { return a[axis] < b[axis]; };
    const std::vector<Point2>& points = this->Loops[loop].Points;
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
  for (const TracedLoop& loop : this->Loops)
  {
    for (const Index halfEdge : loop.HalfEdges)
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

void LoopParter::PartAt(Index node, std::vector<Passing>& passings)
{
  this->FindDepths(passings);
  Index deepest = 1;
  for (const Passing& passing : passings)
  {
    deepest = std::max(deepest, passing.Depth);
  }
  const double step = 0.25 * this->RoomAt(node, passings) / deepest;
  for (const Passing& passing : passings)
  {
    if (passing.Depth == 0 || passing.IsStraight)
    {
      continue;
    }
    std::vector<Point2>& instead = this->Instead[passing.Loop][passing.Place];
    for (const Index halfEdge : { passing.From, passing.To })
    {
      const Point2& end = this->At(this->Graph.Head(halfEdge));
      instead.push_back(
        Between(this->At(node), end, step * passing.Depth / Distance(this->At(node), end)));
    }
  }
}

void LoopParter::Run()
{
  std::vector<std::vector<Passing>> passings(this->Walks.Nodes.size());
  std::vector<std::uint8_t> visits(this->Walks.Nodes.size(), 0);
  for (const TracedLoop& loop : this->Loops)
  {
    this->Instead.emplace_back(loop.HalfEdges.size());
    for (const Index halfEdge : loop.HalfEdges)
    {
      std::uint8_t& count = visits[this->Graph.Head(halfEdge)];
      count = count == 0 ? 1 : 2;
    }
  }
  for (std::size_t loop = 0; loop < this->Loops.size(); ++loop)
  {
    for (std::size_t i = 0; i < this->Loops[loop].HalfEdges.size(); ++i)
    {
      const Index node = this->Graph.Head(this->Loops[loop].HalfEdges[i]);
      if (visits[node] > 1)
      {
        passings[node].push_back(this->Describe(static_cast<Index>(loop), static_cast<Index>(i)));
      }
    }
  }
  for (std::size_t node = 0; node < passings.size(); ++node)
  {
    if (!passings[node].empty())
    {
      this->PartAt(static_cast<Index>(node), passings[node]);
    }
  }
  for (std::size_t loop = 0; loop < this->Loops.size(); ++loop)
  {
    std::vector<Point2> points;
    for (std::size_t i = 0; i < this->Loops[loop].Points.size(); ++i)
    {
      const std::vector<Point2>& instead = this->Instead[loop][i];
      points.insert(points.end(), instead.begin(), instead.end());
      if (instead.empty())
      {
        points.push_back(this->Loops[loop].Points[i]);
      }
    }
    this->Loops[loop].Points = std::move(points);
  }
}
}

void PartTouching(const PlaneWalks& walks, const PlaneFaces& faces, std::vector<TracedLoop>& loops)
{
  LoopParter(walks, faces, loops).Run();
}
}
