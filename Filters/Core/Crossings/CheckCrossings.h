// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCheckCrossings_h
#define OrthoSlicesCheckCrossings_h

#include "Core/Crossings/PairNodePoints.h"

#include <string>

namespace orthoslices
{
/**
 * @file
 * @brief invariants of crossings and node points
 *
 * Each returns what is wrong first, or an empty string. Linear in the number of crossings.
 */

/// Next and Previous of the crossings that are not removed are inverse to each other.
std::string CheckCrossingOrder(const GridCrossings& crossings);

/**
 * What ReconcileSlices promises: every edge of M has as many crossings of both families, and the
 * k-th of one family and the k-th of the other have the same sign.
 */
std::string CheckSlicesAgree(const GridCrossings& crossings, const EdgeRegister& edges);

/// What PairNodePoints promises: every crossing that is not removed belongs to one node point,
/// which has one crossing of each family, on one edge of M and with the same sign.
std::string CheckNodePoints(const GridCrossings& crossings, const NodePoints& nodes);
}

#endif
