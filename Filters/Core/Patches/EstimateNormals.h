// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEstimateNormals_h
#define OrthoSlicesEstimateNormals_h

#include "Core/Base/Execution.h"
#include "Core/Base/Ranks.h"
#include "Core/Graph/CycleGeometry.h"

#include <vector>

namespace orthoslices
{
/// The surface's normals along all contours.
struct SurfaceNormals
{
  std::vector<float> Normals;        ///< x, y, z of each point of G, of unit length, outwards
  std::vector<std::uint8_t> Corners; ///< points of G at which a contour has a corner; empty if none
};

/**
 * Normals of the surface at all points of G (our own addition).
 *
 * Two contours cross at a node point: the normal is the cross product of their tangents. Between
 * the node points of a contour the *tilt* of the surface, which is the angle of its normal against
 * the slice, is interpolated by cubics (Catmull and Rom); with the contour's tangent it gives the
 * normal. Both patches beside an arc have it in common: their tangent planes are the same there.
 *
 * Tangents are those of cubics fitted over a length that suits the noise of each contour. Nothing
 * is fitted or interpolated across corners, where a contour turns by more than `cornerAngle`
 * (radians). Loops have the normals of their contour in its plane, tilted so that their component
 * along the axis of the slice is that of `loopTilts`, from -1 to 1; all 0 if empty.
 *
 * Several processes fit the tangents of a part of the contours each, and exchange what they find: all
 * have all normals.
 */
SurfaceNormals EstimateNormals(const CycleGeometry& geometry, double cornerAngle,
  const std::vector<double>& loopTilts, const Execution& execution, const Ranks& ranks = Ranks());
}

#endif
