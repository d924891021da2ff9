// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesUndecidedPlaces_h
#define OrthoSlicesUndecidedPlaces_h

#include "Core/Cells/ChooseJoins.h"

#include <vector>

namespace orthoslices
{
/// What the slices leave open. The numbers are part of the output.
enum class UndecidedKind
{
  TwoCycles = 0,       ///< a tube, or two ends
  IsolatedContour = 1, ///< an isolated contour and the patch that it may go on to
  IsolatedContours = 2 ///< two isolated contours
};

/// What was chosen. The numbers are part of the output.
enum class UndecidedChoice
{
  Separate = 0,
  Joined = 1,
  Impossible = 2 ///< separate, because no joined patch without crossings was found
};

/// A place where the slices do not say which contours belong together.
struct UndecidedPlace
{
  Point3 Where; ///< between the two
  UndecidedKind Kind;
  UndecidedChoice Choice;
  double Evidence;    ///< for joining them; see CycleJoin
  double Uncertainty; ///< in bits; see FindUndecidedPlaces
  int PlaneRank;      ///< of the proposed plane that settles it, 0 for the best; -1 without one
};

/// A slice to be added.
struct ProposedPlane
{
  int Axis;
  double Coordinate;
  Index Settles; ///< number of undecided places that are settled by this plane and no better one
  double Gain;   ///< the sum of their uncertainty
};

/// By the rank of their planes, then by evidence.
struct UndecidedPlaces
{
  std::vector<UndecidedPlace> Places;
  std::vector<ProposedPlane> Planes;
};

/**
 * What a slice tells, in bits, of a place that it settles: the entropy of the probability
 * p = 1 / (1 + exp(-evidence)) that the two belong together (the weights of the evidence come from
 * a logistic regression). 1 at evidence 0, 0.69 at 1.5 or -1.5, 0.28 at 3 or -3.
 */
double UncertaintyOf(double evidence);

/// Evidence, for or against, from which a place counts as decided: the logistic regression gives
/// its choice a probability of 1 / (1 + exp(-3)), which is 95 %.
constexpr double DecisiveEvidence = 3.0;

/**
 * Where to slice next (our own addition). A place counts as undecided if the evidence is less than
 * DecisiveEvidence, for or against, or if what was chosen is impossible, which counts as 1 bit of
 * uncertainty. Joins of cycles with arcs on virtual slices are left out: what such a slice says is
 * no contour of the input. A place is settled by a slice that passes between two cycles, or through
 * an isolated contour, which gets node points there. The plane that settles places with the
 * greatest sum of uncertainty is proposed first, then the one that settles most of the others, and
 * so on (greedy stabbing of weighted intervals), at most `maxPlanes`.
 */
UndecidedPlaces FindUndecidedPlaces(
  const CycleGeometry& geometry, const std::vector<CycleJoin>& joins, Index maxPlanes = 1000);
}

#endif
