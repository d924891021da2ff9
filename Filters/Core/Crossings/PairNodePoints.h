// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPairNodePoints_h
#define OrthoSlicesPairNodePoints_h

#include "Core/Base/Execution.h"
#include "Core/Crossings/RegisterCrossings.h"
#include "Core/Crossings/Repair.h"

#include <cmath>
#include <vector>

namespace orthoslices
{
/**
 * Node points (the paper's section 4.2, step 2): where contours of two orthogonal slices meet on
 * an edge of M. Node n joins the crossings First[n] (family 0) and Second[n] (family 1);
 * NodeOf[c] is the node of crossing c, or None if it was removed.
 */
struct NodePoints
{
  std::vector<Index> First, Second;
  std::vector<double> Position; ///< along the edge
  /// Position of the second crossing less that of the first; 0 where one of them belongs to a
  /// virtual slice, as that says nothing of the input.
  std::vector<double> Difference;
  std::vector<Index> NodeOf;

  Index Count() const { return static_cast<Index>(this->First.size()); }

  /// Distance of the two crossings of a node; 0 where one belongs to a virtual slice.
  double Disagreement(Index node) const { return std::abs(this->Difference[node]); }

  /// The crossing of the other contour at the same node.
  Index Partner(const GridCrossings& crossings, Index crossing) const
  {
    const Index node = this->NodeOf[crossing];
    return crossings.Family[crossing] == 0 ? this->Second[node] : this->First[node];
  }
};

/**
 * Pairs the crossings of the two families on every edge in their order along it. A node lies at the
 * mean of its two crossings, weighted by the axes of their slices; of a real and a virtual slice at
 * the crossing of the real one, of two virtual ones midway. Nodes keep the grid's Margin from the
 * ends of their edge and from each other, less where there are too many of them, so that no two
 * nodes coincide; they are numbered upwards along each edge. REQUIRES: reconciled slices (as many
 * crossings of both families on an edge, with the same signs).
 */
NodePoints PairNodePoints(const SpatialGrid& grid, const GridCrossings& crossings,
  const EdgeRegister& edges, const AxisWeights& weights = { 1.0, 1.0, 1.0 },
  const Execution& execution = Execution());

/// World coordinates of a node point.
Point3 NodePosition(const SpatialGrid& grid, const GridEdgeCode& code,
  const GridCrossings& crossings, const NodePoints& nodes, Index node);

}

#endif
