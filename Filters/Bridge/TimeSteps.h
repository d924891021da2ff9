// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTimeSteps_h
#define OrthoSlicesTimeSteps_h

#include <vector>

class vtkDataObject;
class vtkInformationVector;

namespace orthoslices
{
/// Tells the pipeline that the outputs have the time steps of the inputs of all ports together, and
/// the range of all of these. By itself the pipeline asks the first port only, which may be empty.
void DeclareTimeSteps(vtkInformationVector** inputs, int inputPorts, vtkInformationVector* outputs);

/// Marks the outputs with the time of the first input that has one.
void MarkTime(const std::vector<vtkDataObject*>& inputs, vtkInformationVector* outputs);
}

#endif
