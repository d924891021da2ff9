// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the texts of errors and warnings
 */

#ifndef OrthoSlicesDescribeReport_h
#define OrthoSlicesDescribeReport_h

#include "Core/Correspondence/PriorKnowledge.h"
#include "Core/Slicing/SliceSurface.h"

#include <string>

namespace orthoslices
{
struct Reconstruction;

/// The names of the axes: the x-slices come from port 0.
constexpr char AxisNames[] = "xyz";

/// What the report has to know of the settings.
struct ReportSettings
{
  double Tolerance = 0.0;      ///< in world units: contradictions up to it are not worth a warning
  bool RepairsCrossing = true; ///< contours that cross were repaired, not left out
  PriorKnowledge Expected;     ///< what the user knows of the surface
};

/// Why a surface cannot be sliced, where, and what to do about it; empty if it can.
std::string DescribeProblem(const SurfaceProblem& problem);

/**
 * What the user should be told of a surface that is closed all the same; empty if all is well.
 * These are, in this order:
 *  - contours that were mended, by kinds;
 *  - contours that were left out because they are open, off their plane or not finite;
 *  - contours that cross, and places where the lines of a slice were drawn anew because they touch;
 *  - slices that contradict each other by more than the tolerance, and which slice is the worst;
 *  - contours that run clockwise, so that the surface is inside out;
 *  - slabs so thin that patches in them may touch;
 *  - contours, or parts of them, that take no part in the surface;
 *  - places that matter and where the odds are near even (see FindDoubtfulJoins), and where to
 *    slice next; whatever else the slices leave open is in the table of undecided places only;
 *  - numbers of components and handles that are not as expected.
 *
 * REQUIRES: RemoveSmallRepairs was called with the tolerance.
 */
std::string DescribeReport(const Reconstruction& result, const ReportSettings& settings);
}

#endif
