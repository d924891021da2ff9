// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRemoveComponents_h
#define OrthoSlicesRemoveComponents_h

#include "Core/Graph/IsolatedContours.h"

#include <vector>

namespace orthoslices
{
/// All that components consist of.
struct ComponentTables
{
  GridCrossings& Crossings;
  NodePoints& Nodes;
  std::vector<double>& NodeNormals; ///< x, y, z of each node
  IsolatedContours& Isolated;
  NodeGraph& Graph;
};

/// Marks the components whose bounding box has a diagonal of less than `size` (world units).
/// REQUIRES, as the next function does: MeasureTopology has numbered the components.
std::vector<std::uint8_t> FindSmallComponents(
  double size, const NodePoints& nodes, const NodeGraph& graph);

/// Marks the components that are drawn on virtual planes alone (see SpatialGrid): nothing in the
/// input speaks for them.
std::vector<std::uint8_t> FindVirtualComponents(const SpatialGrid& grid,
  const GridCrossings& crossings, const NodePoints& nodes, const NodeGraph& graph);

/**
 * Takes marked components out of G. Their isolated contours are marked as left out; the other nodes
 * and arcs are numbered anew, and the normals follow. If there were any, G has no loops afterwards:
 * EmbedIsolated has to make them again, as if the contours that are left out had never been there.
 * Returns how many components were taken out.
 */
Index RemoveComponents(const std::vector<std::uint8_t>& marked, const ComponentTables& tables);
}

#endif
