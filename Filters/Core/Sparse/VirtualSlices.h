// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesVirtualSlices_h
#define OrthoSlicesVirtualSlices_h

#include "Core/Base/Execution.h"
#include "Core/Sparse/VirtualPlanes.h"
#include "Core/Surface/LayOutTriangles.h"

namespace orthoslices
{
/**
 * What slices on the planes between the real ones would show, if the object had the topology of the
 * surface that was reconstructed, its contours, and between them the shape that bends least:
 *
 *   MakeSurfaceMesh    the surface, with its contours as curves on it
 *   RemeshSurface      with triangles of about the same size
 *   FairSurface        bent as little as the contours and cells allow
 *   SliceSurface       cut on the planes of ChooseVirtualPlanes
 *
 * The contours are closed, without vertices that show no shape, and have the interior on their
 * left; Contours::Virtual is set for all of them. They may cross each other where the smooth surface
 * crosses itself. `execution` is asked between the steps whether to go on; if not, there are none.
 */
Contours MakeVirtualSlices(const CycleGeometry& geometry, const Patches& patches,
  const SliceDensity& density, const Execution& execution);
}

#endif
