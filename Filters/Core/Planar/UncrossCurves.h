// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesUncrossCurves_h
#define OrthoSlicesUncrossCurves_h

#include "Core/Base/Predicates.h"

#include <vector>

namespace orthoslices
{
/**
 * Polylines in a plane: each lists the numbers of its vertices, and no two share one. Curves from
 * FirstClosed on are closed: they begin and end with two vertices at one place.
 */
struct PlanarCurves
{
  std::vector<Point2> Vertices;
  std::vector<std::vector<Index>> Curves;
  std::size_t FirstClosed = static_cast<std::size_t>(-1);
};

void AddCurve(const std::vector<Point2>& points, PlanarCurves& curves);
/// The polygon with these corners. All closed curves are added last.
void AddClosedCurve(std::vector<Point2> points, PlanarCurves& curves);

/// Whether no curve touches itself or another one. Never gives up.
bool AreSimple(PlanarCurves& curves);

/// Outcome of UncrossCurves.
struct Uncrossing
{
  bool Simple = false;   ///< no curve touches itself or another one now
  Index Changes = 0;     ///< pairs of segments that were taken apart
  Point2 Where{ 0, 0 };  ///< the middle of the first pair
  double Shortening = 0; ///< of all curves together
};

/**
 * Takes curves apart that cross themselves or each other, by the 2-opt move of the travelling
 * salesman heuristics (G. A. Croes, "A Method for Solving Traveling-Salesman Problems", 1958).
 *
 * Where two segments ab and cd of one curve cross, the part between them is passed the other way
 * (ac, bd). Two curves that cross twice exchange the parts between the crossings, so that their
 * ends stay together, closed ones the shorter parts; if they cross once, they exchange all that
 * follows (ad, cb). No vertex moves or is lost, starts stay starts and ends stay ends, and every move
 * makes the curves shorter, so that it comes to an end. A vertex that lies on another segment, or at
 * which a curve folds back on itself, is left out, but for the first and the last one of a curve.
 *
 * The moves that shorten most come first, so that the result does not depend on the directions of
 * the axes. Gives up, with Simple unset, when two ends of curves touch, or when moves go on after
 * much more work than the number of vertices accounts for.
 */
Uncrossing UncrossCurves(PlanarCurves& curves);
}

#endif
