// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContourSamples_h
#define OrthoSlicesContourSamples_h

#include "Core/Base/Contours.h"

#include <vector>

namespace orthoslices
{
/// A point of a contour.
struct ContourSample
{
  Point3 Position;
  Point3 Inwards; ///< unit vector in the plane of the slice
};

/// A step of about that length, or so much more that there are not too many samples for a system of
/// equations that is dense.
double SampleStep(const Contours& contours, double length);

/**
 * Samples about `step` apart on all contours, at least six on each, in the order of the contours. Where
 * slices cross, one of two samples closer than a fifth of the step is left out. Time is the square of
 * their number, besides that of the vertices.
 * REQUIRES: contours have the interior on their left.
 */
std::vector<ContourSample> SampleContours(const Contours& contours, double step);
}

#endif
