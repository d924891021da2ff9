// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEmbedArcs_h
#define OrthoSlicesEmbedArcs_h

#include "Core/Base/Execution.h"
#include "Core/Graph/EditGraph.h"
#include "Core/Graph/FaceArcs.h"

#include <vector>

namespace orthoslices
{
/**
 * Makes the arcs of every face of M simple curves that do not touch each other, strictly inside
 * the face but for their ends (our own addition; contours that do not cross have such arcs from
 * the start).
 *
 *  - Vertices on the border of their face move inside by the grid's Margin.
 *  - Arcs that touch (contours that cross, nodes moved by contradictory slices) pass their
 *    vertices in another order: see UncrossCurves. An arc without vertices that would lie on the
 *    edge of M on which it begins and ends gets one vertex beside it.
 *  - Faces where that does not help have all their arcs drawn anew: see DrawArcShells.
 *
 * Other faces keep every vertex. `forced` lists arcs whose faces are drawn anew in any case.
 * Returns one repair for each face that was changed, and marks its changed arcs in
 * NodeGraph::Redrawn. If there are any, G has no loops afterwards.
 */
std::vector<Repair> EmbedArcs(
  const GraphTables& tables, const Execution& execution, const std::vector<Index>& forced = {});

/// The faces, ascending, whose arcs touch each other or themselves: those that EmbedArcs would
/// change.
std::vector<Index> FindCrossingFaces(
  const ArcGeometry& geometry, const ArcsByFace& faces, const Execution& execution);
}

#endif
