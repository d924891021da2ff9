// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSparseSurface_h
#define OrthoSlicesSparseSurface_h

#include "Core/Pass.h"
#include "Core/Sparse/VirtualPlanes.h"

namespace orthoslices
{
/**
 * From contours of too few slices to a surface, in two passes: the first surface, of the real slices,
 * has the topology that the evidence decides; it bends from one slice to the next as little as it can,
 * and is cut on planes between them; from the real and these virtual slices the surface is made once
 * more. If that has another topology than what was bent, virtual slices that contradict real ones are
 * left out, and it is made again, twice at most; else the first surface is the result.
 *
 * Of a stack with a few slices across, the surface of the stack alone is bent first, through the
 * contours of the slices across: how the object hangs together, the stack says better than cells that
 * are far longer than wide.
 *
 * REQUIRES: density.IsSparse(), of the contours of the pass. False: stopped.
 */
bool MakeSparseSurface(const SliceDensity& density, Pass& pass);
}

#endif
