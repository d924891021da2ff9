// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/FitError.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// A number from 0 on that a cell always has, whatever other cells there are.
std::uint64_t ShuffledNumber(const std::array<Index, 3>& cell)
{
  std::uint64_t hash = 0;
  for (const Index slab : cell)
  {
    hash = (hash + static_cast<std::uint64_t>(slab) + 1) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return hash >> 16;
}
}

double FitError(const PatchTables& tables)
{
  constexpr Index most = 400; // the error of their mean is a twentieth
  SmoothPatchBuilder builder(tables.Geometry.Grid, PatchResolution());
  PatchBorder border;
  // Neither which patches are measured nor the sum depends on the order of the contours.
  std::vector<double> squares;
  const CellCycles& cycles = tables.Geometry.Cycles;
  const std::uint64_t step = 1 + cycles.Count() / most;
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    if (ShuffledNumber(cycles.Cell[cycle]) % step == 0)
    {
      border.Set(tables.Geometry, tables.Normals, cycle);
      border.Turn();
      if (builder.Fit(border))
      {
        squares.push_back(builder.Deviation() * builder.Deviation());
      }
    }
  }
  std::sort(squares.begin(), squares.end());
  const double sum = std::accumulate(squares.begin(), squares.end(), 0.0);
  return squares.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(squares.size()));
}
}
