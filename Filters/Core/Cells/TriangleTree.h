// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTriangleTree_h
#define OrthoSlicesTriangleTree_h

#include "Core/Base/Predicates.h"
#include "Core/Cells/FindContacts.h"

#include <vector>

namespace orthoslices
{
/**
 * Tells which of many triangles may meet another one, for cells with thousands of them: a binary
 * tree of rectangles that are turned the way most of their triangles lie. Between two slices with
 * many vertices triangles are long and thin, side by side, and slanted; boxes along the axes would
 * overlap those of a great part of the others. All is seen along the axis along which triangles
 * reach farthest through the cell, so along that of the slices. Time to build it, and to ask for all
 * triangles, grows as n log n where triangles do not cross.
 */
class TriangleTree
{
public:
  /// The triangles have to outlive this, and to stay in their places.
  explicit TriangleTree(const std::vector<PatchTriangle>& triangles);

  /// Writes, ascending, the numbers of those triangles after this one whose rectangles meet its own.
  /// What is left out does not touch it, beyond rounding.
  void FindAfter(Index triangle, std::vector<Index>& found) const;

private:
  /// A rectangle; U is its direction, the sides are at distances from the origin along U and across.
  struct Rectangle
  {
    Point2 U;
    Point2 Low, High;
  };
  struct Node
  {
    Rectangle Around;
    Index First, Last;  ///< of Order
    Index Left, Right;  ///< nodes; -1 in leaves
    Index LastTriangle; ///< the greatest number in it
  };

  void ChooseAxis();
  Point2 Corner(Index triangle, int i) const;
  Rectangle Frame(Index first, Index last) const;
  Index Build(Index first, Index last);
  bool MayMeet(Index triangle, const Rectangle& other) const;

  const std::vector<PatchTriangle>& Triangles;
  int Axis = 2;        ///< seen along this one
  Point2 Origin{};     ///< so that few digits are lost far from that of the world
  double Margin = 0.0; ///< around all rectangles, far above rounding
  std::vector<Index> Order;
  std::vector<Rectangle> OfTriangle;
  std::vector<Node> Nodes;
};
}

#endif
