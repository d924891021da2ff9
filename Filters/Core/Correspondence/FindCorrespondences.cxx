// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/FindCorrespondences.h"

#include "Core/Correspondence/EllipticalCylinders.h"
#include "Core/Correspondence/OverlapCriterion.h"
#include "Core/Correspondence/ReebGraphCriterion.h"
#include "Core/Correspondence/SpanningTreeCriterion.h"

#include <algorithm>

namespace orthoslices
{
std::vector<Correspondence> FindCorrespondences(
  CorrespondenceCriterion criterion, const ContourStack& stack, const PriorKnowledge& known)
{
  std::vector<Correspondence> pairs;
  switch (criterion)
  {
    case CorrespondenceCriterion::ByEvidence:
    case CorrespondenceCriterion::Overlap:
      pairs = CorrespondencesByOverlap(stack);
      break;
    case CorrespondenceCriterion::EllipticalCylinders:
      pairs = CorrespondencesByCylinders(stack);
      break;
    case CorrespondenceCriterion::SpanningTree:
      pairs = CorrespondencesBySpanningTree(stack);
      break;
    case CorrespondenceCriterion::ReebGraph:
      pairs = CorrespondencesByReebGraph(stack, known);
      break;
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}
}
