// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/OverlaySlab.h"

#include "Core/Planar/SegmentTree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
constexpr Index None = -1;

using Triangle = std::array<Index, 3>;

double Cross(const Point2& a, const Point2& b) { return a[0] * b[1] - a[1] * b[0]; }

Point2 Minus(const Point2& a, const Point2& b) { return { a[0] - b[0], a[1] - b[1] }; }

/// Whether q and r lie on one ray from p.
bool OnOneRay(const Point2& p, const Point2& q, const Point2& r)
{
  return SideOf(p, q, r) == 0 &&
    ((q[0] > p[0] && r[0] > p[0]) || (q[0] < p[0] && r[0] < p[0]) || (q[1] > p[1] && r[1] > p[1]) ||
      (q[1] < p[1] && r[1] < p[1]));
}

/// Whether r lies on the left of the path from a over b to c, near b.
bool IsLeftOfPath(const Point2& a, const Point2& b, const Point2& c, const Point2& r)
{
  const bool first = SideOf(a, b, r) > 0;
  const bool second = SideOf(b, c, r) > 0;
  return SideOf(a, b, c) > 0 ? first && second : first || second;
}

/// A part of the plane, on the left of disjoint simple rings through the nodes.
struct Region
{
  std::vector<Index> Next, Previous; ///< of each node: on its ring; None if it is on no ring
  std::vector<std::int8_t> Level;    ///< of each node: slice of the contour from it to the next

  explicit Region(std::size_t nodes)
    : Next(nodes, None)
    , Previous(nodes, None)
    , Level(nodes, 0)
  {
  }

  bool Add(Index from, Index to, int level)
  {
    const bool isFree = this->Next[from] == None && this->Previous[to] == None;
    this->Next[from] = to;
    this->Previous[to] = from;
    this->Level[from] = static_cast<std::int8_t>(level);
    return isFree;
  }
};

/// The triangles of a region and, by their places here, their neighbours; None behind its border.
struct RegionTriangles
{
  std::vector<Triangle> Corners;
  std::vector<Triangle> Neighbors; ///< behind the edge from corner i to i + 1
};

/**
 * Constrained Delaunay triangulation of the nodes: it joins what lies opposite each other. Points
 * come one after another, edges are swapped until the circles are empty (C. L. Lawson, "Software
 * for C1 Surface Interpolation", 1977) and the borders are in (S. W. Sloan, "A Fast Algorithm for
 * Generating Constrained Delaunay Triangulations", 1993). The sides of points are exact, so
 * that rounding may at most leave an edge that is not the best one.
 */
class Triangulation
{
public:
  /// `levels` of the nodes, 2 for a node that is on both.
  Triangulation(const std::vector<Point2>& places, const std::vector<std::int8_t>& levels,
    const std::array<Region, 2>& regions);

  /// `order` has all nodes, along the loops; returns false if the regions have no proper border.
  bool Run(const std::vector<Index>& order);

  std::array<RegionTriangles, 2> GetRegions() const;

private:
  /// The edge from corner Corner of a triangle to the next.
  struct Edge
  {
    Index Triangle;
    int Corner;
  };

  bool IsBorder(Index a, Index b) const;
  bool IsFlat(Index a, Index b) const
  {
    return this->Levels[a] == this->Levels[b] && this->Levels[a] != 2;
  }
  int Side(Index a, Index b, Index c) const
  {
    return SideOf(this->Places[a], this->Places[b], this->Places[c]);
  }
  bool IsBetter(Index a, Index b, Index c, Index d) const;
  void Set(Index triangle, const Triangle& corners, const Triangle& neighbors);
  void Replace(Index triangle, Index from, Index to);
  int CornerOf(Index triangle, Index node) const;
  Edge BackOf(const Edge& edge) const;
  Index ApexOf(const Edge& edge) const
  {
    return this->Corners[edge.Triangle][(edge.Corner + 2) % 3];
  }
  bool CanSwap(const Edge& edge) const;
  void Swap(const Edge& edge);
  void Improve(bool withBorders);
  Index Find(Index node, Index near) const;
  bool AddNode(Index node, Index near);
  bool AddNodes(const std::vector<Index>& order);
  bool FindAround(Index a, Index b, Edge& crossed) const;
  bool FindEdge(Index a, Index b, Edge& found) const;
  bool AddBorder(Index a, Index b);
  bool FillRegions();

