// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesAssembleSet_h
#define OrthoSlicesAssembleSet_h

#include "Core/Base/Execution.h"
#include "Core/Pieces/AssembleContours.h"
#include "Core/Pieces/OpenCurve.h"

namespace orthoslices
{
/**
 * Appends the contours of one axis that need nothing, or no more than being moved onto their plane,
 * in the order of their first pieces. With Mend, returns the curves with loose ends, and those that
 * were trimmed to loops; see AssembleContours.
 */
std::vector<OpenCurve> AssembleSet(Pieces&& pieces, const AssembleSettings& settings,
  Contours& contours, PieceProblems& problems, const Execution& execution);
}

#endif
