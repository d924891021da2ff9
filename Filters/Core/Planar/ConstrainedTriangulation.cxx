// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/ConstrainedTriangulation.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
constexpr Index None = -1;

/// The legs of the right-angled triangle around all points are three times so many extents of the
/// points long: so far away it hardly changes which circles through points are empty.
constexpr double FrameSize = 100.0;

/// Four points count as lying on one circle if the determinant of the test is within this share of
/// the sum of its terms' sizes. Far above its rounding error (some 1e-15) and that of coordinates
/// which are a thousand times the points' distances; far below what can be seen.
constexpr double CocircularTolerance = 1e-11;

/// Bounds of loops that are finite in exact arithmetic; they are never reached but if rounding made
/// edges turn round and round. Lawson's swaps number a few for each triangle; the edges crossed by
/// a border come up again at most once for each pair of them (Sloan).
constexpr std::size_t MaxSwapsPerTriangle = 100, MinSwaps = 1000;
constexpr std::size_t MaxTurnsPerPair = 10, MinTurns = 100;
}

ConstrainedTriangulation::ConstrainedTriangulation(const std::vector<Point2>& places,
  const std::vector<std::int8_t>& levels, const std::array<PlaneRegion, 2>& regions)
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
  const double size = FrameSize * std::max(high[0] - low[0], high[1] - low[1]);
  this->Places.push_back({ low[0] - size, low[1] - size });
  this->Places.push_back({ low[0] + 2.0 * size, low[1] - size });
  this->Places.push_back({ low[0], low[1] + 2.0 * size });
  this->Levels.insert(this->Levels.end(), 3, OnBothLevels);
  this->Triangles.push_back(
    { { this->Nodes, this->Nodes + 1, this->Nodes + 2 }, { None, None, None } });
  this->SetStarts(0);
}

bool ConstrainedTriangulation::IsBorder(Index a, Index b) const
{
  return a < this->Nodes && b < this->Nodes &&
    std::any_of(this->Regions.begin(), this->Regions.end(),
      [&](const PlaneRegion& region) { return region.Next[a] == b || region.Next[b] == a; });
}

/// Whether cd is better than ab, the edge between triangles abc and bad. Rounding does no harm.
bool ConstrainedTriangulation::IsBetter(Index a, Index b, Index c, Index d) const
{
  const Point2& o = this->Places[d];
  const Point2 p = this->Places[a] - o;
  const Point2 q = this->Places[b] - o;
  const Point2 r = this->Places[c] - o;
  const double pp = Dot(p, p);
  const double qq = Dot(q, q);
  const double rr = Dot(r, r);
  const double inside = pp * Cross(q, r) + qq * Cross(r, p) + rr * Cross(p, q);
  const double doubt = CocircularTolerance *
    (pp * (std::abs(q[0] * r[1]) + std::abs(q[1] * r[0])) +
      qq * (std::abs(r[0] * p[1]) + std::abs(r[1] * p[0])) +
      rr * (std::abs(p[0] * q[1]) + std::abs(p[1] * q[0])));
  return inside > doubt || (inside >= -doubt && this->IsFlat(a, b) && !this->IsFlat(c, d));
}

/// Lets the corners of a triangle know that it is one of theirs.
void ConstrainedTriangulation::SetStarts(Index triangle)
{
  for (const Index node : this->Triangles[triangle].Corners)
  {
    this->Start[node] = triangle;
  }
}

/// Whether the triangles beside an edge make up a convex quadrilateral.
bool ConstrainedTriangulation::CanSwap(const TriangleSide& edge) const
{
  if (this->Triangles.NeighborOf(edge) == None)
  {
    return false;
  }
  const Index a = this->Triangles.StartOf(edge);
  const Index b = this->Triangles.EndOf(edge);
  const Index c = this->Triangles.ApexOf(edge);
  const Index d = this->Triangles.ApexOf(this->Triangles.BackOf(edge));
  return this->Side(a, d, c) > 0 && this->Side(d, b, c) > 0;
}

/// Takes the other diagonal, and doubts the four sides of the quadrilateral.
void ConstrainedTriangulation::Swap(const TriangleSide& edge)
{
  const Index s = edge.Triangle;
  const Index t = this->Triangles.NeighborOf(edge);
  this->Triangles.Flip(edge);
  this->SetStarts(s);
  this->SetStarts(t);
  this->Doubtful.insert(this->Doubtful.end(), { { s, 0 }, { s, 2 }, { t, 0 }, { t, 1 } });
}

/// Swaps edges until nothing gets better; keeps the borders, once they are in.
void ConstrainedTriangulation::Improve(bool withBorders)
{
  std::size_t left = MaxSwapsPerTriangle * this->Triangles.size() + MinSwaps;
  while (!this->Doubtful.empty() && left > 0)
  {
    const TriangleSide edge = this->Doubtful.back();
    this->Doubtful.pop_back();
    if (this->Triangles.NeighborOf(edge) == None)
    {
      continue;
    }
    const Index a = this->Triangles.StartOf(edge);
    const Index b = this->Triangles.EndOf(edge);
    const Index c = this->Triangles.ApexOf(edge);
    const Index d = this->Triangles.ApexOf(this->Triangles.BackOf(edge));
    if (this->IsBetter(a, b, c, d) && !(withBorders && this->IsBorder(a, b)) && this->CanSwap(edge))
    {
      this->Swap(edge);
      --left;
    }
  }
  this->Doubtful.clear();
}