  std::vector<Point2> Places; ///< three of a triangle around all are added
  std::vector<std::int8_t> Levels;
  const std::array<Region, 2>& Regions;
  const Index Nodes;
  std::vector<Triangle> Corners, Neighbors;
  std::vector<Index> Start; ///< of each node: one of its triangles
  std::vector<std::int8_t> RegionOf;
  std::vector<Edge> Doubtful;
};

Triangulation::Triangulation(const std::vector<Point2>& places,
  const std::vector<std::int8_t>& levels, const std::array<Region, 2>& regions)
  : Places(places)
  , Levels(levels)
  , Regions(regions)
  , Nodes(static_cast<Index>(places.size()))
  , Start(places.size() + 3, None)
{
  Point2 low = places.front();
  Point2 high = low;
  for (const Point2& p : places)
  {
    low = { std::min(low[0], p[0]), std::min(low[1], p[1]) };
    high = { std::max(high[0], p[0]), std::max(high[1], p[1]) };
  }
  const double size = 100.0 * std::max(high[0] - low[0], high[1] - low[1]);
  this->Places.push_back({ low[0] - size, low[1] - size });
  this->Places.push_back({ low[0] + 2.0 * size, low[1] - size });
  this->Places.push_back({ low[0], low[1] + 2.0 * size });
  this->Levels.insert(this->Levels.end(), 3, 2);
  this->Corners.emplace_back();
  this->Neighbors.emplace_back();
  this->Set(0, { this->Nodes, this->Nodes + 1, this->Nodes + 2 }, { None, None, None });
}

bool Triangulation::IsBorder(Index a, Index b) const
{
  return a < this->Nodes && b < this->Nodes &&
    std::any_of(this->Regions.begin(), this->Regions.end(),
      [&](const Region& region) { return region.Next[a] == b || region.Next[b] == a; });
}

/// Whether cd is better than ab, the edge between triangles abc and bad. Rounding does no harm.
bool Triangulation::IsBetter(Index a, Index b, Index c, Index d) const
{
  const Point2& o = this->Places[d];
  const Point2 p = Minus(this->Places[a], o);
  const Point2 q = Minus(this->Places[b], o);
  const Point2 r = Minus(this->Places[c], o);
  const double pp = p[0] * p[0] + p[1] * p[1];
  const double qq = q[0] * q[0] + q[1] * q[1];
  const double rr = r[0] * r[0] + r[1] * r[1];
  const double inside = pp * Cross(q, r) + qq * Cross(r, p) + rr * Cross(p, q);
  const double doubt = 1e-11 *
    (pp * (std::abs(q[0] * r[1]) + std::abs(q[1] * r[0])) +
      qq * (std::abs(r[0] * p[1]) + std::abs(r[1] * p[0])) +
      rr * (std::abs(p[0] * q[1]) + std::abs(p[1] * q[0])));
  return inside > doubt || (inside >= -doubt && this->IsFlat(a, b) && !this->IsFlat(c, d));
}

void Triangulation::Set(Index triangle, const Triangle& corners, const Triangle& neighbors)
{
  this->Corners[triangle] = corners;
  this->Neighbors[triangle] = neighbors;
  for (const Index node : corners)
  {
    this->Start[node] = triangle;
  }
}

void Triangulation::Replace(Index triangle, Index from, Index to)
{
  if (triangle != None)
  {
    Triangle& neighbors = this->Neighbors[triangle];
    std::replace(neighbors.begin(), neighbors.end(), from, to);
  }
}

int Triangulation::CornerOf(Index triangle, Index node) const
{
  const Triangle& t = this->Corners[triangle];
  return t[0] == node ? 0 : t[1] == node ? 1 : 2;
}

/// The same edge of the neighbour. There has to be one.
Triangulation::Edge Triangulation::BackOf(const Edge& edge) const
{
  const Index other = this->Neighbors[edge.Triangle][edge.Corner];
  return { other, this->CornerOf(other, this->Corners[edge.Triangle][(edge.Corner + 1) % 3]) };
}

/// Whether the triangles beside an edge make up a convex quadrilateral.
bool Triangulation::CanSwap(const Edge& edge) const
{
  if (this->Neighbors[edge.Triangle][edge.Corner] == None)
  {
    return false;
  }
  const Index a = this->Corners[edge.Triangle][edge.Corner];
  const Index b = this->Corners[edge.Triangle][(edge.Corner + 1) % 3];
  const Index c = this->ApexOf(edge);
  const Index d = this->ApexOf(this->BackOf(edge));
  return this->Side(a, d, c) > 0 && this->Side(d, b, c) > 0;
}

