// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what loops of a slice surround, by brute force: for few short loops
 */

#ifndef OrthoSlicesLoopOracle_h
#define OrthoSlicesLoopOracle_h

#include "Core/Base/Contours.h"
#include "Core/Loops/LoopRule.h"

#include <vector>

namespace orthoslices
{
namespace support
{

using Polygon = std::vector<Point2>;

/// How often a polygon runs around a point, counter-clockwise.
int WindingNumber(const Polygon& polygon, const Point2& point);

/// Whether two segments have a point in common. Exact.
bool DoSegmentsMeet(const Point2& p, const Point2& q, const Point2& r, const Point2& s);

/// Whether polygons have no point in common, neither with each other nor with themselves. Exact.
bool AreDisjointAndSimple(const std::vector<Polygon>& polygons);

/// A point that stands for a trapezoid of this area.
struct FacePoint
{
  Point2 Place;
  double Area;
};

/// A point in each trapezoid that all segments and the parallels to v through their ends and
/// crossings leave: so one, at least, in each face. Trapezoids narrower than `least` are left out,
/// and points closer than that to a segment.
std::vector<FacePoint> PointsInAllFaces(const std::vector<Polygon>& polygons, double least);

/// Length on which a polygon runs along another one, or along itself.
double CommonLength(const Polygon& a, const Polygon& b, bool isSame = false);

/**
 * Which of the points are inside by a rule, from winding numbers at the points alone. For Union
 * 98 % of a polygon have to be within another one. REQUIRES: no polygon runs along itself, and
 * none shares more than half of its length with another one.
 */
std::vector<bool> FindInsidePoints(
  LoopRule rule, const std::vector<Polygon>& polygons, const std::vector<FacePoint>& points);

} // namespace support
} // namespace orthoslices

#endif
