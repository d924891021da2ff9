// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSegmentTree_h
#define OrthoSlicesSegmentTree_h

#include "Core/Base/Contours.h"

#include <functional>
#include <vector>

namespace orthoslices
{
/**
 * Bounding boxes over the segments of the contours of one slice, as a binary tree in the order of
 * the contours. Consecutive segments lie close together, so no sorting is needed: built in linear
 * time, and for ordinary contours queries touch only a few boxes.
 */
class SegmentTree
{
public:
  /// The contours listed in `members` have to lie on one slice.
  SegmentTree(const Contours& contours, std::vector<Index> members);

  /// Segment from Vertex to the next vertex of the Contour.
  struct Segment
  {
    Index Contour;
    Index Vertex;
  };

  /// Calls `visit` for every two segments whose bounding boxes overlap and that share no vertex.
  void VisitOverlaps(const std::function<void(Segment, Segment)>& visit) const;

  /// Calls `visit` for every segment whose bounding box the ray from (u, v) towards +u meets.
  void VisitAlongU(double u, double v, const std::function<void(Segment)>& visit) const;

  /// How many segments of other contours than `contour` the ray from (u, v) towards +v crosses.
  Index CountAbove(double u, double v, Index contour) const;

private:
  struct Box
  {
    double LowU, LowV, HighU, HighV;
  };
  struct Run ///< consecutive segments of one contour
  {
    Index Contour, First, Last;
  };
  struct Node
  {
    std::size_t Level, Number;
  };

  bool IsValid(Node node) const { return node.Number < this->Boxes[node.Level].size(); }
  const Box& BoxOf(Node node) const { return this->Boxes[node.Level][node.Number]; }
  Index NextVertex(Index contour, Index vertex) const;
  Box BoxOfSegment(Index contour, Index vertex) const;
  void AddRuns(Index contour);
  void AddLevels();
  void VisitWithin(Node node, const std::function<void(Segment, Segment)>& visit) const;
  void VisitBetween(Node a, Node b, const std::function<void(Segment, Segment)>& visit) const;
  void VisitRuns(
    const Run& a, const Run& b, const std::function<void(Segment, Segment)>& visit) const;
  void VisitAlongU(Node node, double u, double v, const std::function<void(Segment)>& visit) const;
  Index CountAbove(Node node, double u, double v, Index contour) const;
  Index CountAboveInRun(const Run& run, double u, double v) const;

  const Contours& Source;
  std::vector<Run> Runs;
  std::vector<std::vector<Box>> Boxes; ///< level 0: one for each run; each next level: pairs
};
}

#endif