void Triangulation::Swap(const Edge& edge)
{
  const auto [s, i] = edge;
  const auto [t, j] = this->BackOf(edge);
  const Index a = this->Corners[s][i];
  const Index b = this->Corners[s][(i + 1) % 3];
  const Index c = this->Corners[s][(i + 2) % 3];
  const Index d = this->Corners[t][(j + 2) % 3];
  const Index bc = this->Neighbors[s][(i + 1) % 3];
  const Index ca = this->Neighbors[s][(i + 2) % 3];
  const Index ad = this->Neighbors[t][(j + 1) % 3];
  const Index db = this->Neighbors[t][(j + 2) % 3];
  this->Set(s, { a, d, c }, { ad, t, ca });
  this->Set(t, { d, b, c }, { db, bc, s });
  this->Replace(ad, t, s);
  this->Replace(bc, s, t);
  for (const Edge& side : { Edge{ s, 0 }, Edge{ s, 2 }, Edge{ t, 0 }, Edge{ t, 1 } })
  {
    this->Doubtful.push_back(side);
  }
}

/// Swaps edges until nothing gets better; keeps the borders, once they are in.
void Triangulation::Improve(bool withBorders)
{
  // Never reached but if rounding made edges turn round and round.
  std::size_t left = 100 * this->Corners.size() + 1000;
  while (!this->Doubtful.empty() && left > 0)
  {
    const Edge edge = this->Doubtful.back();
    this->Doubtful.pop_back();
    if (this->Neighbors[edge.Triangle][edge.Corner] == None)
    {
      continue;
    }
    const Index a = this->Corners[edge.Triangle][edge.Corner];
    const Index b = this->Corners[edge.Triangle][(edge.Corner + 1) % 3];
    if (this->IsBetter(a, b, this->ApexOf(edge), this->ApexOf(this->BackOf(edge))) &&
      !(withBorders && this->IsBorder(a, b)) && this->CanSwap(edge))
    {
      this->Swap(edge);
      --left;
    }
  }
  this->Doubtful.clear();
}

/// The triangle that a node lies in, by a walk from another one.
Index Triangulation::Find(Index node, Index near) const
{
  Index at = this->Start[near];
  const auto exit = [&](Index triangle, std::size_t first)
  {
    for (std::size_t i = first; i < first + 3; ++i)
    {
      const Triangle& t = this->Corners[triangle];
      if (this->Side(t[i % 3], t[(i + 1) % 3], node) < 0)
      {
        return static_cast<int>(i % 3);
      }
    }
    return -1;
  };
  // Beginning with another corner each time, the walk does not turn round and round. For certain:
  for (std::size_t step = 0; step < 3 * this->Corners.size() + 100; ++step)
  {
    const int edge = exit(at, step);
    if (edge < 0)
    {
      return at;
    }
    at = this->Neighbors[at][edge];
    if (at == None)
    {
      return None;
    }
  }
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    if (exit(static_cast<Index>(i), 0) < 0)
    {
      return static_cast<Index>(i);
    }
  }
  return None;
}

bool Triangulation::AddNode(Index node, Index near)
{
  const Index s = this->Find(node, near);
  if (s == None)
  {
    return false;
  }
  const auto [a, b, c] = this->Corners[s];
  const auto [ab, bc, ca] = this->Neighbors[s];
  const std::array<bool, 3> isOn{ this->Side(a, b, node) == 0, this->Side(b, c, node) == 0,
    this->Side(c, a, node) == 0 };
  if (isOn[0] + isOn[1] + isOn[2] > 1)
  {
    return false;
  }
  const Index t = static_cast<Index>(this->Corners.size());
  this->Corners.resize(t + 2);
  this->Neighbors.resize(t + 2);
  this->Set(t, { b, c, node }, { bc, t + 1, s });
  this->Set(t + 1, { c, a, node }, { ca, s, t });
  this->Set(s, { a, b, node }, { ab, t, t + 1 });
  this->Replace(bc, s, t);
  this->Replace(ca, s, t + 1);
  const std::array<Edge, 3> sides{ { { s, 0 }, { t, 0 }, { t + 1, 0 } } };
  for (int i = 0; i < 3; ++i)
  {
    if (isOn[i]) // of the edge: its triangle has no area
    {
      if (!this->CanSwap(sides[i]))
      {
        return false;
      }
      this->Swap(sides[i]);
    }
  }
  this->Doubtful.insert(this->Doubtful.end(), sides.begin(), sides.end());
  this->Improve(false);
  return true;
}

