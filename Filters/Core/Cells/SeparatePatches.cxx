// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/SeparatePatches.h"

#include "Core/Cells/CellPatches.h"

#include <algorithm>

namespace orthoslices
{
PatchSeparator::PatchSeparator(const CycleGeometry& geometry, const CellGroups& cells,
  const std::vector<double>& centralPoints, const std::vector<PatchMesh>& stitched, bool atAnyPrice)
  : Geometry(geometry)
  , Groups(cells)
  , CentralPoints(centralPoints)
  , Stitched(stitched)
{
  const SpatialGrid& grid = geometry.Grid;
  const int open =
    (grid.Count(0) == 0 ? 1 : 0) + (grid.Count(1) == 0 ? 1 : 0) + (grid.Count(2) == 0 ? 1 : 0);
  this->MayShell = atAnyPrice || open < 2;
}

PatchSeparator::~PatchSeparator() = default;

/// The joins of the cells are in the same order as these.
void PatchSeparator::ListCells(const std::vector<CycleJoin>& joins)
{
  const CellCycles& cycles = this->Geometry.Cycles;
  std::size_t next = 0;
  for (const auto& range : this->Groups.Several)
  {
    const Index* inOrder = this->Groups.Cycles.data();
    const auto& cell = cycles.Cell[inOrder[range.first]];
    const std::size_t firstJoin = next;
    while (next < joins.size() && cycles.Cell[joins[next].First] == cell)
    {
      ++next;
    }
    this->Cells.emplace_back(inOrder + range.first, inOrder + range.second, firstJoin, next);
  }
}

bool PatchSeparator::Run(const Execution& execution, std::vector<CycleJoin>& joins)
{
  if (this->Cells.empty())
  {
    this->ListCells(joins);
  }
  const PatchSource source{ this->Geometry, this->CentralPoints, StitchedPatches(this->Stitched),
    this->MayShell };
  execution.For(this->Cells.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Cells[i].Run(source, joins);
      }
    });
  return std::none_of(this->Cells.begin(), this->Cells.end(),
    [](const CellPatches& cell) { return cell.IsUndone(); });
}

std::vector<Index> PatchSeparator::Unresolved() const
{
  std::vector<Index> cycles;
  for (const CellPatches& cell : this->Cells)
  {
    if (cell.IsUnresolved())
    {
      cycles.insert(cycles.end(), cell.begin(), cell.end());
    }
  }
  return cycles;
}

void PatchSeparator::Forget(const std::vector<Index>& cycles, std::vector<CycleJoin>& joins)
{
  std::vector<Index> ascending = cycles;
  std::sort(ascending.begin(), ascending.end());
  for (CellPatches& cell : this->Cells)
  {
    if (std::any_of(cell.begin(), cell.end(),
          [&](Index cycle)
          { return std::binary_search(ascending.begin(), ascending.end(), cycle); }))
    {
      cell.Forget(joins);
    }
  }
}

SeparatedPatches PatchSeparator::Take()
{
  SeparatedPatches result;
  result.SharedCells = static_cast<Index>(this->Cells.size());
  result.Unresolved = this->Unresolved();
  for (CellPatches& cell : this->Cells)
  {
    cell.MoveTo(result.Meshes);
  }
  this->Cells.clear();
  std::sort(result.Meshes.begin(), result.Meshes.end(),
    [](const PatchMesh& a, const PatchMesh& b) { return a.Cycles.front() < b.Cycles.front(); });
  return result;
}
}
