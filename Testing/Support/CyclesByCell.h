// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the cycles of cells that have several, before anything is joined
 */

#ifndef OrthoSlicesCyclesByCell_h
#define OrthoSlicesCyclesByCell_h

#include "Core/Reconstruct.h"
#include "Support/TextContours.h"

#include <map>
#include <vector>

namespace orthoslices
{
namespace support
{

/// With every cycle filled by a disc of its own.
inline Reconstruction RunDiscs(const PieceSets& sets)
{
  Options options;
  options.Orient = Orientation::AsDrawn;
  options.Several = SeveralCycles::Discs;
  return Reconstruct(PieceSets(sets), options, Execution());
}

/// The cycles of each cell with two or more of them.
inline std::map<std::array<Index, 3>, std::vector<Index>> CyclesByCell(const Reconstruction& result)
{
  std::map<std::array<Index, 3>, std::vector<Index>> cells;
  for (Index cycle = 0; cycle < result.Cycles.Count(); ++cycle)
  {
    cells[result.Cycles.Cell[cycle]].push_back(cycle);
  }
  for (auto cell = cells.begin(); cell != cells.end();)
  {
    cell = cell->second.size() < 2 ? cells.erase(cell) : std::next(cell);
  }
  return cells;
}

/// The cycles in the slab above plane 0 of z, which must be those of one cell.
inline std::vector<Index> CyclesAbove(const Reconstruction& result)
{
  std::vector<Index> cycles;
  for (Index cycle = 0; cycle < result.Cycles.Count(); ++cycle)
  {
    if (result.Cycles.Cell[cycle][2] == 1)
    {
      cycles.push_back(cycle);
    }
  }
  return cycles;
}

} // namespace support
} // namespace orthoslices

#endif
