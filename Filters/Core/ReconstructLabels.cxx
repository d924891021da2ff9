// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ReconstructLabels.h"

#include "Core/Frames/SplitByLabel.h"
#include "Core/Patches/SharedPatches.h"

#include <algorithm>
#include <utility>

namespace orthoslices
{
namespace
{
/// The same with progress within a part of the whole.
Execution ShareOf(const Execution& whole, double from, double to)
{
  Execution part = whole;
  part.Continue = [&whole, from, to](double progress)
  { return whole.Continue(from + (to - from) * progress); };
  return part;
}

/// What the surface of a label can be compared with others by. Refused ones have none.
bool HasSurface(const Reconstruction& result)
{
  return !result.Refused && result.Surface.Offsets.size() > 1;
}

CommonCellCounts SettleCells(std::vector<Reconstruction>& results, const Execution& execution)
{
  std::vector<StructureSurface> structures;
  for (Reconstruction& result : results)
  {
    if (HasSurface(result))
    {
      structures.push_back({ GeometryOf(result), result.Surface });
    }
  }
  return SettleCommonCells(structures, execution);
}
}

LabelSurfaces ReconstructLabels(
  std::vector<SortedSlices>&& labels, const Options& options, const Execution& execution)
{
  SharedPatches shared;
  Options settings = options;
  settings.Patching.Shared = &shared;
  double all = 1.0, before = 0.0;
  for (const SortedSlices& label : labels)
  {
    settings.Quantum =
      std::max(settings.Quantum, ChooseQuantum(label, options.SinglePrecision));
    all += static_cast<double>(CountVertices(label));
  }
  LabelSurfaces surfaces;
  for (SortedSlices& label : labels)
  {
    const double share = static_cast<double>(CountVertices(label)) / all;
    surfaces.OfLabel.push_back(Reconstruct(std::move(label.Slices), settings,
      ShareOf(execution, before, before + share)));
    before += share;
    if (surfaces.OfLabel.back().Stopped)
    {
      surfaces.Stopped = true;
      return surfaces;
    }
  }
  surfaces.Cells = SettleCells(surfaces.OfLabel, execution);
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    ReturnToWorld(std::move(labels[i]), surfaces.OfLabel[i]);
  }
  return surfaces;
}
}
