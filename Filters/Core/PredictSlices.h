// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPredictSlices_h
#define OrthoSlicesPredictSlices_h

#include "Core/Pass.h"
#include "Core/Sparse/ContourSamples.h"

#include <functional>

namespace orthoslices
{
/// Makes the surface of a pass. False: stopped.
using Sketcher = std::function<bool(Pass& pass)>;

/**
 * How far the patches of the cells are from what is between slices, against a field (SliceField)
 * through the same contours: below 1 patches are closer. The slices themselves say so. Some are
 * left out, one after another, up to two of each family; a surface is made, and a field solved, of
 * the others; and the mean distance of the contours that were left out from the one is divided by
 * that from the other.
 *
 * A field bends evenly, as organic shapes do; of edges, level ends and straight walls it knows
 * nothing, and then patches foretell slices far better.
 *
 * `step`: between samples, see SampleStep. 0 if stopped, and if nothing can be left out. Is all of
 * the part that `first` is at in its progress.
 */
double ComparePredictions(
  const Contours& drawn, Pass& first, double step, const Sketcher& sketch);

/// The contours of a pass in the world, and those on planes of no family.
std::vector<WorldLoop> ListLoops(const Contours& drawn, const Pass& pass);
}

#endif