/**
 * First every 2^k-th along the loops, then those in the middle between them, and so on: each comes
 * close to one that is there, and takes the place of few edges.
 */
bool Triangulation::AddNodes(const std::vector<Index>& order)
{
  std::size_t stride = 1;
  while (2 * stride < order.size())
  {
    stride *= 2;
  }
  for (std::size_t place = 0; stride > 0; stride /= 2)
  {
    for (; place < order.size(); place += place == 0 ? stride : 2 * stride)
    {
      const Index node = order[place];
      const Index near = place == 0 ? this->Nodes : order[place - stride];
      // Crossings are on two loops.
      if (this->Start[node] == None && !this->AddNode(node, near))
      {
        return false;
      }
    }
    place = stride / 2;
  }
  return true;
}

/// Finds the edge ab, or else the first one that is crossed on the way from a to b.
bool Triangulation::FindAround(Index a, Index b, Edge& found) const
{
  const Index first = this->Start[a];
  Index at = first;
  do
  {
    const int corner = this->CornerOf(at, a);
    const Index p = this->Corners[at][(corner + 1) % 3];
    const Index q = this->Corners[at][(corner + 2) % 3];
    if (p == b)
    {
      found = { at, corner };
      return true;
    }
    if (q != b && this->Side(a, b, p) < 0 && this->Side(a, b, q) > 0)
    {
      found = { at, (corner + 1) % 3 };
      return true;
    }
    at = this->Neighbors[at][(corner + 2) % 3];
  } while (at != first && at != None);
  return false;
}

bool Triangulation::FindEdge(Index a, Index b, Edge& found) const
{
  return this->FindAround(a, b, found) && this->Corners[found.Triangle][found.Corner] == a;
}

bool Triangulation::AddBorder(Index a, Index b)
{
  Edge edge;
  if (!this->FindAround(a, b, edge))
  {
    return false;
  }
  if (this->Corners[edge.Triangle][edge.Corner] == a)
  {
    return true;
  }
  std::vector<std::array<Index, 2>> crossed;
  for (;;)
  {
    crossed.push_back({ this->Corners[edge.Triangle][edge.Corner],
      this->Corners[edge.Triangle][(edge.Corner + 1) % 3] });
    edge = this->BackOf(edge);
    const Index apex = this->ApexOf(edge);
    if (apex == b)
    {
      break;
    }
    const int side = this->Side(a, b, apex);
    if (side == 0)
    {
      return false;
    }
    // On through the edge with its start on the right and its end on the left.
    edge.Corner = (edge.Corner + (side > 0 ? 1 : 2)) % 3;
  }
  const std::size_t maximum = 10 * crossed.size() * crossed.size() + 100;
  for (std::size_t i = 0; i < crossed.size(); ++i)
  {
    // Around the corners of the outermost triangle there is no full circle to search.
    const auto [start, end] = crossed[i];
    if (i > maximum ||
      !(start < this->Nodes ? this->FindEdge(start, end, edge) : this->FindEdge(end, start, edge)))
    {
      return false;
    }
    if (!this->CanSwap(edge))
    {
      crossed.push_back({ start, end });
      continue;
    }
    const Index p = this->ApexOf(edge);
    const Index q = this->ApexOf(this->BackOf(edge));
    this->Swap(edge);
    if (this->Side(a, b, p) * this->Side(a, b, q) < 0)
    {
      crossed.push_back({ p, q });
    }
  }
  return true;
}

/// Marks the triangles of the regions, from their borders inwards.
bool Triangulation::FillRegions()
{
  this->RegionOf.assign(this->Corners.size(), None);
  std::vector<Index> reached;
  for (const int number : { 0, 1 })
  {
    const Region& region = this->Regions[number];
    for (Index node = 0; node < this->Nodes; ++node)
    {
      Edge edge;
      if (region.Next[node] == None)
      {
        continue;
      }
      if (!this->FindEdge(node, region.Next[node], edge))
      {
        return false;
      }
      std::int8_t& mark = this->RegionOf[edge.Triangle];
      if (mark == 1 - number)
      {
        return false;
      }
      if (mark == None)
      {
        mark = static_cast<std::int8_t>(number);
        reached.push_back(edge.Triangle);
      }
    }
  }
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    const Index t = reached[i];
    const std::int8_t number = this->RegionOf[t];
    for (int corner = 0; corner < 3; ++corner)
    {
      const Index a = this->Corners[t][corner];
      const Index b = this->Corners[t][(corner + 1) % 3];
      if (a >= this->Nodes)
      {
        return false;
      }
      if (this->IsBorder(a, b))
      {
        if (this->Regions[number].Next[a] != b)
        {
          return false;
        }
        continue;
      }
      const Index other = this->Neighbors[t][corner];
      if (this->RegionOf[other] == 1 - number)
      {
        return false;
      }
      if (this->RegionOf[other] == None)
      {
        this->RegionOf[other] = number;
        reached.push_back(other);
      }
    }
  }
  return true;
}

