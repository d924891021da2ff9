// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCarryFieldData_h
#define OrthoSlicesCarryFieldData_h

#include <vector>

class vtkDataObject;
class vtkInformationVector;
class vtkPolyData;

namespace orthoslices
{
/// Takes away the field data that the pipeline has passed on from the first input.
void ClearFieldData(vtkInformationVector* outputs);

/// Leaves nothing in any output.
void ClearOutputs(vtkInformationVector* outputs);

/**
 * Adds the field data of the inputs of all ports, and of the blocks of composite ones, to that of
 * the graph and of the surface. An array that several of them have with the same content is added
 * once. Arrays of one name with different contents get the port before their names, as "X", "Y",
 * "Z" and "Contours", and if those of one port differ, the flat index of the block after that, as
 * in "XBlock2Name". An array with the name of one that the surface has of its own gets "Input"
 * before its name. "PlaneCoordinates", which vtkOrthogonalSlicer writes of one family of slices,
 * stays off the surface.
 */
void CarryFieldData(
  const std::vector<vtkDataObject*>& inputs, vtkPolyData* surface, vtkPolyData* graph);
}

#endif
