// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/TraceRegion.h"

#include "Core/Base/Vectors.h"
#include "Core/Loops/PartTouching.h"

#include <algorithm>
#include <map>

namespace orthoslices
{
namespace
{
constexpr Index None = -1;

class RegionTracer
{
public:
  RegionTracer(
    const PlaneWalks& walks, const PlaneFaces& faces, const std::vector<std::uint8_t>& inside)
    : Walks(walks)
    , Graph(faces)
    , Inside(inside)
    , PlaceOf(walks.Nodes.size(), None)
  {
  }

  std::vector<TracedLoop> Run();

private:
  bool IsBorder(Index halfEdge) const
  {
    return this->Inside[this->Graph.Face(halfEdge)] &&
      !this->Inside[this->Graph.Face(PlaneFaces::Twin(halfEdge))];
  }
  Index Next(Index halfEdge) const;
  void AddFrom(Index start, std::vector<std::uint8_t>& isDone);
  void AddLoop(std::vector<Index>&& halfEdges);
  Index MainWalkOf(const std::vector<Index>& halfEdges) const;

  const PlaneWalks& Walks;
  const PlaneFaces& Graph;
  const std::vector<std::uint8_t>& Inside;
  std::vector<Index> PlaceOf; ///< of each node: its place on the loop at work
  std::vector<TracedLoop> Loops;
};

/// The next border with the same sector of the inside on the left.
Index RegionTracer::Next(Index halfEdge) const
{
  Index next = this->Graph.Clockwise(PlaneFaces::Twin(halfEdge));
  while (!this->IsBorder(next))
  {
    next = this->Graph.Clockwise(next);
  }
  return next;
}

/// Follows the border. Whenever it comes back to a node, what it passed since then is a loop.
void RegionTracer::AddFrom(Index start, std::vector<std::uint8_t>& isDone)
{
  std::vector<Index> path;
  for (Index at = start; !isDone[at]; at = this->Next(at))
  {
    isDone[at] = 1;
    Index& place = this->PlaceOf[this->Graph.Tail(at)];
    if (place != None)
    {
      std::vector<Index> loop(path.begin() + place, path.end());
      path.resize(place);
      for (const Index halfEdge : loop)
      {
        this->PlaceOf[this->Graph.Tail(halfEdge)] = None;
      }
      this->AddLoop(std::move(loop));
    }
    place = static_cast<Index>(path.size());
    path.push_back(at);
  }
  for (const Index halfEdge : path)
  {
    this->PlaceOf[this->Graph.Tail(halfEdge)] = None;
  }
  this->AddLoop(std::move(path));
}

Index RegionTracer::MainWalkOf(const std::vector<Index>& halfEdges) const
{
  std::map<Index, double> lengths;
  for (const Index halfEdge : halfEdges)
  {
    const double length = Distance(
      this->Walks.Nodes[this->Graph.Tail(halfEdge)], this->Walks.Nodes[this->Graph.Head(halfEdge)]);
    for (Index i = this->Graph.FirstPassage(halfEdge / 2);
         i < this->Graph.EndOfPassages(halfEdge / 2); ++i)
    {
      lengths[this->Graph.PassageAt(i).Walk] += length;
    }
  }
  return std::max_element(lengths.begin(), lengths.end(),
    [](const auto& a, const auto& b) { return a.second < b.second; })
    ->first;
}

void RegionTracer::AddLoop(std::vector<Index>&& halfEdges)
{
  TracedLoop loop{ std::move(halfEdges), {}, 0 };
  loop.Walk = this->MainWalkOf(loop.HalfEdges);
  for (const Index halfEdge : loop.HalfEdges)
  {
    loop.Points.push_back(this->Walks.Nodes[this->Graph.Head(halfEdge)]);
  }
  this->Loops.push_back(std::move(loop));
}

std::vector<TracedLoop> RegionTracer::Run()
{
  std::vector<std::uint8_t> isDone(this->Graph.CountHalfEdges(), 0);
  for (Index halfEdge = 0; halfEdge < this->Graph.CountHalfEdges(); ++halfEdge)
  {
    if (!isDone[halfEdge] && this->IsBorder(halfEdge))
    {
      this->AddFrom(halfEdge, isDone);
    }
  }
  return std::move(this->Loops);
}
}

std::vector<TracedLoop> TraceRegion(
  const PlaneWalks& walks, const PlaneFaces& faces, const std::vector<std::uint8_t>& inside)
{
  return std::move(TraceRegions(walks, faces, { inside }).front());
}

std::vector<std::vector<TracedLoop>> TraceRegions(const PlaneWalks& walks, const PlaneFaces& faces,
  const std::vector<std::vector<std::uint8_t>>& insides)
{
  std::vector<std::vector<TracedLoop>> regions;
  for (const std::vector<std::uint8_t>& inside : insides)
  {
    regions.push_back(RegionTracer(walks, faces, inside).Run());
  }
  PartTouching(walks, faces, regions);
  return regions;
}
}
