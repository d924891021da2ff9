// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCornerTable_h
#define OrthoSlicesCornerTable_h

#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/**
 * A closed oriented triangle surface that can be changed locally without ever losing its topology
 * (corner table after J. Rossignac, A. Safonova and A. Szymczak, "3D Compression Made Simple",
 * 2001). Combinatorial: where points lie is for the caller to decide.
 *
 * Corner 3 t + i is the place of vertex number i in triangle t; the *edge of a corner* is the one
 * opposite to it, and the triangle across that edge has the corner OppositeOf(corner). Edges may be
 * marked as curves on the surface: such an edge is never flipped, and a collapse never joins what
 * the curves keep apart.
 */
class CornerTable
{
public:
  /// REQUIRES: a closed oriented 2-manifold without double edges, or a part of one, where each edge
  /// with one triangle only has no opposite corner (-1), and nothing may be asked about its ends that
  /// turns around them; points are numbered from 0.
  CornerTable(Index points, const std::vector<std::array<Index, 3>>& triangles);

  /// A table without opposite corners, of which nothing may be asked but the corners of triangles,
  /// and which edges are curves.
  static CornerTable WithoutLinks(Index points, const std::vector<std::array<Index, 3>>& triangles);

  Index CornerCount() const { return static_cast<Index>(this->Vertex.size()); }
  Index PointCount() const { return static_cast<Index>(this->Corner.size()); }
  /// Whether the triangle of the corner is still there.
  bool IsAlive(Index corner) const { return this->Vertex[corner] >= 0; }
  bool IsUsed(Index vertex) const { return this->Corner[vertex] >= 0; }
  /// A corner at a vertex that is used.
  Index CornerAt(Index vertex) const { return this->Corner[vertex]; }

  static Index Next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static Index Previous(Index corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }
  Index VertexOf(Index corner) const { return this->Vertex[corner]; }
  Index OppositeOf(Index corner) const { return this->Opposite[corner]; }
  /// The ends of a corner's edge, in the direction of its triangle.
  Index StartOf(Index corner) const { return this->Vertex[Next(corner)]; }
  Index EndOf(Index corner) const { return this->Vertex[Previous(corner)]; }
  bool IsCurve(Index corner) const { return this->Curve[corner] != 0; }
  /// Marks the edge of a corner, on both of its sides.
  void MarkCurve(Index corner);

  /// Calls visit(corner) for the corners at a vertex, counter-clockwise, seen from outside.
  template <typename Visit>
  void ForCornersAt(Index vertex, Visit&& visit) const
  {
    const Index first = this->Corner[vertex];
    Index corner = first;
    do
    {
      visit(corner);
      corner = Next(this->Opposite[Next(corner)]);
    } while (corner != first);
  }
  Index Valence(Index vertex) const;
  /// The corner whose edge joins two vertices, or -1. Time grows with the valence of `from`.
  Index FindEdge(Index from, Index to) const;
  /// Whether an edge joins two vertices. Time grows with the smaller of their valences.
  bool AreAdjacent(Index a, Index b) const;

  /**
   * Whether the start of a corner's edge may be moved into its end: the surface remains a manifold
   * of the same topology (the link condition of T. K. Dey et al., 1999), and curves keep theirs. A
   * vertex of curves may only move along a curve that neither ends nor branches there.
   */
  bool CanCollapse(Index corner) const;
  void Collapse(Index corner);

  /// Whether the edge can be replaced by the other diagonal of its two triangles.
  bool CanFlip(Index corner) const;
  void Flip(Index corner);

  /// Puts a new vertex on the edge of a corner and returns it.
  Index Split(Index corner);

  /// Makes room for points and triangles, which are not there until they are put in.
  void Grow(Index points, Index triangles);
  /// Puts a triangle in the place of another one, by its vertices and whether its edges are curves.
  /// The table has no opposite corners from then on, see WithoutLinks.
  void Put(Index triangle, const std::array<Index, 3>& vertices,
    const std::array<std::uint8_t, 3>& curves);
  void TakeOut(Index triangle);

  /// The triangles that are left.
  std::vector<std::array<Index, 3>> ListTriangles() const;

private:
  CornerTable() = default;
  void SetTriangles(Index points, const std::vector<std::array<Index, 3>>& triangles);
  void LinkTriangles();
  void Link(Index corner, Index opposite);
  void SetTriangle(Index triangle, Index a, Index b, Index c);
  Index CountCurves(Index vertex) const;
  Index CountCommonNeighbors(Index start, Index end) const;

  std::vector<Index> Vertex, Opposite;
  std::vector<std::uint8_t> Curve;
  std::vector<Index> Corner; ///< one at each vertex; -1 if there is none
};
}

#endif
