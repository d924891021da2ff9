// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesWriteComponents_h
#define OrthoSlicesWriteComponents_h

#include "Core/Base/Execution.h"
#include "Core/Base/Ranks.h"

class vtkPolyData;
class vtkTable;

namespace orthoslices
{
/// Port 7: area, volume, centroid and seed of each component of the finished surface, which is closed
/// unless it `mayBeOpen`, and of which all `ranks` have a piece.
/// REQUIRES: cell data "ComponentId" and field data "NumberOfComponents".
void WriteComponentTable(vtkPolyData* surface, bool mayBeOpen, const Ranks& ranks,
  const Execution& execution, vtkTable* table);
}

#endif