bool Triangulation::Run(const std::vector<Index>& order)
{
  if (!this->AddNodes(order))
  {
    return false;
  }
  for (const Region& region : this->Regions)
  {
    for (Index node = 0; node < this->Nodes; ++node)
    {
      if ((region.Next[node] == None) != (region.Previous[node] == None) ||
        (region.Next[node] != None && !this->AddBorder(node, region.Next[node])))
      {
        return false;
      }
    }
  }
  for (std::size_t t = 0; t < this->Corners.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Doubtful.push_back({ static_cast<Index>(t), i });
    }
  }
  this->Improve(true);
  return this->FillRegions();
}

std::array<RegionTriangles, 2> Triangulation::GetRegions() const
{
  std::array<RegionTriangles, 2> result;
  std::vector<Index> number(this->Corners.size(), None);
  for (std::size_t t = 0; t < this->Corners.size(); ++t)
  {
    if (this->RegionOf[t] != None)
    {
      RegionTriangles& region = result[this->RegionOf[t]];
      number[t] = static_cast<Index>(region.Corners.size());
      region.Corners.push_back(this->Corners[t]);
      region.Neighbors.push_back(this->Neighbors[t]);
    }
  }
  for (RegionTriangles& region : result)
  {
    for (std::size_t t = 0; t < region.Corners.size(); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        Index& neighbor = region.Neighbors[t][i];
        neighbor = this->IsBorder(region.Corners[t][i], region.Corners[t][(i + 1) % 3])
          ? None
          : number[neighbor];
      }
    }
  }
  return result;
}

/// The whole of it, for one displacement of the upper loops.
class Overlay
{
public:
  Overlay(const std::vector<SlabLoop>& loops, const Point2& shift, const Point2& displacement);

  SlabOverlay Run();

private:
  /// Of a segment of a lower and a segment of an upper loop.
  struct Crossing
  {
    std::array<Index, 2> Segment;
    std::array<double, 2> Share;
    std::array<Index, 2> Corner; ///< of the result
    bool ToLeft;                 ///< the upper loop passes to the left of the lower one
  };
  /// The loops as split by the crossings, in the form that SegmentTree takes.
  struct Chains
  {
    Contours Nodes;
    std::vector<Index> Numbers; ///< of the nodes

    std::array<Index, 2> Ends(const SegmentTree::Segment& segment) const
    {
      return { this->Numbers[segment.Vertex],
        this->Numbers[this->After(segment.Contour, segment.Vertex)] };
    }
    Index After(Index chain, Index vertex) const
    {
      return vertex + 1 < this->Nodes.Offsets[chain + 1] ? vertex + 1 : this->Nodes.Offsets[chain];
    }
  };

  bool IsCrossing(Index node) const { return node >= this->Vertices; }
  Crossing& CrossingAt(Index node) { return this->Crossings[node - this->Vertices]; }
  const Crossing& CrossingAt(Index node) const { return this->Crossings[node - this->Vertices]; }
  void AddNode(Chains& chains, Index node) const;
  void EndChain(Chains& chains, const SlabLoop& loop) const;
  std::vector<Index> LoopsAt(bool upper) const;

  bool FindCrossings();
  bool AddCrossing(const std::array<Index, 2>& lower, const std::array<Index, 2>& upper);
  bool SplitLoops();
  bool IsSimple() const;
  bool AreApart(const std::array<Index, 2>& s, const std::array<Index, 2>& t) const;
  bool IsProper(Index node, const std::vector<Index>& next, const std::vector<Index>& before) const;
  bool AddChain(Index chain, const SegmentTree& others, std::array<Region, 2>& regions) const;

  std::vector<std::int8_t> ChooseLevels(const Region& region,
    const std::vector<Triangle>& triangles, const std::vector<Triangle>& neighbors) const;
  void AddRegion(const Region& region, const std::vector<Triangle>& triangles,
    const std::vector<Triangle>& neighbors, bool clockwise);
  void AddTriangle(const Triangle& corners, const Triangle& middles, bool clockwise);
  void Add(Index a, Index b, Index c, bool clockwise);
  Index AddPoint(double u, double v);
  void NumberPieces();

