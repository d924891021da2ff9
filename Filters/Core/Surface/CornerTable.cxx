// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/CornerTable.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace orthoslices
{
CornerTable::CornerTable(Index points, const std::vector<std::array<Index, 3>>& triangles)
{
  this->SetTriangles(points, triangles);
  this->LinkTriangles();
}

CornerTable CornerTable::WithoutLinks(
  Index points, const std::vector<std::array<Index, 3>>& triangles)
{
  CornerTable table;
  table.SetTriangles(points, triangles);
  return table;
}

void CornerTable::SetTriangles(Index points, const std::vector<std::array<Index, 3>>& triangles)
{
  this->Vertex.resize(3 * triangles.size());
  this->Opposite.assign(3 * triangles.size(), -1);
  this->Curve.assign(3 * triangles.size(), 0);
  this->Corner.assign(static_cast<std::size_t>(points), -1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    this->SetTriangle(static_cast<Index>(t), triangles[t][0], triangles[t][1], triangles[t][2]);
  }
}

void CornerTable::LinkTriangles()
{
  // A counting sort by the end with the smaller number, then each of the short lists by the other.
  const auto low = [&](Index corner)
  { return std::min(this->StartOf(corner), this->EndOf(corner)); };
  const auto high = [&](Index corner)
  { return std::max(this->StartOf(corner), this->EndOf(corner)); };
  std::vector<Index> offsets(this->Corner.size() + 2, 0);
  for (Index corner = 0; corner < this->CornerCount(); ++corner)
  {
    ++offsets[low(corner) + 2];
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<std::pair<Index, Index>> edges(this->Vertex.size());
  for (Index corner = 0; corner < this->CornerCount(); ++corner)
  {
    edges[offsets[low(corner) + 1]++] = { high(corner), corner };
  }
  for (std::size_t point = 0; point + 1 < offsets.size(); ++point)
  {
    std::sort(edges.begin() + offsets[point], edges.begin() + offsets[point + 1]);
  }
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
  {
    const Index corner = edges[i].second, next = edges[i + 1].second;
    if (edges[i].first == edges[i + 1].first && low(corner) == low(next))
    {
      this->Link(corner, next);
      ++i;
    }
  }
}

void CornerTable::Link(Index corner, Index opposite)
{
  this->Opposite[corner] = opposite;
  this->Opposite[opposite] = corner;
}

void CornerTable::SetTriangle(Index triangle, Index a, Index b, Index c)
{
  const std::array<Index, 3> vertices{ a, b, c };
  for (Index i = 0; i < 3; ++i)
  {
    this->Vertex[3 * triangle + i] = vertices[i];
    this->Corner[vertices[i]] = 3 * triangle + i;
  }
}

void CornerTable::MarkCurve(Index corner)
{
  this->Curve[corner] = 1;
  if (this->Opposite[corner] >= 0)
  {
    this->Curve[this->Opposite[corner]] = 1;
  }
}

Index CornerTable::Valence(Index vertex) const
{
  Index count = 0;
  this->ForCornersAt(vertex, [&](Index) { ++count; });
  return count;
}

Index CornerTable::FindEdge(Index from, Index to) const
{
  Index found = -1;
  // The triangle of each corner at `from` has the edge from there to the next vertex.
  this->ForCornersAt(from,
    [&](Index corner)
    {
      if (this->Vertex[Next(corner)] == to)
      {
        found = Previous(corner);
      }
    });
  return found;
}

bool CornerTable::AreAdjacent(Index a, Index b) const
{
  // Turns around both at once, as one of them may be the centre of a large fan.
  const Index firstA = this->Corner[a];
  const Index firstB = this->Corner[b];
  Index atA = firstA;
  Index atB = firstB;
  do
  {
    if (this->Vertex[Next(atA)] == b || this->Vertex[Next(atB)] == a)
    {
      return true;
    }
    atA = Next(this->Opposite[Next(atA)]);
    atB = Next(this->Opposite[Next(atB)]);
  } while (atA != firstA && atB != firstB);
  return false;
}

Index CornerTable::CountCurves(Index vertex) const
{
  Index count = 0;
  this->ForCornersAt(vertex, [&](Index corner) { count += this->Curve[Previous(corner)]; });
  return count;
}

Index CornerTable::CountCommonNeighbors(Index start, Index end) const
{
  // The neighbors of the end, looked up once, unless it is the centre of a large fan.
  constexpr Index most = 16;
  std::array<Index, most> around;
  Index count = 0;
  this->ForCornersAt(end,
    [&](Index at)
    {
      if (count < most)
      {
        around[count] = this->Vertex[Next(at)];
      }
      ++count;
    });
  Index common = 0;
  this->ForCornersAt(start,
    [&](Index at)
    {
      const Index neighbor = this->Vertex[Next(at)];
      const bool isCommon = neighbor != end &&
        (count <= most
            ? std::find(around.begin(), around.begin() + count, neighbor) != around.begin() + count
            : this->AreAdjacent(neighbor, end));
      common += isCommon ? 1 : 0;
    });
  return common;
}

bool CornerTable::CanCollapse(Index corner) const
{
  const Index start = this->StartOf(corner);
  const Index end = this->EndOf(corner);
  const Index curves = this->CountCurves(start);
  if (curves > 0 && !(curves == 2 && this->IsCurve(corner)))
  {
    return false;
  }
  for (const Index at : { corner, this->Opposite[corner] })
  {
    if (this->IsCurve(Next(at)) && this->IsCurve(Previous(at)))
    {
      return false; // two curves would become one
    }
  }
  return this->Valence(start) + this->Valence(end) > 7 &&
    this->CountCommonNeighbors(start, end) == 2;
}

void CornerTable::Collapse(Index corner)
{
  const Index start = this->StartOf(corner);
  const Index end = this->EndOf(corner);
  const Index across = this->Opposite[corner];
  // The way around a vertex does not depend on its number.
  this->ForCornersAt(start, [&](Index at) { this->Vertex[at] = end; });
  this->Corner[start] = -1;
  for (const Index gone : { corner, across })
  {
    // The two other edges of a triangle that vanishes become one.
    const Index one = this->Opposite[Next(gone)];
    const Index other = this->Opposite[Previous(gone)];
    this->Link(one, other);
    const std::uint8_t curve = this->Curve[one] | this->Curve[other];
    this->Curve[one] = this->Curve[other] = curve;
    this->Corner[this->Vertex[gone]] = Next(one);
    this->Corner[end] = Previous(one);
  }
  for (const Index gone : { corner, across })
  {
    for (const Index dead : { gone, Next(gone), Previous(gone) })
    {
      this->Vertex[dead] = -1;
    }
  }
}

bool CornerTable::CanFlip(Index corner) const
{
  const Index across = this->Opposite[corner];
  return !this->IsCurve(corner) && this->Valence(this->StartOf(corner)) > 3 &&
    this->Valence(this->EndOf(corner)) > 3 &&
    !this->AreAdjacent(this->Vertex[corner], this->Vertex[across]);
}

void CornerTable::Flip(Index corner)
{
  // Triangles (a, b, c) and (b, a, d) become (a, d, c) and (d, b, c).
  const Index across = this->Opposite[corner];
  const Index c = this->Vertex[corner];
  const Index d = this->Vertex[across];
  const Index a = this->StartOf(corner);
  const Index b = this->EndOf(corner);
  const Index overB = Next(corner);       // at a, edge b c
  const Index overA = Previous(corner);   // at b, edge c a
  const Index acrossA = Next(across);     // at b, edge a d
  const Index acrossB = Previous(across); // at a, edge d b
  struct Side
  {
    Index Opposite;
    std::uint8_t Curve;
  };
  const auto sideOf = [&](Index at) { return Side{ this->Opposite[at], this->Curve[at] }; };
  const Side bc = sideOf(overB), ca = sideOf(overA), ad = sideOf(acrossA), db = sideOf(acrossB);
  const Index first = corner / 3;
  const Index second = across / 3;
  this->SetTriangle(first, a, d, c);
  this->SetTriangle(second, d, b, c);
  const auto attach = [&](Index at, const Side& side)
  {
    this->Link(at, side.Opposite);
    this->Curve[at] = side.Curve;
  };
  attach(3 * first + 2, ad);
  attach(3 * first + 1, ca);
  attach(3 * second, bc);
  attach(3 * second + 2, db);
  this->Link(3 * first, 3 * second + 1);
  this->Curve[3 * first] = this->Curve[3 * second + 1] = 0;
}

Index CornerTable::Split(Index corner)
{
  // (a, b, c) and (b, a, d) become (m, b, c), (a, m, c), (b, m, d) and (m, a, d).
  const Index across = this->Opposite[corner];
  const Index a = this->StartOf(corner);
  const Index c = this->Vertex[corner];
  const Index d = this->Vertex[across];
  const Index middle = this->PointCount();
  const Index overB = this->Opposite[Previous(corner)]; // edge c a
  const Index overD = this->Opposite[Next(across)];     // edge a d
  const std::uint8_t curveB = this->Curve[Previous(corner)];
  const std::uint8_t curveD = this->Curve[Next(across)];
  const std::uint8_t curve = this->Curve[corner];
  const Index upper = this->CornerCount() / 3;
  const Index lower = upper + 1;
  this->Corner.push_back(-1);
  this->Vertex.resize(this->Vertex.size() + 6);
  this->Opposite.resize(this->Opposite.size() + 6, -1);
  this->Curve.resize(this->Curve.size() + 6, 0);
  this->Vertex[Next(corner)] = middle;
  this->Vertex[Previous(across)] = middle;
  this->SetTriangle(upper, a, middle, c);
  this->SetTriangle(lower, middle, a, d);
  this->Corner[middle] = Next(corner);
  this->Link(3 * upper + 1, overB);
  this->Curve[3 * upper + 1] = curveB;
  this->Link(3 * lower, overD);
  this->Curve[3 * lower] = curveD;
  this->Link(3 * upper, Previous(corner));
  this->Curve[3 * upper] = this->Curve[Previous(corner)] = 0;
  this->Link(3 * lower + 1, Next(across));
  this->Curve[3 * lower + 1] = this->Curve[Next(across)] = 0;
  this->Link(3 * upper + 2, 3 * lower + 2);
  this->Curve[3 * upper + 2] = this->Curve[3 * lower + 2] = curve;
  return middle;
}

void CornerTable::Grow(Index points, Index triangles)
{
  this->Corner.resize(this->Corner.size() + points, -1);
  this->Vertex.resize(this->Vertex.size() + 3 * static_cast<std::size_t>(triangles), -1);
  this->Opposite.resize(this->Vertex.size(), -1);
  this->Curve.resize(this->Vertex.size(), 0);
}

void CornerTable::Put(
  Index triangle, const std::array<Index, 3>& vertices, const std::array<std::uint8_t, 3>& curves)
{
  const std::ptrdiff_t first = 3 * static_cast<std::ptrdiff_t>(triangle);
  std::copy(vertices.begin(), vertices.end(), this->Vertex.begin() + first);
  std::copy(curves.begin(), curves.end(), this->Curve.begin() + first);
}

void CornerTable::TakeOut(Index triangle)
{
  std::fill_n(this->Vertex.begin() + 3 * static_cast<std::ptrdiff_t>(triangle), 3, -1);
}

std::vector<std::array<Index, 3>> CornerTable::ListTriangles() const
{
  std::vector<std::array<Index, 3>> triangles;
  for (Index corner = 0; corner < this->CornerCount(); corner += 3)
  {
    if (this->IsAlive(corner))
    {
      triangles.push_back(
        { this->Vertex[corner], this->Vertex[corner + 1], this->Vertex[corner + 2] });
    }
  }
  return triangles;
}
}
