// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/ExecuteWithVtk.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Batches of one loop: often enough for a progress bar.
constexpr vtkIdType Batches = 4;
}

Execution ExecuteWithVtk(vtkAlgorithm* filter)
{
  Execution execution;
  execution.For = [](std::size_t count, const Execution::Range& run)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(count),
      [&run](vtkIdType begin, vtkIdType end) { run(begin, end); });
  };
  execution.Continue = [filter](double progress)
  {
    filter->UpdateProgress(progress);
    return !filter->GetAbortExecute();
  };
  return execution;
}

Execution ExecuteInBatches(vtkAlgorithm* filter, double firstProgress, double lastProgress)
{
  Execution execution;
  execution.For = [=](std::size_t count, const Execution::Range& run)
  {
    const vtkIdType total = static_cast<vtkIdType>(count);
    const vtkIdType batch = std::max<vtkIdType>(1, (total + Batches - 1) / Batches);
    const vtkIdType threads = vtkSMPTools::GetEstimatedNumberOfThreads();
    const vtkIdType grain = std::max<vtkIdType>(1, batch / std::max<vtkIdType>(1, threads));
    for (vtkIdType begin = 0; begin < total && !filter->GetAbortExecute(); begin += batch)
    {
      const vtkIdType end = std::min(total, begin + batch);
      vtkSMPTools::For(begin, end, grain,
        [&run](vtkIdType first, vtkIdType last)
        { run(static_cast<std::size_t>(first), static_cast<std::size_t>(last)); });
      filter->UpdateProgress(firstProgress + (lastProgress - firstProgress) * end / total);
    }
  };
  return execution;
}
}
