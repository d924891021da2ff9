// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReadGuides_h
#define OrthoSlicesReadGuides_h

#include "Core/Base/Execution.h"
#include "Core/Base/AxisFrame.h"
#include "Core/Frames/OtherPlanes.h"
#include "Core/Options.h"
#include "Core/Sparse/GuideCurves.h"

#include <vector>

namespace orthoslices
{
/**
 * The contours on planes of no family, along the axes of a frame: mended, joined, resolved and
 * oriented by the same stages and options as slices are, each plane by itself. A plane that these
 * refuse, or that has nothing usable, has no loops. There is one for each of `planes`.
 */
std::vector<GuideContours> ReadGuides(const Polylines& lines, const std::vector<OtherPlane>& planes,
  const AxisFrame& frame, const Options& options, const Execution& execution);
}

#endif
