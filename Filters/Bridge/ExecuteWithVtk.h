// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesExecuteWithVtk_h
#define OrthoSlicesExecuteWithVtk_h

#include "Core/Base/Execution.h"

class vtkAlgorithm;

namespace orthoslices
{
/// Loops run on vtkSMPTools; between the stages the filter reports progress and hears of requests
/// to abort. The filter must outlive the execution.
Execution ExecuteWithVtk(vtkAlgorithm* filter);

/// An execution of one loop over few large items, such as planes, on vtkSMPTools: it runs in a few
/// batches; between them the filter reports progress, from the first to the last value, and hears
/// of requests to abort.
Execution ExecuteInBatches(vtkAlgorithm* filter, double firstProgress, double lastProgress);
}

#endif
