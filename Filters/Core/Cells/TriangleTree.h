// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTriangleTree_h
#define OrthoSlicesTriangleTree_h

#include "Core/Cells/FindContacts.h"

#include <functional>
#include <vector>

namespace orthoslices
{
/**
 * Tells which of many triangles may meet another one, for cells with thousands of them: a binary
 * tree of boxes that are turned the way most of their triangles lie. Between two slices with many
 * vertices triangles are long and thin, side by side, and slanted; boxes along the axes would
 * overlap those of a great part of the others. Time to build it, and to ask for all triangles,
 * grows as n log n where triangles do not cross.
 */
class TriangleTree
{
public:
  /// The triangles have to outlive this, and to stay in their places.
  explicit TriangleTree(const std::vector<PatchTriangle>& triangles);

  /// Whether triangles of two patches are of interest.
  using PatchFilter = std::function<bool(Index patch, Index other)>;

  /// Writes, ascending, the numbers of those triangles after this one whose boxes meet its own.
  /// What is left out does not touch it, beyond rounding, or is not of interest.
  void FindAfter(Index triangle, const PatchFilter& isWanted, std::vector<Index>& found) const;

private:
  /// A box by its axes, which are unit vectors at right angles, and where it ends along them.
  struct TurnedBox
  {
    std::array<Point3, 3> Axes;
    Point3 Low, High;
  };
  struct Node
  {
    TurnedBox Around;
    Index First, Last;  ///< of Order
    Index Left, Right;  ///< nodes; -1 in leaves
    Index LastTriangle; ///< the greatest number in it
    Index Patch;        ///< of all of its triangles; -1 if they are of several
  };

  Point3 Corner(Index triangle, int i) const;
  std::array<Point3, 3> ChooseAxes(Index first, Index last) const;
  TurnedBox Enclose(Index first, Index last) const;
  Index Build(Index first, Index last);
  bool MayMeet(Index triangle, const TurnedBox& other) const;

  const std::vector<PatchTriangle>& Triangles;
  Point3 Origin{};     ///< so that few digits are lost far from that of the world
  double Margin = 0.0; ///< around all boxes, far above rounding
  std::vector<Index> Order;
  std::vector<TurnedBox> OfTriangle;
  std::vector<Node> Nodes;
};
}

#endif
