// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRemoveSmallComponents_h
#define OrthoSlicesRemoveSmallComponents_h

#include "Core/Graph/IsolatedContours.h"

#include <vector>

namespace orthoslices
{
/**
 * Takes the components out of G whose bounding box has a diagonal of less than `size`. Nodes,
 * arcs and loops are numbered anew; `nodeNormals` follow, and isolated contours lose their loops.
 * Returns how many there were. REQUIRES: FindComponents has run.
 */
Index RemoveSmallComponents(double size, GridCrossings& crossings, NodePoints& nodes,
  std::vector<double>& nodeNormals, IsolatedContours& isolated, NodeGraph& graph);
}

#endif
