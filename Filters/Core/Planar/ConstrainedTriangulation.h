// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesConstrainedTriangulation_h
#define OrthoSlicesConstrainedTriangulation_h

#include "Core/Base/Predicates.h"
#include "Core/Planar/TriangleAdjacency.h"

#include <vector>

namespace orthoslices
{
/// A part of the plane, on the left of disjoint simple rings through numbered nodes.
struct PlaneRegion
{
  std::vector<Index> Next, Previous; ///< of each node: on its ring; -1 if it is on no ring
  std::vector<std::int8_t> Level;    ///< of each node: level of the ring's side to the next node

  /// The whole plane, as long as no side is added.
  explicit PlaneRegion(std::size_t nodes)
    : Next(nodes, -1)
    , Previous(nodes, -1)
    , Level(nodes, 0)
  {
  }

  /// Adds a side of a ring; false if one of the nodes had such a side already.
  bool Add(Index from, Index to, int level)
  {
    const bool isFree = this->Next[from] < 0 && this->Previous[to] < 0;
    this->Next[from] = to;
    this->Previous[to] = from;
    this->Level[from] = static_cast<std::int8_t>(level);
    return isFree;
  }
};

/**
 * Constrained Delaunay triangulation of nodes in the plane: it joins what lies opposite each other.
 * Nodes come one after another, edges are swapped until the circles are empty (C. L. Lawson,
 * "Software for C1 Surface Interpolation", 1977) and the borders of two regions are in (S. W.
 * Sloan, "A Fast Algorithm for Generating Constrained Delaunay Triangulations", 1993).
 *
 * Where nodes lie is decided exactly, so that all triangles are counter-clockwise and rounding may
 * at most leave an edge that is not the best one.
 */
class ConstrainedTriangulation
{
public:
  /// The level of nodes that are on both.
  static constexpr std::int8_t OnBothLevels = 2;

  /**
   * REQUIRES: at least one place, no two equal; the sides of the regions meet in nodes only. Each
   * node has a level, 0, 1 or OnBothLevels: of two diagonals that are equally good, one that joins
   * nodes of one level is not taken. The regions have to outlive this.
   */
  ConstrainedTriangulation(const std::vector<Point2>& places,
    const std::vector<std::int8_t>& levels, const std::array<PlaneRegion, 2>& regions);

  /// `order` has all nodes, along rings, and may repeat some. Returns false, and leaves nothing to
  /// be got, if the regions have no proper border, overlap, or are not bounded.
  bool Run(const std::vector<Index>& order);

  /// The triangles of each region, their neighbours numbered within it; -1 behind its border.
  std::array<TriangleAdjacency, 2> GetRegions() const;

private:
  bool IsBorder(Index a, Index b) const;
  bool IsFlat(Index a, Index b) const
  {
    return this->Levels[a] == this->Levels[b] && this->Levels[a] != OnBothLevels;
  }
  int Side(Index a, Index b, Index c) const
  {
    return SideOf(this->Places[a], this->Places[b], this->Places[c]);
  }
  bool IsBetter(Index a, Index b, Index c, Index d) const;
  void SetStarts(Index triangle);
  bool CanSwap(const TriangleSide& edge) const;
  void Swap(const TriangleSide& edge);
  void Improve(bool withBorders);
  Index Find(Index node, Index near) const;
  bool AddNode(Index node, Index near);
  bool AddNodes(const std::vector<Index>& order);
  bool FindAround(Index a, Index b, TriangleSide& crossed) const;
  bool FindEdge(Index a, Index b, TriangleSide& found) const;
  bool AddBorder(Index a, Index b);
  bool FillRegions();

  std::vector<Point2> Places; ///< three of a triangle around all are added
  std::vector<std::int8_t> Levels;
  const std::array<PlaneRegion, 2>& Regions;
  const Index Nodes;
  TriangleAdjacency Triangles;
  std::vector<Index> Start;           ///< of each node: one of its triangles; -1 before it is added
  std::vector<std::int8_t> RegionOf;  ///< of each triangle: 0, 1, or -1 outside both
  std::vector<TriangleSide> Doubtful; ///< edges that may not be the best ones
};
}

#endif
