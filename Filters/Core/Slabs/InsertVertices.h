// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesInsertVertices_h
#define OrthoSlicesInsertVertices_h

#include "Core/Graph/EditGraph.h"
#include "Core/Slabs/SlabGroup.h"

#include <vector>

namespace orthoslices
{
/// The loops of G with the vertices that overlays insert where contours cross in projection.
struct StitchedLoops
{
  std::vector<GraphLoop> Loops;
  std::vector<std::vector<Index>> VertexAt;    ///< of each loop: places of the vertices of G
  std::vector<std::vector<Index>> InsertionAt; ///< of each group: places of its insertions

  Index Count(Index loop) const { return static_cast<Index>(this->Loops[loop].Points.size()); }
};

/**
 * Inserts the vertices of all overlays. A new vertex, once rounded, lies beside its segment and may
 * lie on another one: the overlays beside slices on which loops touch are given up (Valid = false),
 * and those in which rounding has made one vertex of two so that four triangles meet at an edge.
 */
StitchedLoops InsertVertices(const CycleGeometry& geometry, int axis, const Execution& execution,
  std::vector<SlabGroup>& groups);
}

#endif
