// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSparseSurface_h
#define OrthoSlicesSparseSurface_h

#include "Core/Pass.h"
#include "Core/Sparse/VirtualPlanes.h"

#include <algorithm>

namespace orthoslices
{
/// Where the slices of a pass are too few for the patches of their cells alone, for either way of
/// filling the gaps; nowhere if virtual slices are not wanted.
struct SparseSlices
{
  explicit SparseSlices(const Pass& pass);
  bool Any() const { return this->Bending.IsSparse() || this->Field.IsSparse(); }
  double EdgeLength() const
  {
    return std::max(this->Bending.EdgeLength(), this->Field.EdgeLength());
  }

  SliceDensity Bending, Field;
};

/**
 * From contours of too few slices to a surface, in two passes. The first surface, of the real
 * slices, has the topology that the evidence decides. Planes between the slices are then cut from
 * something that goes on smoothly from one to the next, and from the real and these virtual slices
 * the surface is made once more.
 *
 * - A few slices of several families, with Options::FollowField: from a field through all contours,
 *   if it foretells slices about as well as what there is without it. It may not part what the
 *   first surface joins.
 * - A dense family or two, the others missing or with a few slices: from the first surface, which
 *   is bent as little as it can. Of a stack with a few slices across, the surface of the stack
 *   alone is bent, through the contours of the slices across: how the object hangs together, the
 *   stack says better than cells that are far longer than wide. If the second surface has another
 *   topology than what was bent, virtual slices that contradict real ones are left out, and it is
 *   made again, twice at most; else the first surface is the result. Of a stack with slices across
 *   also a second surface with other handles may be, if the first one has more TotalCurvature.
 *
 * REQUIRES: sparse.Any(), of the contours of the pass. False: stopped.
 */
bool MakeSparseSurface(const SparseSlices& sparse, Pass& pass);
}

#endif
