// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesWriteSurface_h
#define OrthoSlicesWriteSurface_h

#include "Core/Base/Execution.h"
#include "Core/Base/Ranks.h"

class vtkPolyData;

namespace orthoslices
{
struct Reconstruction;

/// Which optional arrays port 0 gets.
struct SurfaceArrayOptions
{
  bool Normals = true;
  bool Curvatures = false;
  /// Those of which each has a part of the surface, which then has no curvatures. One process alone
  /// where Reconstruction::Part is not set.
  Ranks Processes{};
};

/**
 * Port 0: triangles, cell arrays, normals, field data; see vtkOrthogonalSliceReconstruction.
 * Consumes the result: each part is released as soon as it is written, because this is where
 * memory peaks. Of a part of the surface, writes the piece of this process, marked as such: see
 * MarkPiece.
 */
void WriteSurface(Reconstruction&& consumed, const Execution& execution, bool doublePrecision,
  const SurfaceArrayOptions& arrays, double reportTolerance, vtkPolyData* surface);
}

#endif
