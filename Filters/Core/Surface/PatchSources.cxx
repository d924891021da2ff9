// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/PatchSources.h"

#include <algorithm>
#include <array>
#include <utility>

namespace orthoslices
{
namespace
{
constexpr std::int64_t None = -1;

/// Finds the sources of patches. A patch has the number of its first cycle.
class SourceFinder
{
public:
  SourceFinder(const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes,
    const std::vector<std::int64_t>& sources);

  void Choose(Index patch);
  void Spread();
  std::vector<std::int64_t> List() const;

private:
  /// Calls the function with each half-arc around a patch.
  template <typename Visit>
  void VisitArcs(Index patch, Visit&& visit) const;
  double LengthOf(Index arc) const;

  const CycleGeometry& Geometry;
  const std::vector<PatchMesh>& Meshes;
  const std::vector<std::int64_t>& Sources;
  std::vector<Index> PatchOf;        ///< each cycle
  std::vector<Index> MeshOf;         ///< of each patch in Meshes, or -1
  std::vector<std::int64_t> OfPatch; ///< what is found
};

SourceFinder::SourceFinder(const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes,
  const std::vector<std::int64_t>& sources)
  : Geometry(geometry)
  , Meshes(meshes)
  , Sources(sources)
  , PatchOf(geometry.Cycles.Count())
  , MeshOf(geometry.Cycles.Count(), -1)
  , OfPatch(geometry.Cycles.Count(), None)
{
  for (Index cycle = 0; cycle < geometry.Cycles.Count(); ++cycle)
  {
    this->PatchOf[cycle] = cycle;
  }
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
  {
    const Index first = meshes[mesh].Cycles.front();
    this->MeshOf[first] = static_cast<Index>(mesh);
    for (const Index cycle : meshes[mesh].Cycles)
    {
      this->PatchOf[cycle] = first;
    }
  }
}

template <typename Visit>
void SourceFinder::VisitArcs(Index patch, Visit&& visit) const
{
  const CellCycles& cycles = this->Geometry.Cycles;
  const Index mesh = this->MeshOf[patch];
  const Index* const begin = mesh < 0 ? &patch : this->Meshes[mesh].Cycles.data();
  const Index* const end = begin + (mesh < 0 ? 1 : this->Meshes[mesh].Cycles.size());
  for (const Index* cycle = begin; cycle != end; ++cycle)
  {
    for (Index i = cycles.Offsets[*cycle]; i < cycles.Offsets[*cycle + 1]; ++i)
    {
      visit(cycles.Arcs[i]);
    }
  }
}

double SourceFinder::LengthOf(Index arc) const
{
  const NodeGraph& graph = this->Geometry.Graph;
  const Index first = graph.FirstPoint(arc), count = graph.PointCount(arc);
  const bool isLoop = graph.IsLoop(arc);
  const NodePoints& nodes = this->Geometry.Nodes;
  Point3 from = graph.PointAt(isLoop ? first + count - 1 : nodes.NodeOf[arc]);
  double length = 0.0;
  const auto goTo = [&](const Point3& to)
  {
    length += Length(to - from);
    from = to;
  };
  for (Index i = 0; i < count; ++i)
  {
    goTo(graph.PointAt(first + i));
  }
  if (!isLoop)
  {
    goTo(graph.PointAt(nodes.NodeOf[this->Geometry.Crossings.Next[arc]]));
  }
  return length;
}

void SourceFinder::Choose(Index patch)
{
  if (this->PatchOf[patch] != patch)
  {
    return;
  }
  std::vector<std::pair<std::int64_t, double>> parts;
  this->VisitArcs(patch,
    [&](const HalfArc& half)
    {
      if (this->Sources[half.Arc] >= 0)
      {
        parts.emplace_back(this->Sources[half.Arc], this->LengthOf(half.Arc));
      }
    });
  std::sort(parts.begin(), parts.end());
  double longest = -1.0;
  for (auto part = parts.begin(); part != parts.end();)
  {
    const std::int64_t source = part->first;
    double length = 0.0;
    for (; part != parts.end() && part->first == source; ++part)
    {
      length += part->second;
    }
    if (length > longest)
    {
      longest = length;
      this->OfPatch[patch] = source;
    }
  }
}

void SourceFinder::Spread()
{
  std::vector<Index> front;
  bool isComplete = true;
  for (Index patch = 0; patch < this->Geometry.Cycles.Count(); ++patch)
  {
    const bool has = this->OfPatch[patch] >= 0;
    isComplete = isComplete && (has || this->PatchOf[patch] != patch);
    if (has)
    {
      front.push_back(patch);
    }
  }
  if (isComplete || front.empty())
  {
    return;
  }
  std::vector<std::array<Index, 2>> sides(this->Sources.size()); // the patches of each arc
  const CellCycles& cycles = this->Geometry.Cycles;
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    for (Index i = cycles.Offsets[cycle]; i < cycles.Offsets[cycle + 1]; ++i)
    {
      sides[cycles.Arcs[i].Arc][cycles.Arcs[i].Above ? 1 : 0] = this->PatchOf[cycle];
    }
  }
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    const Index patch = front[i];
    this->VisitArcs(patch,
      [&](const HalfArc& half)
      {
        const Index other = sides[half.Arc][half.Above ? 0 : 1];
        if (this->OfPatch[other] < 0)
        {
          this->OfPatch[other] = this->OfPatch[patch];
          front.push_back(other);
        }
      });
  }
}

std::vector<std::int64_t> SourceFinder::List() const
{
  std::vector<std::int64_t> list;
  list.reserve(this->PatchOf.size());
  for (const Index patch : this->PatchOf)
  {
    list.push_back(this->OfPatch[patch]);
  }
  return list;
}
}

std::vector<std::int64_t> FindPatchSources(const CycleGeometry& geometry,
  const std::vector<PatchMesh>& meshes, const std::vector<std::int64_t>& sources,
  const Execution& execution)
{
  SourceFinder finder(geometry, meshes, sources);
  execution.For(static_cast<std::size_t>(geometry.Cycles.Count()),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t patch = begin; patch < end; ++patch)
      {
        finder.Choose(static_cast<Index>(patch));
      }
    });
  finder.Spread();
  return finder.List();
}
}
