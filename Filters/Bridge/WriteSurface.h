// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesWriteSurface_h
#define OrthoSlicesWriteSurface_h

#include "Core/Base/Execution.h"

class vtkPolyData;

namespace orthoslices
{
struct Reconstruction;

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
}

#endif
