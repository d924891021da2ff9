// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContourSamples_h
#define OrthoSlicesContourSamples_h

#include "Core/Base/Contours.h"
#include "Core/Sparse/GuideCurves.h"

#include <vector>

namespace orthoslices
{
/// A contour in the world, on a plane of any inclination.
struct WorldLoop
{
  std::vector<Point3> Points; ///< the first is not repeated
  Point3 Normal; ///< unit normal of the plane, seen from which the interior is on the left
};

/// A point of a contour, in the world.
struct ContourSample
{
  Point3 Position;
  Point3 Inwards; ///< unit vector in the plane of the slice
};

/// REQUIRES: contours have the interior on their left.
std::vector<WorldLoop> MapToWorld(const Contours& contours, const AxisFrame& metric);

/// Appends those on planes of no family.
void AppendGuides(
  const std::vector<GuideContours>& guides, const AxisFrame& metric, std::vector<WorldLoop>& loops);

/**
 * Contours by their length, the longest first, and each from its point that is farthest from the
 * middle of all. So the same ones give the same field, to the last bit, whatever the order they
 * were read in; and, but for rounding, whichever axis is the first one, and mirrored, unless
 * several are farthest.
 */
void SortLoops(std::vector<WorldLoop>& loops);

/// A distance of samples of about `wanted`, but one with which they are many enough for the shape,
/// and few enough for a system of equations that is dense.
double SampleStep(const std::vector<WorldLoop>& loops, double wanted);

/**
 * Samples about `step` apart on all contours, at least six on each, in the order of the contours.
 * Where slices cross, one of two samples closer than a fifth of the step is left out. Time is the
 * square of their number, besides that of the vertices.
 */
std::vector<ContourSample> SampleLoops(const std::vector<WorldLoop>& loops, double step);
}

#endif
