// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRemoveSmallComponents_h
#define OrthoSlicesRemoveSmallComponents_h

#include "Core/Graph/IsolatedContours.h"

#include <vector>

namespace orthoslices
{
/**
 * Takes the components out of G whose bounding box has a diagonal of less than `size` (world units).
 * Their isolated contours are marked as left out; the other nodes and arcs are numbered anew, and
 * `nodeNormals` follow. If there were any, G has no loops afterwards: EmbedIsolated has to make them
 * again, as if the contours that are left out had never been there. Returns how many components
 * were taken out. REQUIRES: MeasureTopology has numbered the components.
 */
Index RemoveSmallComponents(double size, GridCrossings& crossings, NodePoints& nodes,
  std::vector<double>& nodeNormals, IsolatedContours& isolated, NodeGraph& graph);
}

#endif
