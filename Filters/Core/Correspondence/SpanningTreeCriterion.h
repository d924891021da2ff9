// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSpanningTreeCriterion_h
#define OrthoSlicesSpanningTreeCriterion_h

#include "Core/Correspondence/FindCorrespondences.h"

#include <vector>

namespace orthoslices
{
/**
 * Skinner's minimum spanning tree, as described in D. Meyers, S. Skinner, K. Sloan, "Surfaces from
 * contours" (1992). An ellipse with centre (x, y) and semi-axes a, b stands for each contour. The
 * graph of all pairs of contours i, j on neighbouring slices, of outer boundaries or of holes, has
 * the costs
 *
 *   c(i, j) = (xi - xj)^2 + (yi - yj)^2 + (ai - aj)^2 + (bi - bj)^2,
 *
 * and the edges of its spanning tree of least cost are the correspondences. So nothing joins
 * contours of one slice, and no cycle, hence no handle, can be expressed.
 *
 * A spanning tree joins everything. Objects are separated as in C. Zahn's "Graph-theoretical
 * methods for detecting and describing Gestalt clusters" (1971), which is our interpretation: an
 * edge is dropped if it is out of all proportion to the tree, more than three times as long as the
 * tree's median edge (nine times its cost) and also longer than the two major semi-axes together.
 *
 * Equal costs are ordered by the numbers of the contours. Time grows with the square of the number
 * of contours on two slices.
 */
std::vector<Correspondence> CorrespondencesBySpanningTree(const ContourStack& stack);
}

#endif
