// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/RemoveTouching.h"

#include "Core/Cells/FindContacts.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Finds the patches with points inside that touch others of their cell.
class TouchFinder
{
public:
  TouchFinder(
    const PatchTables& tables, const std::vector<Index>& meshOf, const InnerPatches& patches)
    : Tables(tables)
    , MeshOf(meshOf)
    , Patches(patches)
  {
  }

  /// Their numbers in the list of patches, for the cycles of one cell; one may appear repeatedly.
  std::vector<Index> Find(const Index* first, const Index* last) const;

private:
  Index AddTo(CellTriangles& all, Index cycle) const;

  const PatchTables& Tables;
  const std::vector<Index>& MeshOf;
  const InnerPatches& Patches;
};

/// Adds the patch of a cycle, or the one of several cycles that this is the first of. Returns the
/// patch's number in the list of those with points inside, or -1 if it is no such patch.
Index TouchFinder::AddTo(CellTriangles& all, Index cycle) const
{
  const InnerPatches& patches = this->Patches;
  const auto number = std::lower_bound(patches.Cycle.begin(), patches.Cycle.end(), cycle);
  if (number != patches.Cycle.end() && *number == cycle)
  {
    const std::size_t i = static_cast<std::size_t>(number - patches.Cycle.begin());
    const std::int64_t* points = patches.PointOffsets.data() + i;
    const std::int64_t* triangles = patches.TriangleOffsets.data() + i;
    all.AddPatch(PatchKind::Fan, { cycle },
      { patches.Points.data() + 3 * points[0], static_cast<std::size_t>(points[1] - points[0]),
        patches.Corners.data() + 3 * triangles[0],
        static_cast<std::size_t>(triangles[1] - triangles[0]) });
    return static_cast<Index>(i);
  }
  const Index mesh = this->MeshOf[cycle];
  if (mesh >= 0)
  {
    all.AddMesh(this->Tables.Meshes[mesh]);
    // It is known by now not to touch itself.
    all.Kinds.back() = PatchKind::Fan;
  }
  else
  {
    all.AddFan(cycle, this->Tables.CentralPoint(cycle));
  }
  return -1;
}

std::vector<Index> TouchFinder::Find(const Index* first, const Index* last) const
{
  CellTriangles all(this->Tables.Geometry);
  std::vector<Index> inner; // of each patch of the cell, its number, or -1
  for (const Index* cycle = first; cycle != last; ++cycle)
  {
    const Index mesh = this->MeshOf[*cycle];
    if (mesh < 0 || this->Tables.Meshes[mesh].Cycles.front() == *cycle)
    {
      inner.push_back(this->AddTo(all, *cycle));
    }
  }
  std::vector<Index> touching;
  for (const auto& contact : FindContacts(all.Triangles, all.Kinds))
  {
    for (const Index patch : { contact.first, contact.second })
    {
      if (inner[patch] >= 0)
      {
        touching.push_back(inner[patch]);
      }
    }
  }
  return touching;
}

/// The patches that are not marked.
InnerPatches WithoutMarked(const InnerPatches& patches, const std::vector<std::uint8_t>& isMarked)
{
  InnerPatches others;
  for (Index i = 0; i < patches.Count(); ++i)
  {
    if (isMarked[i] == 0)
    {
      others.Add(patches, i);
    }
  }
  return others;
}
}

void RemoveTouching(const PatchTables& tables, const std::vector<Index>& meshOf,
  const Execution& execution, InnerPatches& patches)
{
  std::vector<std::pair<Index, Index>> ranges = tables.Cells.Several;
  while (!ranges.empty())
  {
    const TouchFinder finder(tables, meshOf, patches);
    std::vector<std::vector<Index>> touching(ranges.size());
    execution.For(ranges.size(),
      [&](std::size_t begin, std::size_t end)
      {
        const Index* cycles = tables.Cells.Cycles.data();
        for (std::size_t i = begin; i < end; ++i)
        {
          touching[i] = finder.Find(cycles + ranges[i].first, cycles + ranges[i].second);
        }
      });
    std::vector<std::pair<Index, Index>> again;
    std::vector<std::uint8_t> isOut(patches.Cycle.size(), 0);
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
      for (const Index patch : touching[i])
      {
        isOut[patch] = 1;
      }
      if (!touching[i].empty())
      {
        again.push_back(ranges[i]);
      }
    }
    if (!again.empty())
    {
      patches = WithoutMarked(patches, isOut);
    }
    ranges = std::move(again);
  }
}
}
