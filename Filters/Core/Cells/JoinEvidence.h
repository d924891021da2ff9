// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesJoinEvidence_h
#define OrthoSlicesJoinEvidence_h

#include "Core/Base/Execution.h"
#include "Core/Cells/CycleJoin.h"

#include <vector>

namespace orthoslices
{
/// What the evidence is measured on.
struct EvidenceTables
{
  const CycleGeometry& Geometry;
  const CellGroups& Cells;                  ///< of all cycles
  const std::vector<double>& NodeNormals;   ///< x, y, z for each node, see ComputeNodeNormals
  const std::vector<double>& CentralPoints; ///< x, y, z for each cycle, see LocateCentralPoints
};

/// Cycles whose centers are closer together than this part of the sum of their radii are rather
/// parallel sheets than ends of a tube.
constexpr double MinDistance = 0.45;
/// A cycle with a smaller radius than this part of the other one's is rather the border of a tip
/// that a slice just touches than the other end of a tube.
constexpr double MinRadius = 0.25;

/// What speaks for or against one patch of two cycles of a cell; see CycleJoin.
struct PairFeatures
{
  double Flatness = 0.0;     ///< D: the mean of both
  double Steepness = 0.0;    ///< T
  double Facing = 0.0;       ///< S
  double Distance = 0.0;     ///< d in world units
  double Disagreement = 0.0; ///< the greatest at the node points of both, in world units
  double Step = 1.0;         ///< of the spatial grid at the cell, in world units
  double Closeness = 0.0;    ///< the part of the radii that is missing to MinDistance
  double Inequality = 0.0;   ///< the part of the wider radius that is missing to MinRadius
  bool OnOneFace = false;    ///< both are loops on the same face of the cell
  int Loops = 0;             ///< how many of the two are loops
};

/// Weights of the features; those of lengths are for one step of the grid.
struct EvidenceWeights
{
  double Constant, Flatness, Steepness, Facing, Distance;
  double Disagreement, Closeness, Inequality, OnOneFace;
};

/**
 * The weights in use. Those of the constant, D, T, S and d were fitted by logistic regression to 3
 * 100 pairs of cycles in 12 scanned and segmented shapes, and rounded. The table of these pairs has
 * not been kept. `FitEvidence --turns 3` does the same for the nine surfaces of Data, cut by 16 and
 * by 32 planes on each axis, as they are and in three other positions. It gives today, with
 * standard errors, for 7 463 pairs of cycles of node points, of which 272 belong together, and for
 * all 8 877 pairs, isolated contours included, of which 1 051 do:
 *
 *               in use      node points         all pairs
 *     constant     2.8     4.11 +- 0.49     5.22 +- 0.25
 *     D           -3.0    -6.97 +- 0.35    -6.70 +- 0.20
 *     T           -4.0    -7.00 +- 0.58    -5.34 +- 0.33
 *     S            2.0     3.34 +- 0.43     1.63 +- 0.18
 *     d           -2.0    -2.01 +- 0.39    -2.88 +- 0.21
 *
 * So the signs agree but the sizes do not: the fit makes D count more than twice as much as it does
 * in use, T one and a half times. That changes the odds more than the choice: of the pairs of node
 * points the weights in use decide 98.0 % rightly and the fitted ones 98.0 %, of all pairs 94.3 %
 * and 94.2 %, but the fitted odds are the better ones (0.056 nats of surprise for each pair instead
 * of 0.108, 0.133 instead of 0.174). The odds in use are too near to even.
 *
 * The other weights were chosen by hand: cuts of one surface, to which one can fit, do not
 * contradict each other. A disagreement of 0.35 steps takes away what the constant gives; Closeness
 * takes away 1.8 at most, Inequality 2.
 */
constexpr EvidenceWeights JoinWeights{ 2.8, -3.0, -4.0, 2.0, -2.0, -8.0, -4.0, -8.0, -2.0 };

/// The logarithm of the odds that the two belong together.
double EvidenceOf(const PairFeatures& features, const EvidenceWeights& weights = JoinWeights);

/// Two cycles of a cell, First < Second, and their features.
struct MeasuredPair
{
  Index First, Second;
  PairFeatures Features;
};

/// All pairs of cycles of one cell that may belong together, ascending by cell: two cycles of node
/// points have to face each other, or away from each other.
std::vector<MeasuredPair> MeasurePairs(const EvidenceTables& tables);

/**
 * Least evidence for two loops of which a criterion for parallel slices says that they belong
 * together, and that for cycles of a stitched patch: odds of 20 to 1. It is as much as leaves a
 * place decided; see DecisiveEvidence.
 */
constexpr double CertainEvidence = 3.0;
/**
 * Evidence for the best way of an isolated contour to go on, if there is no distance to bridge:
 * odds of 4.5 to 1. One for each step of distance less, so that a patch more than one and a half
 * steps away is no way to go on by itself. Chosen by hand, not fitted.
 */
constexpr double ContinuationEvidence = 1.5;
/// Loops on one face are rather neighbours than ends of one tube: by so many steps they count as
/// farther apart when an isolated contour looks for a way to go on.
constexpr double OneFaceDistance = 2.0;

/// The joins that the slices leave open, ascending by cell.
std::vector<CycleJoin> FindJoins(
  const EvidenceTables& tables, const KnownPairs& known, const Execution& execution);
}

#endif