  const std::vector<SlabLoop>& Loops;
  const Point2 Displacement;
  Index Vertices = 0;
  std::vector<Point2> Places;       ///< of the nodes: vertices of all loops, then crossings
  std::vector<std::int8_t> OnLevel; ///< of the nodes; 2 for crossings
  Chains Whole, Parts;
  std::vector<Crossing> Crossings;
  SlabOverlay Result;
};

Overlay::Overlay(
  const std::vector<SlabLoop>& loops, const Point2& shift, const Point2& displacement)
  : Loops(loops)
  , Displacement(displacement)
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

void Overlay::AddNode(Chains& chains, Index node) const
{
  chains.Numbers.push_back(node);
  chains.Nodes.U.push_back(this->Places[node][0]);
  chains.Nodes.V.push_back(this->Places[node][1]);
}

void Overlay::EndChain(Chains& chains, const SlabLoop& loop) const
{
  chains.Nodes.Offsets.push_back(static_cast<Index>(chains.Numbers.size()));
  chains.Nodes.Axis.push_back(2);
  chains.Nodes.Coordinate.push_back(loop.Upper ? 1.0 : 0.0);
}

std::vector<Index> Overlay::LoopsAt(bool upper) const
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

/// Returns false if the segments touch without crossing.
bool Overlay::AddCrossing(const std::array<Index, 2>& lower, const std::array<Index, 2>& upper)
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
  const Point2 a = Minus(q, p);
  const Point2 b = Minus(s, r);
  const Point2 c = Minus(r, p);
  const double area = Cross(a, b);
  // The place on the shorter segment, and what is closest to it on the longer one: so both new
  // vertices are there even if the segments are almost parallel.
  const auto square = [](const Point2& way) { return way[0] * way[0] + way[1] * way[1]; };
  std::array<double, 2> share;
  Point2 place;
  if (square(a) < square(b))
  {
    share[0] = Cross(c, b) / area;
    place = { p[0] + share[0] * a[0], p[1] + share[0] * a[1] };
    share[1] = ((place[0] - r[0]) * b[0] + (place[1] - r[1]) * b[1]) / square(b);
  }
  else
  {
    share[1] = Cross(c, a) / area;
    place = { r[0] + share[1] * b[0], r[1] + share[1] * b[1] };
    share[0] = ((place[0] - p[0]) * a[0] + (place[1] - p[1]) * a[1]) / square(a);
  }
  this->Places.push_back(place);
  this->OnLevel.push_back(2);
  this->Crossings.push_back({ { lower[0], upper[0] }, share, { None, None }, to > 0 });
  return true;
}

bool Overlay::FindCrossings()
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
bool Overlay::SplitLoops()
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
          this->Vertices + static_cast<Index>(this->Result.Insertions.size());
        this->Result.Insertions.push_back({ static_cast<Index>(loop), i, last });
      }
    }
    first += count;
    this->EndChain(this->Parts, this->Loops[loop]);
  }
  return true;
}

