// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCheckGraph_h
#define OrthoSlicesCheckGraph_h

#include "Core/Graph/CycleGeometry.h"

#include <string>

namespace orthoslices
{
/**
 * @file
 * @brief invariants of G and of its cycles
 *
 * Each returns what is wrong first, or an empty string.
 */

/**
 * Every node point has four arcs, two that begin there and two that end, one of each on the slices
 * of either family; so each of the four cells around its edge of M has two of them. The tables fit
 * each other in size. Linear.
 */
std::string CheckFourArcs(
  const GridCrossings& crossings, const NodePoints& nodes, const NodeGraph& graph);

/// What EmbedArcs and EmbedIsolated promise: arcs and loops lie strictly inside their face but for
/// their nodes, and neither touch each other nor themselves. O(n log n) in the vertices of a face.
std::string CheckEmbedding(const SpatialGrid& grid, const GridCrossings& crossings,
  const NodePoints& nodes, const NodeGraph& graph);

/// What TraceCycles promises: every arc and every loop is part of one cycle above its slice and of
/// one below, a cycle's arcs lead from node to node, and all of them bound its cell. Linear.
std::string CheckCycles(const CycleGeometry& geometry);
}

#endif
