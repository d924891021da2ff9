// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/FitError.h"

#include "Core/Patches/CreasePatch.h"

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

double FitError(const PatchTables& tables, const Execution& execution)
{
  // A hundredth of all may have half of the sum of squares, so that a few hundred would not do.
  constexpr Index most = 10000;
  // Neither which patches are measured nor the sum depends on the order of the contours.
  const CellCycles& cycles = tables.Geometry.Cycles;
  const std::uint64_t step = 1 + cycles.Count() / most;
  std::vector<Index> chosen;
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    if (ShuffledNumber(cycles.Cell[cycle]) % step == 0)
    {
      chosen.push_back(cycle);
    }
  }
  std::vector<double> squares(chosen.size(), -1.0); // of those that tell
  execution.For(chosen.size(),
    [&](std::size_t begin, std::size_t end)
    {
      SmoothPatchBuilder builder(tables.Geometry.Grid, PatchResolution());
      PatchBorder border;
      InnerPatch crease;
      for (std::size_t i = begin; i < end; ++i)
      {
        border.Set(tables.Geometry, tables.Normals, chosen[i]);
        border.Turn();
        double deviation = builder.Fit(border) ? builder.Deviation() : HUGE_VAL;
        if (HasCorner(border, tables.Normals.Corners))
        {
          const double ofCrease =
            BuildCreasePatch(tables.Geometry.Grid, border, tables.Normals.Corners, crease);
          deviation = ofCrease < deviation ? ofCrease : deviation;
        }
        if (std::isfinite(deviation))
        {
          squares[i] = deviation * deviation;
        }
      }
    });
  squares.erase(std::remove(squares.begin(), squares.end(), -1.0), squares.end());
  std::sort(squares.begin(), squares.end());
  const double sum = std::accumulate(squares.begin(), squares.end(), 0.0);
  return squares.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(squares.size()));
}
}
