// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesWriteGraph_h
#define OrthoSlicesWriteGraph_h

#include "Core/Base/Execution.h"

class vtkPolyData;

namespace orthoslices
{
struct Reconstruction;

/// Port 1: the graph G, the repairs and the isolated contours.
void WriteGraph(const Reconstruction& result, const Execution& execution, bool doublePrecision,
  vtkPolyData* graph);
}

#endif
