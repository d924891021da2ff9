// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEndRims_h
#define OrthoSlicesEndRims_h

#include "Core/Base/Box.h"
#include "Core/Graph/NodeGraph.h"
#include "Core/Sparse/GuideCurves.h"

#include <vector>

namespace orthoslices
{
/// How a stack ends on one side of a slice.
enum class EndKind : std::uint8_t
{
  Unknown, ///< no guide shows it
  Flat,    ///< in the slice
  Rim,     ///< flat, but farther out: walls go on to a rim, and within that it is flat
  Dome     ///< in any other way
};

/// A place on a loop where a guide leaves it for what is beyond, and meets the rim.
struct RimAnchor
{
  double Place = 0.0;    ///< along the loop from its first point
  double Outwards = 0.0; ///< from the loop to the rim, at right angles to the loop within the slice
  double Upwards = 0.0;  ///< from the slice to the rim, away from the other slices
};

/// What guides show of the end on one side of a loop, if there is one.
struct LoopEnd
{
  EndKind Kind = EndKind::Unknown;
  double Height = 0.0;            ///< how far the object goes beyond the slice
  std::vector<RimAnchor> Anchors; ///< by their place
};

/**
 * For each loop of a stack, on the side below it (2 loop) and above (2 loop + 1), in which way the
 * object ends there, if it ends there at all: by the guides that begin or end on the loop, or
 * nearest to it, and do not go on to another slice. It ends flat where none of these goes farther
 * than FlatShare of the spacing. It has a rim where each of them rises by a wall, at most as far
 * sideways as upwards, to a level that it keeps, but for FlatShare of the spacing and a fifth of
 * its height, over more than half of its way.
 */
std::vector<LoopEnd> FindLoopEnds(const NodeGraph& graph, const GuideCurves& guides);

/// Cuts guides where they meet the rims of loops that have one.
void CutAtRims(const NodeGraph& graph, const std::vector<LoopEnd>& ends, GuideCurves& guides);

/// Several ends of one patch: the patch ends flat, or with a rim, only if all that is known says
/// so.
EndKind CombineEnds(EndKind one, EndKind other);

/// The rim of a loop: a point for each of its points. `up` is the direction of the stack's axis
/// away from the other slices, 1 or -1. Between anchors the distances change evenly. REQUIRES:
/// anchors.
std::vector<Point3> PlaceRim(
  const NodeGraph& graph, Index loop, double up, const std::vector<RimAnchor>& anchors);

/// The box around all guides.
Box3 BoxOf(const GuideCurves& guides);
}

#endif
