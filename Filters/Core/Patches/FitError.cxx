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

/// The patches that are measured, which do not depend on the order of the contours.
std::vector<Index> ChooseCycles(const CellCycles& cycles)
{
  // A hundredth of all may have half of the sum of squares, so that a few hundred would not do.
  constexpr Index most = 10000;
  const std::uint64_t step = 1 + cycles.Count() / most;
  std::vector<Index> chosen;
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    if (ShuffledNumber(cycles.Cell[cycle]) % step == 0)
    {
      chosen.push_back(cycle);
    }
  }
  return chosen;
}

/// The squared deviations of some patches; -1 of those that do not tell.
std::vector<double> MeasureSquares(const PatchTables& tables, const std::vector<Index>& chosen,
  const Portion& own, const Execution& execution)
{
  std::vector<double> squares(own.Last - own.First, -1.0);
  execution.For(squares.size(),
    [&](std::size_t begin, std::size_t end)
    {
      SmoothPatchBuilder builder(tables.Geometry.Grid, PatchResolution());
      PatchBorder border;
      InnerPatch crease;
      for (std::size_t i = begin; i < end; ++i)
      {
        border.Set(tables.Geometry, tables.Normals, chosen[own.First + i]);
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
  return squares;
}
}

double FitError(const PatchTables& tables, const Execution& execution, const Ranks& ranks)
{
  const std::vector<Index> chosen = ChooseCycles(tables.Geometry.Cycles);
  const Portion own = PortionOf(ranks, chosen.size(), [](std::size_t) { return 1.0; });
  std::vector<double> squares = JoinValues(ranks, MeasureSquares(tables, chosen, own, execution));
  squares.erase(std::remove(squares.begin(), squares.end(), -1.0), squares.end());
  // The sum does not depend on the order of the contours either.
  std::sort(squares.begin(), squares.end());
  const double sum = std::accumulate(squares.begin(), squares.end(), 0.0);
  return squares.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(squares.size()));
}
}