/// Whether two segments have no point in common but an end that is the same node.
bool Overlay::AreApart(const std::array<Index, 2>& s, const std::array<Index, 2>& t) const
{
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      if (s[i] == t[j])
      {
        return s[1 - i] != t[1 - j] &&
          !OnOneRay(this->Places[s[i]], this->Places[s[1 - i]], this->Places[t[1 - j]]);
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
bool Overlay::IsProper(
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
bool Overlay::IsSimple() const
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
        !OnOneRay(this->Places[b], this->Places[a], this->Places[c]);
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
bool Overlay::AddChain(Index chain, const SegmentTree& others, std::array<Region, 2>& regions) const
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
    Region& region = regions[upper != inside];
    if (!(inside ? region.Add(to, from, upper) : region.Add(from, to, upper)))
    {
      return false;
    }
  }
  return true;
}

/**
 * The triangles at a crossing all use one of its two corners, and a vertical triangle beside the
 * contour of the other one closes the gap. Chosen so that few edges are flat.
 */
std::vector<std::int8_t> Overlay::ChooseLevels(const Region& region,
  const std::vector<Triangle>& triangles, const std::vector<Triangle>& neighbors) const
{
  std::vector<std::int8_t> levels = this->OnLevel;
  std::vector<std::array<Index, 2>> edges; // from crossings
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index a = triangles[t][i];
      const Index b = triangles[t][(i + 1) % 3];
      if (neighbors[t][i] != None && this->IsCrossing(a))
      {
        edges.push_back({ a, b });
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::size_t edge = 0;
  for (Index node = this->Vertices; node < static_cast<Index>(this->Places.size()); ++node)
  {
    std::array<int, 3> count{ 0, 0, 0 };
    // Beside a contour between two crossings it is better to have an edge that goes up.
    for (const Index beside : { region.Next[node], region.Previous[node] })
    {
      const int level = region.Level[beside == region.Next[node] ? node : beside];
      if (this->IsCrossing(beside) && levels[beside] == 1 - level)
      {
        ++count[1 - level];
      }
    }
    for (; edge < edges.size() && edges[edge][0] == node; ++edge)
    {
      ++count[levels[edges[edge][1]]];
    }
    levels[node] = count[1] < count[0] ? 1 : 0;
  }
  return levels;
}

Index Overlay::AddPoint(double u, double v)
{
  // The displacement is sheared back here, so that it does not show at all.
  this->Result.Points.push_back(
    { u - 0.5 * this->Displacement[0], v - 0.5 * this->Displacement[1], 0.5 });
  return this->Vertices +
    static_cast<Index>(this->Result.Insertions.size() + this->Result.Points.size()) - 1;
}

void Overlay::Add(Index a, Index b, Index c, bool clockwise)
{
  this->Result.Triangles.push_back(clockwise ? Triangle{ a, c, b } : Triangle{ a, b, c });
}

/// Cuts up a triangle with points in the middle of edges.
void Overlay::AddTriangle(const Triangle& corners, const Triangle& middles, bool clockwise)
{
  const auto count =
    std::count_if(middles.begin(), middles.end(), [](Index i) { return i != None; });
  int first = 0; // the first of the edges with points
  while (count > 0 && count < 3 && (middles[first] == None || middles[(first + 2) % 3] != None))
  {
    ++first;
  }
  const Index a = corners[first];
  const Index b = corners[(first + 1) % 3];
  const Index c = corners[(first + 2) % 3];
  const Index ab = middles[first];
  const Index bc = middles[(first + 1) % 3];
  const Index ca = middles[(first + 2) % 3];
  if (count == 0)
  {
    this->Add(a, b, c, clockwise);
    return;
  }
  if (count == 1)
  {
    this->Add(a, ab, c, clockwise);
    this->Add(ab, b, c, clockwise);
    return;
  }
  this->Add(ab, b, bc, clockwise);
  if (count == 2)
  {
    this->Add(a, ab, bc, clockwise);
    this->Add(a, bc, c, clockwise);
    return;
  }
  this->Add(a, ab, ca, clockwise);
  this->Add(ca, bc, c, clockwise);
  this->Add(ab, bc, ca, clockwise);
}

void Overlay::AddRegion(const Region& region, const std::vector<Triangle>& triangles,
  const std::vector<Triangle>& neighbors, bool clockwise)
{
  const std::vector<std::int8_t> levels = this->ChooseLevels(region, triangles, neighbors);
  const auto cornerAt = [&](Index node, int level)
  { return this->IsCrossing(node) ? this->CrossingAt(node).Corner[level] : node; };
  const auto addMiddle = [&](Index a, Index b)
  {
    return this->AddPoint(0.5 * (this->Places[a][0] + this->Places[b][0]),
      0.5 * (this->Places[a][1] + this->Places[b][1]));
  };
  std::vector<Triangle> middles(triangles.size(), Triangle{ None, None, None });
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Triangle& nodes = triangles[t];
    Triangle corners;
    bool isFlat = true;
    for (int i = 0; i < 3; ++i)
    {
      const Index a = nodes[i];
      const Index b = nodes[(i + 1) % 3];
      const int from = levels[a];
      const int to = levels[b];
      corners[i] = cornerAt(a, from);
      const Index other = neighbors[t][i];
      if (other != None)
      {
        if (from == to && middles[t][i] == None)
        {
          const Triangle& n = neighbors[other];
          const int back = n[0] == static_cast<Index>(t) ? 0
            : n[1] == static_cast<Index>(t)              ? 1
                                                         : 2;
          middles[t][i] = middles[other][back] = addMiddle(a, b);
        }
        isFlat = false;
        continue;
      }
      // Between the triangle's edge and the contour there is a vertical gap.
      const int level = region.Level[a];
      const Index start = cornerAt(a, level);
      const Index end = cornerAt(b, level);
      isFlat = isFlat && from == level && to == level;
      if (from != level && to != level)
      {
        const Index middle = middles[t][i] = addMiddle(a, b);
        this->Add(start, end, middle, clockwise);
        this->Add(end, cornerAt(b, to), middle, clockwise);
        this->Add(middle, cornerAt(a, from), start, clockwise);
      }
      else if (from != level || to != level)
      {
        this->Add(start, end, from != level ? cornerAt(a, from) : cornerAt(b, to), clockwise);
      }
    }
    if (isFlat)
    {
      // A contour of three vertices, without partner.
      const Index middle = this->AddPoint(
        (this->Places[nodes[0]][0] + this->Places[nodes[1]][0] + this->Places[nodes[2]][0]) / 3.0,
        (this->Places[nodes[0]][1] + this->Places[nodes[1]][1] + this->Places[nodes[2]][1]) / 3.0);
      for (int i = 0; i < 3; ++i)
      {
        this->Add(corners[i], corners[(i + 1) % 3], middle, clockwise);
      }
      continue;
    }
    this->AddTriangle(corners, middles[t], clockwise);
  }
}

void Overlay::NumberPieces()
{
  std::vector<Index> parent(
    this->Vertices + this->Result.Insertions.size() + this->Result.Points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](Index i)
  {
    while (parent[i] != i)
    {
      i = parent[i] = parent[parent[i]];
    }
    return i;
  };
  for (const Triangle& t : this->Result.Triangles)
  {
    parent[find(t[0])] = find(t[1]);
    parent[find(t[1])] = find(t[2]);
  }
  std::vector<Index> number(parent.size(), None);
  Index count = 0;
  for (const Triangle& t : this->Result.Triangles)
  {
    Index& piece = number[find(t[0])];
    piece = piece == None ? count++ : piece;
    this->Result.Piece.push_back(piece);
  }
}

SlabOverlay Overlay::Run()
{
  if (!this->FindCrossings() || !this->SplitLoops() || !this->IsSimple())
  {
    return {};
  }
  std::array<Region, 2> regions{ Region(this->Places.size()), Region(this->Places.size()) };
  const SegmentTree lower(this->Whole.Nodes, this->LoopsAt(false));
  const SegmentTree upper(this->Whole.Nodes, this->LoopsAt(true));
  for (std::size_t i = 0; i < this->Loops.size(); ++i)
  {
    if (!this->AddChain(static_cast<Index>(i), this->Loops[i].Upper ? lower : upper, regions))
    {
      return {};
    }
  }
  Triangulation triangulation(this->Places, this->OnLevel, regions);
  if (!triangulation.Run(this->Parts.Numbers))
  {
    return {};
  }
  const std::array<RegionTriangles, 2> parts = triangulation.GetRegions();
  for (const bool above : { false, true })
  {
    this->AddRegion(regions[above], parts[above].Corners, parts[above].Neighbors, above);
  }
  this->NumberPieces();
  this->Result.Valid = true;
  return std::move(this->Result);
}

/// The larger side of the box around all loops; negative if there is something wrong with a loop.
double ExtentOf(const std::vector<SlabLoop>& loops, const Point2& shift)
{
  Point2 low{ HUGE_VAL, HUGE_VAL };
  Point2 high{ -HUGE_VAL, -HUGE_VAL };
  for (const SlabLoop& loop : loops)
  {
    if (loop.Points.size() < 3)
    {
      return -1.0;
    }
    for (const Point2& point : loop.Points)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        const double x = loop.Upper ? point[axis] - shift[axis] : point[axis];
        if (!std::isfinite(x))
        {
          return -1.0;
        }
        low[axis] = std::min(low[axis], x);
        high[axis] = std::max(high[axis], x);
      }
    }
  }
  return std::max(high[0] - low[0], high[1] - low[1]);
}
}

SlabOverlay OverlaySlab(const std::vector<SlabLoop>& loops, const Point2& shift)
{
  SlabOverlay result;
  if (loops.empty())
  {
    result.Valid = true;
    return result;
  }
  const double extent = ExtentOf(loops, shift);
  // Contours of voxel data, or of a prism, have vertices and segments in common with those of the
  // next slice. They have none after a displacement in a direction that is none of the grid's.
  constexpr std::array<Point2, 3> directions{ { { 0.6180339887e-7, 0.2718281828e-7 },
    { -0.3141592654e-7, 0.7320508076e-7 }, { -0.4142135624e-6, -0.2360679775e-6 } } };
  for (const Point2& direction : directions)
  {
    if (extent > 0.0 && !result.Valid)
    {
      result = Overlay(loops, shift, { extent * direction[0], extent * direction[1] }).Run();
    }
  }
  return result;
}
}
