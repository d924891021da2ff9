// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/PlaneFaces.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Base/Predicates.h"

#include <algorithm>
#include <tuple>

namespace orthoslices
{
namespace
{
constexpr Index None = -1;

/// 0 for directions from 0 up to, but not, 180 degrees, 1 for the others. Exact.
int HalfPlaneOf(const Point2& from, const Point2& to)
{
  return to[1] > from[1] || (to[1] == from[1] && to[0] > from[0]) ? 0 : 1;
}

/// One of the sides of a walk, from the lower to the higher node.
struct Passing
{
  Index Low, High, Walk, Net;
};
}

PlaneFaces::PlaneFaces(const PlaneWalks& walks)
  : Around(walks.Nodes.size())
{
  this->AddEdges(walks);
  this->SortAround(walks.Nodes);
  this->FindComponents(walks.Nodes);
  this->FindFaces();
}

void PlaneFaces::AddEdges(const PlaneWalks& walks)
{
  std::vector<Passing> sides;
  for (std::size_t walk = 0; walk < walks.Walks.size(); ++walk)
  {
    const std::vector<Index>& nodes = walks.Walks[walk];
    for (std::size_t i = 0; i < nodes.size() && nodes.size() > 1; ++i)
    {
      const Index from = nodes[i];
      const Index to = nodes[(i + 1) % nodes.size()];
      sides.push_back(
        { std::min(from, to), std::max(from, to), static_cast<Index>(walk), from < to ? 1 : -1 });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Passing& a, const Passing& b)
    { return std::tie(a.Low, a.High, a.Walk) < std::tie(b.Low, b.High, b.Walk); });
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const Passing& side = sides[i];
    const bool isNew = i == 0 || sides[i - 1].Low != side.Low || sides[i - 1].High != side.High;
    if (isNew)
    {
      this->Around[side.Low].push_back(static_cast<Index>(this->Heads.size()));
      this->Heads.push_back(side.High);
      this->Around[side.High].push_back(static_cast<Index>(this->Heads.size()));
      this->Heads.push_back(side.Low);
      this->PassageOffsets.push_back(this->PassageOffsets.back());
    }
    if (!isNew && sides[i - 1].Walk == side.Walk)
    {
      this->Passages.back().Net += side.Net;
      continue;
    }
    this->Passages.push_back({ side.Walk, side.Net });
    ++this->PassageOffsets.back();
  }
}

void PlaneFaces::SortAround(const std::vector<Point2>& places)
{
  this->Clockwises.resize(this->Heads.size());
  for (std::size_t node = 0; node < places.size(); ++node)
  {
    const Point2& here = places[node];
    std::vector<Index>& leaving = this->Around[node];
    std::sort(leaving.begin(), leaving.end(),
      [&](Index a, Index b)
      {
        const Point2& p = places[this->Heads[a]];
        const Point2& q = places[this->Heads[b]];
        const int halfA = HalfPlaneOf(here, p);
        const int halfB = HalfPlaneOf(here, q);
        return halfA != halfB ? halfA < halfB : SideOf(here, p, q) > 0;
      });
    for (std::size_t i = 0; i < leaving.size(); ++i)
    {
      this->Clockwises[leaving[i]] = leaving[(i + leaving.size() - 1) % leaving.size()];
    }
  }
}

/// The half-edge that leaves a component's node of the least u, and of these the least v, with the
/// outer face on its left: what lies towards -u.
Index PlaneFaces::OutermostAt(Index node, const std::vector<Point2>& places) const
{
  Index outermost = this->Around[node].back();
  for (const Index halfEdge : this->Around[node])
  {
    if (HalfPlaneOf(places[node], places[this->Heads[halfEdge]]) == 0)
    {
      outermost = halfEdge;
    }
  }
  return outermost;
}

void PlaneFaces::FindComponents(const std::vector<Point2>& places)
{
  const Index nodes = static_cast<Index>(places.size());
  DisjointSets sets(nodes);
  for (Index halfEdge = 0; halfEdge < this->CountHalfEdges(); halfEdge += 2)
  {
    sets.Unite(this->Head(halfEdge), this->Tail(halfEdge));
  }
  this->ComponentAt.assign(nodes, None);
  std::vector<Index> extreme;
  for (Index node = 0; node < nodes; ++node)
  {
    if (this->Around[node].empty())
    {
      continue;
    }
    const Index first = sets.Find(node);
    if (first == node)
    {
      this->ComponentAt[node] = static_cast<Index>(extreme.size());
      extreme.push_back(node);
    }
    const Index component = this->ComponentAt[first];
    this->ComponentAt[node] = component;
    extreme[component] = places[node] < places[extreme[component]] ? node : extreme[component];
  }
  for (const Index node : extreme)
  {
    this->OuterFaces.push_back(this->OutermostAt(node, places));
  }
}

void PlaneFaces::FindFaces()
{
  this->Faces.assign(this->Heads.size(), None);
  for (Index start = 0; start < this->CountHalfEdges(); ++start)
  {
    if (this->Faces[start] != None)
    {
      continue;
    }
    const Index face = this->CountFaces();
    this->ComponentOfFace.push_back(this->ComponentAt[this->Heads[start]]);
    for (Index at = start; this->Faces[at] == None; at = this->Clockwises[Twin(at)])
    {
      this->Faces[at] = face;
    }
  }
  for (Index& outer : this->OuterFaces)
  {
    outer = this->Faces[outer];
  }
}
}
