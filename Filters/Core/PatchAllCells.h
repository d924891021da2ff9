// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPatchAllCells_h
#define OrthoSlicesPatchAllCells_h

#include "Core/Base/Execution.h"
#include "Core/Options.h"
#include "Core/Reconstruction.h"
#include "Core/Stage.h"

#include <functional>
#include <vector>

namespace orthoslices
{
/**
 * Loops, cycles, central points and the patches that are not fans, of all cells (the paper's
 * sections 4.3 and 5), without the components that are too small.
 *
 * What is left out leaves the rest as if it had never been there: isolated contours are embedded
 * anew without it. Cells that rounding leaves unresolved get arcs that lie farther apart; then only
 * cells are patched again of which an arc, a central point or the evidence has changed, unless the
 * cycles are others now. Where that does not help, the thinnest isolated contours of these cells
 * are left out, one after another.
 *
 * Sets what `result` says of isolated contours, cycles, joins, topology and patches, and may change
 * crossings, nodes and graph; `nodeNormals` follow. `finish` is called after each stage.
 */
void PatchAllCells(const Options& options, const Execution& execution,
  const std::function<void(Stage)>& finish, std::vector<double>& nodeNormals,
  Reconstruction& result);
}

#endif
