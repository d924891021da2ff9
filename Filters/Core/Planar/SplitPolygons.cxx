// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/SplitPolygons.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"
#include "Core/Planar/NodeFinder.h"
#include "Core/Planar/SegmentTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace orthoslices
{
namespace
{
constexpr Index None = NodeFinder::None;
/// Rounds after which the resolution becomes sixteen times coarser. Two or three do nearly always.
constexpr int RoundsOfOneResolution = 12;
constexpr int MaxCoarsenings = 6;

/// The greatest extent, and the largest coordinate, of points.
std::array<double, 2> MeasurePoints(const std::vector<Point2>& points)
{
  double extent = 0.0, largest = 0.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Point2& p : points)
    {
      low = std::min(low, p[axis]);
      high = std::max(high, p[axis]);
    }
    extent = std::max(extent, high - low);
    largest = std::max({ largest, std::abs(low), std::abs(high) });
  }
  return { extent, largest };
}

class PolygonSplitter
{
public:
  explicit PolygonSplitter(PlaneWalks& walks)
    : Set(walks)
  {
  }

  void Read(const std::vector<std::vector<Point2>>& polygons);
  bool Run();

private:
  struct Side
  {
    Index Walk, Place; ///< of the node that it starts from
    Index From, To;
  };
  struct Split
  {
    Index Walk, Place, Node;
    double Along; ///< the square of its distance from the side's start
  };

  Side SideAt(Index walk, Index place) const;
  bool FindMeetings();
  void Compare(const Side& a, const Side& b);
  bool PassesEndsOf(const Side& a, const Side& b);
  bool Passes(const Side& side, Index node) const;
  void AddCrossing(const Side& a, const Side& b);
  Index NodeAtCrossing(const Side& a, const Side& b, const Point2& place);
  void AddSplit(const Side& side, Index node);
  void SplitWalks();

  PlaneWalks& Set;
  double Resolution = 0.0;
  NodeFinder* Finder = nullptr;
  std::vector<Split> Splits;
};

void PolygonSplitter::Read(const std::vector<std::vector<Point2>>& polygons)
{
  std::vector<Point2> all;
  for (const std::vector<Point2>& polygon : polygons)
  {
    all.insert(all.end(), polygon.begin(), polygon.end());
  }
  const std::array<double, 2> size = MeasurePoints(all);
  this->Resolution =
    std::max(std::ldexp(size[0], -40), 8.0 * std::numeric_limits<double>::epsilon() * size[1]);
  // Numbers the places in the order of their first corner.
  std::vector<Index> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](Index a, Index b) { return all[a] != all[b] ? all[a] < all[b] : a < b; });
  std::vector<Index> first(all.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isSame = i > 0 && all[order[i]] == all[order[i - 1]];
    first[order[i]] = isSame ? first[order[i - 1]] : order[i];
  }
  std::vector<Index> number(all.size(), None);
  std::size_t next = 0;
  for (const std::vector<Point2>& polygon : polygons)
  {
    std::vector<Index> walk;
    for (const Point2& corner : polygon)
    {
      Index& node = number[first[next++]];
      if (node == None)
      {
        node = static_cast<Index>(this->Set.Nodes.size());
        this->Set.Nodes.push_back(corner);
      }
      if (walk.empty() || walk.back() != node)
      {
        walk.push_back(node);
      }
    }
    while (walk.size() > 1 && walk.back() == walk.front())
    {
      walk.pop_back();
    }
    this->Set.Walks.push_back(std::move(walk));
  }
}

PolygonSplitter::Side PolygonSplitter::SideAt(Index walk, Index place) const
{
  const std::vector<Index>& nodes = this->Set.Walks[walk];
  return { walk, place, nodes[place], nodes[(place + 1) % nodes.size()] };
}

/// Lists where sides have to be split. Returns whether there is anything.
bool PolygonSplitter::FindMeetings()
{
  Contours chains;
  std::vector<Index> members;
  for (const std::vector<Index>& walk : this->Set.Walks)
  {
    for (const Index node : walk.size() > 1 ? walk : std::vector<Index>())
    {
      chains.U.push_back(this->Set.Nodes[node][0]);
      chains.V.push_back(this->Set.Nodes[node][1]);
    }
    chains.Offsets.push_back(static_cast<Index>(chains.U.size()));
    members.push_back(static_cast<Index>(members.size()));
  }
  this->Splits.clear();
  const auto sideOf = [&](const SegmentTree::Segment& segment)
  { return this->SideAt(segment.Contour, segment.Vertex - chains.Offsets[segment.Contour]); };
  SegmentTree(chains, members)
    .VisitOverlaps([&](const SegmentTree::Segment& s, const SegmentTree::Segment& t)
      { this->Compare(sideOf(s), sideOf(t)); });
  // Neighbours meet where a walk turns back along itself.
  for (const Index walk : members)
  {
    const Index count = static_cast<Index>(this->Set.Walks[walk].size());
    for (Index i = 0; i < count && count > 2; ++i)
    {
      this->PassesEndsOf(this->SideAt(walk, i), this->SideAt(walk, (i + 1) % count));
    }
  }
  return !this->Splits.empty();
}

