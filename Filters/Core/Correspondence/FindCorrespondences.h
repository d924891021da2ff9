// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFindCorrespondences_h
#define OrthoSlicesFindCorrespondences_h

#include "Core/Correspondence/ContourStack.h"
#include "Core/Correspondence/PriorKnowledge.h"

#include <tuple>
#include <vector>

namespace orthoslices
{
/// Where the surface runs that has two contours in common.
enum class Passage : std::uint8_t
{
  Across, ///< from one slice to the next one
  Above,  ///< both contours lie on one slice and the surface beyond it, at higher coordinates
  Below   ///< the same at lower coordinates
};

/**
 * Two contours bound the same piece of the surface between two slices. First lies on the lower
 * slice; if both lie on one, First is the smaller number. Cost tells how certain it is: small for
 * certain ones, in units that depend on the criterion.
 */
struct Correspondence
{
  Index First, Second;
  double Cost = 0.0;
  Passage Where = Passage::Across;

  bool operator<(const Correspondence& other) const
  {
    return std::tie(this->First, this->Second, this->Where) <
      std::tie(other.First, other.Second, other.Where);
  }
};

/// Which contours of parallel slices belong together where no orthogonal slice says so: our own
/// evidence, or one of the methods that section 2 of the paper compares with.
enum class CorrespondenceCriterion
{
  ByEvidence,          ///< those that overlap, and others by the evidence of CycleJoin
  Overlap,             ///< see OverlapCriterion.h
  EllipticalCylinders, ///< see EllipticalCylinders.h
  SpanningTree,        ///< see SpanningTreeCriterion.h
  ReebGraph            ///< see ReebGraphCriterion.h; the only one that uses prior knowledge
};

/**
 * Which contours of a stack of parallel slices belong together; for ByEvidence, those that overlap.
 * Contours on slices that are not neighbours never do. Each pair occurs once; the pairs ascend, and
 * depend on the contours and their order only.
 */
std::vector<Correspondence> FindCorrespondences(CorrespondenceCriterion criterion,
  const ContourStack& stack, const PriorKnowledge& known = PriorKnowledge());
}

#endif
