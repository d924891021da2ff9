// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/CommonArea.h"

#include <algorithm>
#include <set>

namespace orthoslices
{
namespace
{
/// Part of a boundary between two vertices of either region.
using Part = std::pair<Point2, Point2>;

std::vector<Part> EdgesOf(const ContourStack& stack, const std::vector<Index>& contours)
{
  std::vector<Part> edges;
  for (const Index contour : contours)
  {
    for (Index i = stack.Offsets[contour]; i < stack.Offsets[contour + 1]; ++i)
    {
      edges.push_back({ stack.At(i), stack.At(stack.Next(contour, i)) });
    }
  }
  return edges;
}

bool AreApart(const Part& a, const Part& b)
{
  for (int i = 0; i < 2; ++i)
  {
    if (std::max(a.first[i], a.second[i]) < std::min(b.first[i], b.second[i]) ||
      std::max(b.first[i], b.second[i]) < std::min(a.first[i], a.second[i]))
    {
      return true;
    }
  }
  return false;
}

/// In a point that is inside of both.
bool DoCross(const Part& a, const Part& b)
{
  return SideOf(a.first, a.second, b.first) * SideOf(a.first, a.second, b.second) < 0 &&
    SideOf(b.first, b.second, a.first) * SideOf(b.first, b.second, a.second) < 0;
}

bool LiesInside(const Point2& p, const Part& edge)
{
  return p != edge.first && p != edge.second && !AreApart(edge, { p, p }) &&
    SideOf(edge.first, edge.second, p) == 0;
}

/// Splits the edges at the ends of others that lie on them. False if an edge crosses another.
bool Split(
  const std::vector<Part>& edges, const std::vector<Part>& others, std::vector<Part>& parts)
{
  for (const Part& edge : edges)
  {
    std::vector<Point2> places{ edge.first, edge.second };
    for (const Part& other : others)
    {
      if (AreApart(edge, other))
      {
        continue;
      }
      if (DoCross(edge, other))
      {
        return false;
      }
      if (LiesInside(other.first, edge))
      {
        places.push_back(other.first);
      }
    }
    // Along a segment, places ascend or descend in both coordinates.
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    if (edge.first > edge.second)
    {
      std::reverse(places.begin(), places.end());
    }
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
    {
      parts.push_back({ places[i], places[i + 1] });
    }
  }
  return true;
}

/// Whether a part that is on no edge lies inside; decided just behind its beginning p, as seen
/// along a ray towards +u. Where p is on the line of an edge, the end tells the side.
bool IsWithin(const Part& part, const std::vector<Part>& edges)
{
  const auto& [p, end] = part;
  const auto isAbove = [&](const Point2& q)
  { return q[1] > part.first[1] || (q[1] == part.first[1] && part.second[1] < part.first[1]); };
  bool within = false;
  for (const auto& [a, b] : edges)
  {
    const bool rises = isAbove(b);
    if (isAbove(a) != rises)
    {
      const int side = SideOf(a, b, p);
      within ^= (side != 0 ? side : SideOf(a, b, end)) == (rises ? 1 : -1);
    }
  }
  return within;
}

/// Whether a part of one boundary has the interior of both regions beside it.
bool PassesThrough(const std::vector<Part>& parts, const std::vector<Part>& others)
{
  const std::set<Part> known(others.begin(), others.end());
  return std::any_of(parts.begin(), parts.end(),
    [&](const Part& part)
    {
      return known.count(part) > 0 ||
        (known.count({ part.second, part.first }) == 0 && IsWithin(part, others));
    });
}
}

bool HaveCommonArea(
  const ContourStack& stack, const std::vector<Index>& one, const std::vector<Index>& other)
{
  const std::vector<Part> a = EdgesOf(stack, one);
  const std::vector<Part> b = EdgesOf(stack, other);
  std::vector<Part> partsOfA, partsOfB;
  return !Split(a, b, partsOfA) || !Split(b, a, partsOfB) || PassesThrough(partsOfA, partsOfB) ||
    PassesThrough(partsOfB, partsOfA);
}
}
