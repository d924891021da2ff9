// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSimplifyArcs_h
#define OrthoSlicesSimplifyArcs_h

#include "Core/Base/Execution.h"
#include "Core/Graph/NodeGraph.h"

#include <cmath>

namespace orthoslices
{
/// Marks the points between the first and the last of a curve that stay (D. H. Douglas and T. K.
/// Peucker, 1973): those left out lie within `tolerance` of the line through the others.
void MarkKept(const std::vector<Point3>& points, double tolerance, std::vector<std::uint8_t>& kept);

/// Which vertices ThinArcs leaves out; lengths in world units.
struct Thinning
{
  double Tolerance = 0.0;        ///< 0 leaves everything as it is
  double LongestSide = HUGE_VAL; ///< that leaving vertices out makes
};

/**
 * Leaves out vertices of arcs that lie within the tolerance of the line through those that stay;
 * see MarkKept. Vertices farther apart than the longest side keep some between them, if they have
 * any. Node points stay, and both patches beside an arc have what is left: no cracks.
 */
void ThinArcs(const Thinning& thinning, const GridCrossings& crossings, const NodePoints& nodes,
  const Execution& execution, NodeGraph& graph);
}

#endif
