// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesOtherPlanes_h
#define OrthoSlicesOtherPlanes_h

#include "Core/Base/Contours.h"
#include "Core/Base/Polylines.h"

#include <vector>

namespace orthoslices
{
/// A plane of no family, and the polylines on it.
struct OtherPlane
{
  Point3 Normal{ 0.0, 0.0, 0.0 }; ///< of unit length
  double Offset = 0.0;            ///< the product of Normal with the points of the plane
  double Noise = 0.0;             ///< how far points of it may be off it, in world units
  std::vector<Index> Lines;       ///< ascending
};

/**
 * The planes of polylines that belong to no family, by least squares through all points of each
 * (our own addition). Contours count as on one plane if each is on that of the other, as far as
 * noise lets one see. `tolerance` is that of planes, in world units. The planes ascend by their
 * first polylines.
 */
std::vector<OtherPlane> FindOtherPlanes(const Polylines& lines, double tolerance);

/**
 * The polylines of a plane as pieces of slices across z in a frame of their own: U and V are along
 * two unit vectors within the plane that make a right-handed frame with its normal, and W along the
 * normal: that of the plane for all points that differ from it by no more than noise. Cells are the
 * numbers of the polylines.
 */
Pieces LayOnPlane(const Polylines& lines, const OtherPlane& plane);

/// The point of a plane with these coordinates of LayOnPlane.
Point3 PointOn(const OtherPlane& plane, double u, double v);
}

#endif
