// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   stacks of contours for tests of the correspondence criteria
 */

#ifndef OrthoSlicesContourStacks_h
#define OrthoSlicesContourStacks_h

#include "Core/Correspondence/FindCorrespondences.h"
#include "Support/TextContours.h"

namespace orthoslices
{
namespace support
{

/// Appends a contour and returns its number. Contours are appended in ascending order of slices.
Index AddContour(ContourStack& stack, Index slice, const std::vector<Point2>& vertices);

/// The same for an ellipse with semi-axes a and b along u and v, of 48 vertices, counter-clockwise.
Index AddEllipse(ContourStack& stack, Index slice, const Point2& center, double a, double b);

/// No contours on `count` slices at distance 1.
ContourStack EmptyStack(Index count);

/// The z-slices of a text, see TextContours.h; slices are the planes in it.
ContourStack ParseStack(const std::string& text);

/// Pieces as contours on the given planes, in ascending order.
ContourStack StackOf(const Pieces& pieces, const std::vector<double>& planes);

/// Pairs of contours, for comparison and messages: {0, 3}.
using ContourPairs = std::vector<std::pair<Index, Index>>;

/// First and Second of the correspondences with the given Passage, in their order.
ContourPairs PairsOf(const std::vector<Correspondence>& pairs, Passage where = Passage::Across);

/// What FindCorrespondences() finds across, in its order.
ContourPairs FindPairs(CorrespondenceCriterion criterion, const ContourStack& stack,
  const PriorKnowledge& known = PriorKnowledge());

} // namespace support
} // namespace orthoslices

#endif
