// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTriangleAdjacency_h
#define OrthoSlicesTriangleAdjacency_h

#include "Core/Base/Types.h"

#include <vector>

/**
 * Triangles in the plane that know their neighbours, and the changes that all triangulations are
 * made of. They are combinatorial: where points lie, and so what may be changed, is for the caller
 * to decide.
 */
namespace orthoslices
{
/// A triangle, counter-clockwise.
struct LinkedTriangle
{
  std::array<Index, 3> Corners; ///< numbers of points
  std::array<Index, 3>
    Neighbors; ///< across the side from each corner to the next; -1 at the border

  /// The place of a corner that the triangle has.
  int CornerOf(Index point) const
  {
    return this->Corners[0] == point ? 0 : this->Corners[1] == point ? 1 : 2;
  }
  /// The side to a neighbour that the triangle has.
  int SideTo(Index neighbor) const
  {
    return this->Neighbors[0] == neighbor ? 0 : this->Neighbors[1] == neighbor ? 1 : 2;
  }
};

/// The side of a triangle from corner number Side to the next.
struct TriangleSide
{
  Index Triangle;
  int Side;
};

/// Triangles, numbered, that are each other's neighbours.
class TriangleAdjacency : private std::vector<LinkedTriangle>
{
public:
  using std::vector<LinkedTriangle>::begin;
  using std::vector<LinkedTriangle>::clear;
  using std::vector<LinkedTriangle>::empty;
  using std::vector<LinkedTriangle>::end;
  using std::vector<LinkedTriangle>::push_back;
  using std::vector<LinkedTriangle>::resize;
  using std::vector<LinkedTriangle>::size;
  using std::vector<LinkedTriangle>::operator[];

  Index StartOf(const TriangleSide& side) const
  {
    return (*this)[side.Triangle].Corners[side.Side];
  }
  Index EndOf(const TriangleSide& side) const
  {
    return (*this)[side.Triangle].Corners[(side.Side + 1) % 3];
  }
  /// The corner opposite to the side.
  Index ApexOf(const TriangleSide& side) const
  {
    return (*this)[side.Triangle].Corners[(side.Side + 2) % 3];
  }
  /// The triangle across the side, -1 at the border.
  Index NeighborOf(const TriangleSide& side) const
  {
    return (*this)[side.Triangle].Neighbors[side.Side];
  }
  /// The side as one of the triangle across it. REQUIRES: it is not at the border.
  TriangleSide BackOf(const TriangleSide& side) const
  {
    const Index other = this->NeighborOf(side);
    return { other, (*this)[other].CornerOf(this->EndOf(side)) };
  }
  /// Lets a triangle, if there is one, have another neighbour in the place of the former one.
  void Relink(Index triangle, Index from, Index to)
  {
    if (triangle >= 0)
    {
      LinkedTriangle& t = (*this)[triangle];
      t.Neighbors[t.SideTo(from)] = to;
    }
  }

  /**
   * Replaces the side ab between triangles abc and bad by the other diagonal. They become adc and
   * dbc, in this order of corners, with the numbers they had. REQUIRES: the side is not at the
   * border; for triangles that stay counter-clockwise, adbc is strictly convex.
   */
  void Flip(const TriangleSide& side);

  /**
   * Divides a triangle abc into abp, with its number, and, with new ones, bcp and cap. Side 0 of
   * each of them is a side of the former triangle.
   */
  void Divide(Index triangle, Index point);

  /**
   * Divides the triangles abc and bad at a point m of their common side: into cam and adm, with
   * their numbers, and, with new ones, bcm and dbm. REQUIRES: the side is not at the border.
   */
  void Split(const TriangleSide& side, Index point);

private:
  /// The quadrilateral adbc around a side ab: corners and the triangles behind its sides.
  struct Diamond
  {
    Index One, Two; ///< the triangles abc and bad
    Index A, B, C, D;
    Index BC, CA, AD, DB;
  };
  Diamond DiamondAround(const TriangleSide& side) const;
};
}

#endif
