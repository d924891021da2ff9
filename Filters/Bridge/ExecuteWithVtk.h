// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesExecuteWithVtk_h
#define OrthoSlicesExecuteWithVtk_h

#include "Core/Base/Execution.h"

class vtkAlgorithm;

namespace orthoslices
{
/**
 * The threads that a filter may use: as many as vtkSMPTools would. Where VTK was built to run its
 * loops in one thread by default, and nobody has asked for that, as many as there are processors
 * for this process; the limits of vtkSMPTools::Initialize and VTK_SMP_MAX_THREADS hold in any case.
 * 1 within a parallel loop of VTK.
 */
int NumberOfThreads();

/// Loops run on NumberOfThreads threads. Progress and the words for what is being done are the
/// filter's, as are requests to abort. The filter must outlive the execution.
Execution ExecuteWithVtk(vtkAlgorithm* filter);

/// The same, for one loop, which is the progress from the first value to the last one. Loops throw
/// Stopped upon a request to abort.
Execution ExecuteLoop(vtkAlgorithm* filter, double firstProgress, double lastProgress);

/// The same, for any number of loops, one after another: each has the same share of what the ones
/// before it have left of the progress from the first value to the last one.
Execution ExecuteLoops(vtkAlgorithm* filter, double firstProgress, double lastProgress);

/// Progress within a share of the whole, for as long as this lives.
class ShareOfProgress
{
public:
  ShareOfProgress(vtkAlgorithm* filter, double first, double share);
  ~ShareOfProgress();
  ShareOfProgress(const ShareOfProgress&) = delete;
  void operator=(const ShareOfProgress&) = delete;

private:
  vtkAlgorithm* Filter;
  double Shift, Scale; ///< of the filter before
};
}

#endif
