// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReadPieces_h
#define OrthoSlicesReadPieces_h

#include "Core/Base/Polylines.h"

#include <functional>

class vtkDataObject;
class vtkPolyData;

namespace orthoslices
{
/// Calls visit with each vtkPolyData of an input, which may be composite, and its flat index: 0 if
/// the input is not composite. What is no vtkPolyData is passed over.
void VisitPolyData(
  vtkDataObject* input, const std::function<void(vtkPolyData* data, Index block)>& visit);

/**
 * Appends the lines and polygons of a port's input. Ghost cells and cells of fewer than two points
 * are passed over. Cell numbers are those of vtkPolyData (vertices first). Without doublePrecision,
 * coordinates are rounded to float here, so that all stages see the values of the result.
 */
void ReadPieces(vtkDataObject* input, int port, bool doublePrecision, Polylines& lines);
}

#endif