/// The triangle that a node lies in, by a walk from another one.
Index ConstrainedTriangulation::Find(Index node, Index near) const
{
  Index at = this->Start[near];
  const auto exit = [&](Index triangle, std::size_t first)
  {
    for (std::size_t i = first; i < first + 3; ++i)
    {
      const auto& t = this->Triangles[triangle].Corners;
      if (this->Side(t[i % 3], t[(i + 1) % 3], node) < 0)
      {
        return static_cast<int>(i % 3);
      }
    }
    return -1;
  };
  // Beginning with another corner each time, the walk does not turn round and round. For certain:
  for (std::size_t step = 0; step < 3 * this->Triangles.size() + 100; ++step)
  {
    const int edge = exit(at, step);
    if (edge < 0)
    {
      return at;
    }
    at = this->Triangles[at].Neighbors[edge];
    if (at == None)
    {
      return None;
    }
  }
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    if (exit(static_cast<Index>(i), 0) < 0)
    {
      return static_cast<Index>(i);
    }
  }
  return None;
}

bool ConstrainedTriangulation::AddNode(Index node, Index near)
{
  const Index s = this->Find(node, near);
  if (s == None)
  {
    return false;
  }
  const auto [a, b, c] = this->Triangles[s].Corners;
  const std::array<bool, 3> isOn{ this->Side(a, b, node) == 0, this->Side(b, c, node) == 0,
    this->Side(c, a, node) == 0 };
  if (isOn[0] + isOn[1] + isOn[2] > 1)
  {
    return false;
  }
  const Index t = static_cast<Index>(this->Triangles.size());
  this->Triangles.Divide(s, node);
  for (const Index triangle : { t, t + 1, s })
  {
    this->SetStarts(triangle);
  }
  const std::array<TriangleSide, 3> sides{ { { s, 0 }, { t, 0 }, { t + 1, 0 } } };
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
bool ConstrainedTriangulation::AddNodes(const std::vector<Index>& order)
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
bool ConstrainedTriangulation::FindAround(Index a, Index b, TriangleSide& found) const
{
  const Index first = this->Start[a];
  Index at = first;
  do
  {
    const LinkedTriangle& triangle = this->Triangles[at];
    const int corner = triangle.CornerOf(a);
    const Index p = triangle.Corners[(corner + 1) % 3];
    const Index q = triangle.Corners[(corner + 2) % 3];
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
    at = triangle.Neighbors[(corner + 2) % 3];
  } while (at != first && at != None);
  return false;
}

bool ConstrainedTriangulation::FindEdge(Index a, Index b, TriangleSide& found) const
{
  return this->FindAround(a, b, found) && this->Triangles.StartOf(found) == a;
}

bool ConstrainedTriangulation::AddBorder(Index a, Index b)
{
  TriangleSide edge;
  if (!this->FindAround(a, b, edge))
  {
    return false;
  }
  if (this->Triangles.StartOf(edge) == a)
  {
    return true;
  }
  std::vector<std::array<Index, 2>> crossed;
  for (;;)
  {
    crossed.push_back({ this->Triangles.StartOf(edge), this->Triangles.EndOf(edge) });
    edge = this->Triangles.BackOf(edge);
    const Index apex = this->Triangles.ApexOf(edge);
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
    edge.Side = (edge.Side + (side > 0 ? 1 : 2)) % 3;
  }
  const std::size_t maximum = MaxTurnsPerPair * crossed.size() * crossed.size() + MinTurns;
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
    const Index p = this->Triangles.ApexOf(edge);
    const Index q = this->Triangles.ApexOf(this->Triangles.BackOf(edge));
    this->Swap(edge);
    if (this->Side(a, b, p) * this->Side(a, b, q) < 0)
    {
      crossed.push_back({ p, q });
    }
  }
  return true;
}

/// Marks the triangles of the regions, from their borders inwards.
bool ConstrainedTriangulation::FillRegions()
{
  this->RegionOf.assign(this->Triangles.size(), None);
  std::vector<Index> reached;
  for (const int number : { 0, 1 })
  {
    const PlaneRegion& region = this->Regions[number];
    for (Index node = 0; node < this->Nodes; ++node)
    {
      TriangleSide edge;
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
      const Index a = this->Triangles.StartOf({ t, corner });
      const Index b = this->Triangles.EndOf({ t, corner });
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
      const Index other = this->Triangles.NeighborOf({ t, corner });
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

bool ConstrainedTriangulation::Run(const std::vector<Index>& order)
{
  if (!this->AddNodes(order))
  {
    return false;
  }
  for (const PlaneRegion& region : this->Regions)
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
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Doubtful.push_back({ static_cast<Index>(t), i });
    }
  }
  this->Improve(true);
  return this->FillRegions();
}

std::array<TriangleAdjacency, 2> ConstrainedTriangulation::GetRegions() const
{
  std::array<TriangleAdjacency, 2> result;
  std::vector<Index> number(this->Triangles.size(), None);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    if (this->RegionOf[t] != None)
    {
      TriangleAdjacency& region = result[this->RegionOf[t]];
      number[t] = static_cast<Index>(region.size());
      region.push_back(this->Triangles[t]);
    }
  }
  for (TriangleAdjacency& region : result)
  {
    for (LinkedTriangle& triangle : region)
    {
      for (int i = 0; i < 3; ++i)
      {
        Index& neighbor = triangle.Neighbors[i];
        neighbor = this->IsBorder(triangle.Corners[i], triangle.Corners[(i + 1) % 3])
          ? None
          : number[neighbor];
      }
    }
  }
  return result;
}
}
