// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContourCorners_h
#define OrthoSlicesContourCorners_h

#include "Core/Graph/CycleGeometry.h"

#include <vector>

namespace orthoslices
{
/// A place at which a contour turns sharply.
struct ContourCorner
{
  Index Point; ///< of G
  int Axis;    ///< of the contour's slice
  Point3 Tip;  ///< the way that the corner points, within the slice, of unit length
  double Turn; ///< radians; positive to the left, where it is a corner of the inside
};

/// The corners of all contours of G (ContourCurve), those of more than `cornerAngle` (radians), in
/// true coordinates (SliceMetric). In the order of axes and contours.
std::vector<ContourCorner> FindContourCorners(const CycleGeometry& geometry, double cornerAngle);
}

#endif
