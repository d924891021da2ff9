// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/CommonCells.h"

#include "Core/Labels/CellOfStructures.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Numbers the slabs of all structures by the planes of all of them.
class CommonSlabs
{
public:
  explicit CommonSlabs(const std::vector<StructureSurface>& structures)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      std::vector<double>& planes = this->Planes[axis];
      for (const StructureSurface& structure : structures)
      {
        const std::vector<double>& own = structure.Geometry.Grid.Planes[axis];
        planes.insert(planes.end(), own.begin(), own.end());
      }
      std::sort(planes.begin(), planes.end());
      planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    }
  }

  /// The cell of all structures at the lower end of a cell of one of them; at the upper end of
  /// outermost ones that have none.
  std::array<Index, 3> CellOf(const SpatialGrid& grid, const std::array<Index, 3>& cell) const
  {
    std::array<Index, 3> common{ 0, 0, 0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      if (grid.Count(axis) > 0)
      {
        const Index plane = std::max<Index>(cell[axis] - 1, 0);
        common[axis] = this->NumberOf(axis, grid.Planes[axis][plane]) + (cell[axis] > 0 ? 1 : 0);
      }
    }
    return common;
  }

private:
  Index NumberOf(int axis, double plane) const
  {
    const std::vector<double>& planes = this->Planes[axis];
    return static_cast<Index>(
      std::lower_bound(planes.begin(), planes.end(), plane) - planes.begin());
  }

  std::array<std::vector<double>, 3> Planes;
};

/// A cycle of a structure in a cell of all structures.
struct CellMember
{
  std::array<Index, 3> Cell;
  StructureCycle Cycle;
};

bool operator<(const CellMember& a, const CellMember& b)
{
  return a.Cell != b.Cell                    ? a.Cell < b.Cell
    : a.Cycle.Structure != b.Cycle.Structure ? a.Cycle.Structure < b.Cycle.Structure
                                             : a.Cycle.Cycle < b.Cycle.Cycle;
}

/// The cycles of all structures, ordered by cell.
std::vector<CellMember> ListMembers(const std::vector<StructureSurface>& structures)
{
  const CommonSlabs slabs(structures);
  std::vector<CellMember> members;
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    const CycleGeometry& geometry = structures[i].Geometry;
    for (Index cycle = 0; cycle < geometry.Cycles.Count(); ++cycle)
    {
      members.push_back({ slabs.CellOf(geometry.Grid, geometry.Cycles.Cell[cycle]),
        { static_cast<Index>(i), cycle } });
    }
  }
  std::sort(members.begin(), members.end());
  return members;
}

/// The cycles of the cells through which several structures pass, each ascending.
std::vector<std::vector<StructureCycle>> ListCommonCells(
  const std::vector<StructureSurface>& structures)
{
  const std::vector<CellMember> members = ListMembers(structures);
  std::vector<std::vector<StructureCycle>> cells;
  for (std::size_t first = 0, last = 0; first < members.size(); first = last)
  {
    std::vector<StructureCycle> cycles;
    for (; last < members.size() && members[last].Cell == members[first].Cell; ++last)
    {
      cycles.push_back(members[last].Cycle);
    }
    if (cycles.front().Structure != cycles.back().Structure)
    {
      cells.push_back(std::move(cycles));
    }
  }
  return cells;
}

/// For each structure, the mesh of each cycle, or -1.
std::vector<std::vector<Index>> NumberMeshes(const std::vector<StructureSurface>& structures)
{
  std::vector<std::vector<Index>> meshOf;
  for (const StructureSurface& structure : structures)
  {
    meshOf.emplace_back(structure.Geometry.Cycles.Count(), -1);
    for (std::size_t i = 0; i < structure.Surface.Meshes.size(); ++i)
    {
      for (const Index cycle : structure.Surface.Meshes[i].Cycles)
      {
        meshOf.back()[cycle] = static_cast<Index>(i);
      }
    }
  }
  return meshOf;
}

/// Gives cycles, ascending, new patches.
void ReplacePatches(const std::vector<NewPatch>& made, StructureSurface structure)
{
  if (made.empty())
  {
    return;
  }
  Patches& surface = structure.Surface;
  InnerPatches inner;
  std::vector<std::uint8_t> isNew(structure.Geometry.Cycles.Count(), 0);
  auto next = made.begin();
  const auto addNewBefore = [&](Index cycle)
  {
    for (; next != made.end() && next->Cycle.Cycle < cycle; ++next)
    {
      inner.Add(next->Cycle.Cycle, next->Patch);
    }
  };
  for (const NewPatch& patch : made)
  {
    isNew[patch.Cycle.Cycle] = 1;
  }
  for (Index i = 0; i < surface.Inner.Count(); ++i)
  {
    if (isNew[surface.Inner.Cycle[i]] == 0)
    {
      addNewBefore(surface.Inner.Cycle[i]);
      inner.Add(surface.Inner, i);
    }
  }
  addNewBefore(structure.Geometry.Cycles.Count());
  surface.Inner = std::move(inner);
  surface.Meshes.erase(std::remove_if(surface.Meshes.begin(), surface.Meshes.end(),
                         [&](const PatchMesh& mesh) { return isNew[mesh.Cycles.front()] != 0; }),
    surface.Meshes.end());
  LayOutTriangles(structure.Geometry.Graph, structure.Geometry.Cycles, surface);
}
}

CommonCellCounts SettleCommonCells(const std::vector<StructureSurface>& structures,
  const PatchOptions& options, const Execution& execution)
{
  const std::vector<std::vector<StructureCycle>> cells = ListCommonCells(structures);
  const StructureTables tables{ structures, NumberMeshes(structures), options };
  std::vector<SettledCell> settled(cells.size());
  execution.For(cells.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        settled[i] = SettleCell(tables, cells[i]);
      }
    });
  CommonCellCounts counts;
  counts.Common = static_cast<Index>(cells.size());
  std::vector<std::vector<NewPatch>> made(structures.size());
  for (SettledCell& cell : settled)
  {
    counts.Settled += cell.Patches.empty() ? 0 : 1;
    counts.Unsettled += cell.IsSettled ? 0 : 1;
    for (NewPatch& patch : cell.Patches)
    {
      made[patch.Cycle.Structure].push_back(std::move(patch));
    }
  }
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    std::sort(made[i].begin(), made[i].end(),
      [](const NewPatch& a, const NewPatch& b) { return a.Cycle.Cycle < b.Cycle.Cycle; });
    ReplacePatches(made[i], structures[i]);
  }
  return counts;
}
}
