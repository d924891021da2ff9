// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReadPieces_h
#define OrthoSlicesReadPieces_h

#include "Core/Base/Contours.h"

class vtkPolyData;

namespace orthoslices
{
/**
 * Lines and polygons of a port as pieces of contours on slices across `axis`. Ghost cells and
 * cells of fewer than two points are passed over. Cell numbers are those of vtkPolyData (vertices
 * first). Without doublePrecision, coordinates are rounded to float here, so that all stages see
 * the values of the result.
 */
Pieces ReadPieces(vtkPolyData* input, int axis, bool doublePrecision);
}

#endif
