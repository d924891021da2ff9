// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRemoveSmallComponents_h
#define OrthoSlicesRemoveSmallComponents_h

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

/**
 * Takes the components out of G whose bounding box has a diagonal of less than `size` (world units).
 * Their isolated contours are marked as left out; the other nodes and arcs are numbered anew, and
 * the normals follow. If there were any, G has no loops afterwards: EmbedIsolated has to make them
 * again, as if the contours that are left out had never been there. Returns how many components
 * were taken out. REQUIRES: MeasureTopology has numbered the components.
 */
Index RemoveSmallComponents(double size, const ComponentTables& tables);
}

#endif
