// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesOverlayGraph_h
#define OrthoSlicesOverlayGraph_h

#include "Core/Base/Contours.h"
#include "Core/Planar/ConstrainedTriangulation.h"
#include "Core/Planar/SegmentTree.h"
#include "Core/Slabs/OverlaySlab.h"

#include <vector>

namespace orthoslices
{
/**
 * The plane graph of the contours of two slices, seen along the axis: its nodes are the vertices of
 * all loops, loop after loop, and then the crossings of lower with upper loops; its edges are what
 * these leave of the loops' segments.
 */
class OverlayGraph
{
public:
  /// The upper loops are overlaid after subtracting `shift` and adding `displacement`. The loops
  /// have to outlive this.
  OverlayGraph(const std::vector<SlabLoop>& loops, const Point2& shift, const Point2& displacement);

  /// Finds the crossings and splits the loops there. False if loops touch, if those of one slice
  /// cross, or if rounding the crossings did not leave a plane graph; this is decided exactly.
  bool Build();

  /// What is inside below only, and what is inside above only. False if the loops are not
  /// consistently nested. REQUIRES: Build succeeded.
  bool FindRegions(std::array<PlaneRegion, 2>& regions) const;

  const std::vector<Point2>& GetPlaces() const { return this->Places; }
  /// The level of each node, 0 or 1, and ConstrainedTriangulation::OnBothLevels for crossings.
  const std::vector<std::int8_t>& GetLevels() const { return this->OnLevel; }
  /// The nodes along the loops, loop after loop; crossings are on two of them.
  const std::vector<Index>& GetOrder() const { return this->Parts.Numbers; }
  /// The vertices that the crossings add to the loops, as in SlabOverlay.
  const std::vector<SlabOverlay::Insertion>& GetInsertions() const { return this->Insertions; }
  /// How many nodes are vertices of loops; those from here on are crossings.
  Index CountVertices() const { return this->Vertices; }
  bool IsCrossing(Index node) const { return node >= this->Vertices; }
  /// The corner of the surface, numbered as in SlabOverlay, at a node of a level.
  Index CornerAt(Index node, int level) const
  {
    return this->IsCrossing(node) ? this->CrossingAt(node).Corner[level] : node;
  }

private:
  /// Where a segment of a lower and a segment of an upper loop cross; in pairs, lower one first.
  struct Crossing
  {
    std::array<Index, 2> Segment; ///< numbers of the vertices that they start from
    std::array<double, 2> Share;  ///< of their lengths up to the crossing
    std::array<Index, 2> Corner;  ///< of the result: the two new vertices
    bool ToLeft;                  ///< the upper loop passes to the left of the lower one
  };
  /// The loops as split by the crossings, in the form that SegmentTree takes.
  struct Chains
  {
    Contours Nodes;
    std::vector<Index> Numbers; ///< of the nodes

    std::array<Index, 2> Ends(const SegmentTree::Segment& segment) const
    {
      return { this->Numbers[segment.Vertex],
        this->Numbers[this->After(segment.Contour, segment.Vertex)] };
    }
    Index After(Index chain, Index vertex) const
    {
      return vertex + 1 < this->Nodes.Offsets[chain + 1] ? vertex + 1 : this->Nodes.Offsets[chain];
    }
  };

  Crossing& CrossingAt(Index node) { return this->Crossings[node - this->Vertices]; }
  const Crossing& CrossingAt(Index node) const { return this->Crossings[node - this->Vertices]; }
  void AddNode(Chains& chains, Index node) const;
  void EndChain(Chains& chains, const SlabLoop& loop) const;
  std::vector<Index> LoopsAt(bool upper) const;

  bool FindCrossings();
  bool AddCrossing(const std::array<Index, 2>& lower, const std::array<Index, 2>& upper);
  bool SplitLoops();
  bool IsSimple() const;
  bool AreApart(const std::array<Index, 2>& s, const std::array<Index, 2>& t) const;
  bool IsProper(Index node, const std::vector<Index>& next, const std::vector<Index>& before) const;
  bool AddChain(Index chain, const SegmentTree& others, std::array<PlaneRegion, 2>& regions) const;

  const std::vector<SlabLoop>& Loops;
  Index Vertices = 0;
  std::vector<Point2> Places;
  std::vector<std::int8_t> OnLevel;
  Chains Whole, Parts; ///< the loops before and after they are split
  std::vector<Crossing> Crossings;
  std::vector<SlabOverlay::Insertion> Insertions;
};
}

#endif
