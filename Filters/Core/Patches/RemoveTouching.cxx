// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/RemoveTouching.h"

#include "Core/Cells/PatchMesh.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// All triangles of the patches of one cell.
struct CellTriangles
{
  std::vector<PatchTriangle> Triangles;
  std::vector<PatchShape> Shapes;
  Index NextId = 0;

  /**
   * Adds a patch that cannot touch itself: `corners(t, k)` is corner k of triangle t, a place on the
   * border or -1 - i for point i of the patch (see PatchMesh), and `at(corner)` its place in space.
   */
  template <typename Corners, typename At>
  void Add(
    Index borderSize, std::size_t points, std::size_t count, const Corners& corners, const At& at)
  {
    const Index patch = static_cast<Index>(this->Shapes.size());
    this->Shapes.push_back(PatchShape::Fan);
    for (std::size_t t = 0; t < count; ++t)
    {
      std::array<Point3, 3> places;
      std::array<Index, 3> ids;
      for (int k = 0; k < 3; ++k)
      {
        const Index corner = corners(t, k);
        places[k] = at(corner);
        ids[k] = this->NextId + (corner >= 0 ? corner : borderSize - 1 - corner);
      }
      this->Triangles.emplace_back(patch, places, ids);
    }
    this->NextId += borderSize + static_cast<Index>(points);
  }
};

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
  const CycleGeometry& geometry = this->Tables.Geometry;
  const InnerPatches& patches = this->Patches;
  const Index mesh = this->MeshOf[cycle];
  const std::vector<Index> border =
    geometry.GetBorders(mesh >= 0 ? this->Tables.Meshes[mesh].Cycles : std::vector<Index>{ cycle });
  const Index size = static_cast<Index>(border.size());
  const auto number = std::lower_bound(patches.Cycle.begin(), patches.Cycle.end(), cycle);
  const auto add =
    [&](std::size_t points, std::size_t count, const auto& corners, const auto& pointAt)
  {
    all.Add(size, points, count, corners,
      [&](Index corner)
      { return corner >= 0 ? geometry.Graph.PointAt(border[corner]) : pointAt(-1 - corner); });
  };
  if (number != patches.Cycle.end() && *number == cycle)
  {
    const std::size_t i = static_cast<std::size_t>(number - patches.Cycle.begin());
    const Index* corners = patches.Corners.data() + 3 * patches.TriangleOffsets[i];
    add(
      static_cast<std::size_t>(patches.PointOffsets[i + 1] - patches.PointOffsets[i]),
      static_cast<std::size_t>(patches.TriangleOffsets[i + 1] - patches.TriangleOffsets[i]),
      [&](std::size_t t, int k) { return corners[3 * t + k]; },
      [&](Index point) { return patches.PointAt(patches.PointOffsets[i] + point); });
    return static_cast<Index>(i);
  }
  if (mesh >= 0)
  {
    const PatchMesh& m = this->Tables.Meshes[mesh];
    add(
      m.Points.size(), m.Triangles.size(), [&](std::size_t t, int k) { return m.Triangles[t][k]; },
      [&](Index point) { return m.Points[point]; });
    return -1;
  }
  add(
    1, border.size(),
    [&](std::size_t t, int k)
    { return k == 0 ? -1 : static_cast<Index>((t + (k == 2 ? 1 : 0)) % border.size()); },
    [&](Index) { return this->Tables.CentralPoint(cycle); });
  return -1;
}

std::vector<Index> TouchFinder::Find(const Index* first, const Index* last) const
{
  CellTriangles all;
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
  for (const auto& contact : FindContacts(all.Triangles, all.Shapes))
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
