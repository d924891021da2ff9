// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The only place where VTK's data become the core's plain data and back.
 */

#ifndef PolyDataBridge_h
#define PolyDataBridge_h

#include "Core/Reconstruct.h"

class vtkPolyData;
class vtkTable;

namespace orthoslices
{
/**
 * Lines and polygons of a port as pieces of contours on slices across `axis`. Ghost cells and
 * cells of fewer than two points are passed over. Cell numbers are those of vtkPolyData (vertices
 * first). Without doublePrecision, coordinates are rounded to float here, so that all stages see
 * the values of the result.
 */
Pieces ReadPieces(vtkPolyData* input, int axis, bool doublePrecision);

/// Which optional arrays port 0 gets.
struct SurfaceArrayOptions
{
  bool Normals = true;
  bool Curvatures = false;
};

/**
 * Port 0: triangles, cell arrays, normals, field data; see vtkOrthogonalSliceReconstruction.
 * Consumes the result: each part is released as soon as it is written, because this is where
 * memory peaks.
 */
void WriteSurface(Reconstruction&& consumed, const Execution& execution, bool doublePrecision,
  const SurfaceArrayOptions& arrays, double reportTolerance, vtkPolyData* surface);

/// Port 1: the graph G, the repairs and the isolated contours.
void WriteGraph(const Reconstruction& result, bool doublePrecision, vtkPolyData* graph);

/// Port 2: the histogram of polygon sizes.
void WriteHistogram(const Reconstruction& result, vtkTable* table);

/// Port 3: agreement of every contour with the orthogonal families.
void WriteContourTable(const Reconstruction& result, vtkTable* table);

/// Port 4: agreement of every slice with the orthogonal families, and its shift.
void WriteSliceTable(const Reconstruction& result, vtkTable* table);

/// Port 5: the undecided places, and where to slice next.
void WriteUndecidedTable(const Reconstruction& result, vtkTable* table);
}

#endif
