// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPairNodePoints_h
#define OrthoSlicesPairNodePoints_h

#include "RegisterCrossings.h"

namespace orthoslices
{
/**
 * Node points (the paper's section 4.2, step 2): where contours of two orthogonal slices meet on an
 * edge of M. Node n joins the crossings First[n] (family 0) and Second[n] (family 1); NodeOf[c] is
 * the node of crossing c, or None if it was removed.
 */
struct NodePoints
{
  std::vector<Index> First, Second;
  std::vector<Index> NodeOf;

  Index Count() const { return static_cast<Index>(this->First.size()); }

  /// The crossing of the other contour at the same node.
  Index Partner(const Crossings& crossings, Index crossing) const
  {
    const Index node = this->NodeOf[crossing];
    return crossings.Family[crossing] == 0 ? this->Second[node] : this->First[node];
  }
};

/**
 * Pairs the crossings of the two families on every edge in their order along it.
 * REQUIRES: reconciled slices (as many crossings of both families on an edge, with the same signs).
 */
NodePoints PairNodePoints(const Crossings& crossings, const EdgeRegister& edges);

/// Mean of the two crossings of a node point, on its edge of M.
Point3 NodePosition(const SpatialGrid& grid, const GridEdgeCode& code, const Crossings& crossings,
  const NodePoints& nodes, Index node);

/// Distance of the two crossings of a node point.
double NodeDisagreement(const Crossings& crossings, const NodePoints& nodes, Index node);
}

#endif
