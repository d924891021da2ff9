// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFitError_h
#define OrthoSlicesFitError_h

#include "Core/Patches/InnerPatches.h"

namespace orthoslices
{
/**
 * How far contours lie off the surfaces that are fitted to each patch, smooth or with a crease, RMS
 * of all patches, or of some thousands, in world units: about as far as the patches are from the
 * object between its contours. 0 if there are no patches that tell. Several processes each measure a
 * part of them, with the same result.
 */
double FitError(
  const PatchTables& tables, const Execution& execution, const Ranks& ranks = Ranks());
}

#endif
