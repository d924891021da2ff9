// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/DivideCycles.h"

#include <algorithm>
#include <iterator>

namespace orthoslices
{
namespace
{
/// The work that a polygon is besides that of its border, in points of this: about as many triangles
/// lie inside.
constexpr double WorkInside = 12.0;
}

Portion DivideCycles(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes, const Ranks& ranks)
{
  const CellCycles& cycles = geometry.Cycles;
  std::vector<double> work(static_cast<std::size_t>(cycles.Count()), WorkInside);
  for (const PatchMesh& mesh : meshes)
  {
    for (const Index cycle : mesh.Cycles)
    {
      work[cycle] = 0.0;
    }
  }
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    for (Index i = cycles.Offsets[cycle]; i < cycles.Offsets[cycle + 1]; ++i)
    {
      work[cycle] += 1.0 + geometry.Graph.PointCount(cycles.Arcs[i].Arc);
    }
  }
  for (const PatchMesh& mesh : meshes)
  {
    for (std::size_t k = 1; k < mesh.Cycles.size(); ++k)
    {
      work[mesh.Cycles.front()] += work[mesh.Cycles[k]];
      work[mesh.Cycles[k]] = 0.0;
    }
  }
  return PortionOf(ranks, work.size(), [&](std::size_t cycle) { return work[cycle]; });
}

ChosenCycles::ChosenCycles(const CellGroups& cells, std::size_t count, const Portion* part)
  : AllCells(cells)
  , Part(part)
{
  if (part == nullptr)
  {
    return;
  }
  this->IsChosen.assign(count, 0);
  std::fill(this->IsChosen.begin() + static_cast<std::ptrdiff_t>(part->First),
    this->IsChosen.begin() + static_cast<std::ptrdiff_t>(part->Last), std::uint8_t(1));
  this->OwnCells.Cycles = cells.Cycles;
  for (const std::pair<Index, Index>& range : cells.Several)
  {
    const auto first = cells.Cycles.begin() + range.first;
    const auto last = cells.Cycles.begin() + range.second;
    if (std::any_of(
          first, last, [&](Index cycle) { return part->Has(static_cast<std::size_t>(cycle)); }))
    {
      this->OwnCells.Several.push_back(range);
      std::for_each(first, last, [&](Index cycle) { this->IsChosen[cycle] = 1; });
    }
  }
}

void ChosenCycles::LeaveOutOthers(InnerPatches& patches) const
{
  const auto isOther = [&](Index cycle)
  { return !this->Part->Has(static_cast<std::size_t>(cycle)); };
  if (this->Part == nullptr || std::none_of(patches.Cycle.begin(), patches.Cycle.end(), isOther))
  {
    return;
  }
  InnerPatches own;
  for (Index i = 0; i < patches.Count(); ++i)
  {
    if (!isOther(patches.Cycle[i]))
    {
      own.Add(patches, i);
    }
  }
  patches = std::move(own);
}

namespace
{
/// The offsets of all processes, one behind the other, each of which begin with 0.
std::vector<std::int64_t> JoinOffsets(const Ranks& ranks, const std::vector<std::int64_t>& own)
{
  std::vector<std::int64_t> joined{ 0 };
  for (const std::vector<std::int64_t>& offsets : GatherValues(ranks, own))
  {
    const std::int64_t before = joined.back();
    std::transform(offsets.begin() + 1, offsets.end(), std::back_inserter(joined),
      [&](std::int64_t offset) { return before + offset; });
  }
  return joined;
}
}

InnerPatches JoinParts(const Ranks& ranks, const InnerPatches& own)
{
  InnerPatches all;
  all.Cycle = JoinValues(ranks, own.Cycle);
  all.PointOffsets = JoinOffsets(ranks, own.PointOffsets);
  all.TriangleOffsets = JoinOffsets(ranks, own.TriangleOffsets);
  all.Points = JoinValues(ranks, own.Points);
  all.Normals = JoinValues(ranks, own.Normals);
  all.Corners = JoinValues(ranks, own.Corners);
  return all;
}

namespace
{
/// The cycle under which the patch of each cycle is filed.
std::vector<Index> FindOwners(Index count, const std::vector<PatchMesh>& meshes)
{
  std::vector<Index> owners(count);
  for (Index cycle = 0; cycle < count; ++cycle)
  {
    owners[cycle] = cycle;
  }
  for (const PatchMesh& mesh : meshes)
  {
    for (const Index cycle : mesh.Cycles)
    {
      owners[cycle] = mesh.Cycles.front();
    }
  }
  return owners;
}
}

std::vector<std::uint8_t> FindPartsOfPoints(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes, const Portion& part)
{
  const CellCycles& cycles = geometry.Cycles;
  const NodeGraph& graph = geometry.Graph;
  const std::vector<Index> owners = FindOwners(cycles.Count(), meshes);
  std::vector<std::uint8_t> ofPoints(graph.Count(), 0), ofArcs(graph.Offsets.size() - 1, 0);
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    const std::size_t owner = static_cast<std::size_t>(owners[cycle]);
    if (part.Has(owner))
    {
      continue;
    }
    const std::uint8_t side = owner < part.First ? BeforePart : AfterPart;
    for (Index i = cycles.Offsets[cycle]; i < cycles.Offsets[cycle + 1]; ++i)
    {
      const HalfArc& half = cycles.Arcs[i];
      ofArcs[half.Arc] |= side;
      if (!graph.IsLoop(half.Arc))
      {
        ofPoints[StartNode(geometry.Crossings, geometry.Nodes, half)] |= side;
      }
    }
  }
  for (Index arc = 0; arc < static_cast<Index>(ofArcs.size()); ++arc)
  {
    std::fill_n(ofPoints.begin() + graph.FirstPoint(arc), graph.PointCount(arc), ofArcs[arc]);
  }
  return ofPoints;
}
}
