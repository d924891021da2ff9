// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesGatherInputs_h
#define OrthoSlicesGatherInputs_h

#include "Core/Base/Ranks.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;

namespace orthoslices
{
/**
 * Gives all processes the contours of all: the inputs of all ports as one process would have them.
 * Contours of one block stand in the order of the processes; blocks have the flat indices that they
 * have in each. Points, cells, cell arrays and field data are those of the processes; of field data
 * with one name, those of the first process that has it. What a process has the same, bit by bit, as one before
 * it is a source that does not divide its output, and counts once.
 */
std::vector<vtkSmartPointer<vtkDataObject>> GatherInputs(
  const std::vector<vtkDataObject*>& inputs, const Ranks& ranks);
}

#endif