/// Whether a node lies on a side, or closer to it than half the resolution, away from its ends.
bool PolygonSplitter::Passes(const Side& side, Index node) const
{
  if (node == side.From || node == side.To)
  {
    return false;
  }
  const Point2& p = this->Set.Nodes[side.From];
  const Point2& q = this->Set.Nodes[side.To];
  const Point2& x = this->Set.Nodes[node];
  if (SideOf(p, q, x) == 0)
  {
    return std::min(p[0], q[0]) <= x[0] && x[0] <= std::max(p[0], q[0]) &&
      std::min(p[1], q[1]) <= x[1] && x[1] <= std::max(p[1], q[1]);
  }
  const Point2 along = q - p;
  const Point2 to = x - p;
  const double length = Length(along);
  const double share = Dot(along, to);
  return share > 0.0 && share < length * length &&
    std::abs(Cross(along, to)) <= 0.5 * this->Resolution * length &&
    Length(to) > this->Resolution && Distance(x, q) > this->Resolution;
}

/// Splits sides at ends of the other one that they pass. Returns whether there are any.
bool PolygonSplitter::PassesEndsOf(const Side& a, const Side& b)
{
  bool any = false;
  const auto test = [&](const Side& side, Index node)
  {
    if (this->Passes(side, node))
    {
      this->AddSplit(side, node);
      any = true;
    }
  };
  test(a, b.From);
  test(a, b.To);
  test(b, a.From);
  test(b, a.To);
  return any;
}

void PolygonSplitter::Compare(const Side& a, const Side& b)
{
  if (this->PassesEndsOf(a, b) || a.From == b.From || a.From == b.To || a.To == b.From ||
    a.To == b.To)
  {
    return;
  }
  const Point2& p = this->Set.Nodes[a.From];
  const Point2& q = this->Set.Nodes[a.To];
  const Point2& r = this->Set.Nodes[b.From];
  const Point2& s = this->Set.Nodes[b.To];
  if (SideOf(p, q, r) * SideOf(p, q, s) < 0 && SideOf(r, s, p) * SideOf(r, s, q) < 0)
  {
    this->AddCrossing(a, b);
  }
}

void PolygonSplitter::AddCrossing(const Side& a, const Side& b)
{
  const Point2& p = this->Set.Nodes[a.From];
  const Point2& q = this->Set.Nodes[a.To];
  const Point2& r = this->Set.Nodes[b.From];
  const Point2& s = this->Set.Nodes[b.To];
  // Between the ends, whatever rounding does.
  const double from = std::abs(Cross(s - r, p - r));
  const double to = std::abs(Cross(s - r, q - r));
  const double share = from + to > 0.0 ? from / (from + to) : 0.5;
  const Index node = this->NodeAtCrossing(a, b, Between(p, q, share));
  this->AddSplit(a, node);
  this->AddSplit(b, node);
}

Index PolygonSplitter::NodeAtCrossing(const Side& a, const Side& b, const Point2& place)
{
  Index nearest = None;
  double least = 2.0 * this->Resolution;
  for (const Index end : { a.From, a.To, b.From, b.To })
  {
    const double distance = Distance(place, this->Set.Nodes[end]);
    if (distance <= least)
    {
      nearest = end;
      least = distance;
    }
  }
  nearest = nearest == None ? this->Finder->Nearest(place, this->Resolution) : nearest;
  if (nearest == None)
  {
    nearest = static_cast<Index>(this->Set.Nodes.size());
    this->Set.Nodes.push_back(place);
    this->Finder->Add(nearest);
  }
  return nearest;
}

void PolygonSplitter::AddSplit(const Side& side, Index node)
{
  if (node != side.From && node != side.To)
  {
    this->Splits.push_back({ side.Walk, side.Place, node,
      SquaredDistance(this->Set.Nodes[side.From], this->Set.Nodes[node]) });
  }
}

void PolygonSplitter::SplitWalks()
{
  std::sort(this->Splits.begin(), this->Splits.end(),
    [](const Split& a, const Split& b)
    {
      return a.Walk != b.Walk ? a.Walk < b.Walk
        : a.Place != b.Place  ? a.Place < b.Place
        : a.Along != b.Along  ? a.Along < b.Along
                              : a.Node < b.Node;
    });
  auto split = this->Splits.begin();
  while (split != this->Splits.end())
  {
    const Index number = split->Walk;
    std::vector<Index>& walk = this->Set.Walks[number];
    std::vector<Index> longer;
    for (std::size_t place = 0; place < walk.size(); ++place)
    {
      longer.push_back(walk[place]);
      for (; split != this->Splits.end() && split->Walk == number &&
           split->Place == static_cast<Index>(place);
           ++split)
      {
        if (split->Node != longer.back())
        {
          longer.push_back(split->Node);
        }
      }
    }
    walk = std::move(longer);
  }
}

bool PolygonSplitter::Run()
{
  for (int coarsening = 0; coarsening <= MaxCoarsenings; ++coarsening)
  {
    NodeFinder finder(this->Set.Nodes, this->Resolution);
    this->Finder = &finder;
    for (int round = 0; round < RoundsOfOneResolution; ++round)
    {
      if (!this->FindMeetings())
      {
        return true;
      }
      this->SplitWalks();
    }
    this->Resolution *= 16.0;
  }
  return false;
}
}

bool SplitPolygons(const std::vector<std::vector<Point2>>& polygons, PlaneWalks& walks)
{
  walks = PlaneWalks();
  PolygonSplitter splitter(walks);
  splitter.Read(polygons);
  return splitter.Run();
}
}
