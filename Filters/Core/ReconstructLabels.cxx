// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ReconstructLabels.h"

#include "Core/LabelRunner.h"

#include <utility>

namespace orthoslices
{
LabelSurfaces ReconstructLabels(
  std::vector<SortedSlices>&& labels, const Options& options, const Execution& execution)
{
  LabelSurfaces surfaces;
  LabelRunner runner(labels, options, execution);
  try
  {
    surfaces.Stopped = !runner.Run();
  }
  catch (const Stopped&)
  {
    surfaces.Stopped = true;
  }
  if (surfaces.Stopped)
  {
    return surfaces;
  }
  surfaces.OfLabel = runner.TakeResults();
  surfaces.Cells = runner.Counts;
  surfaces.Overlaps = runner.FindOverlaps();
  surfaces.Losses = runner.FindLosses();
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    ReturnToWorld(std::move(labels[i]), surfaces.OfLabel[i]);
  }
  return surfaces;
}
}
